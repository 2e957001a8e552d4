// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// STL, OBJ and PLY files of one tetrahedron and of one quadrilateral: all encodings give the same
// triangles, and files that are cut off or lie about themselves say why.
#include <gtest/gtest.h>

#include <bit>
#include <concepts>
#include <string>
#include <type_traits>
#include <vector>

#include "mahlwerk/cases/file/mesh_file.hpp"
#include "mahlwerk/cases/file/stl.hpp"
#include "meshes.hpp"

namespace mahlwerk::cases::mesh_formats_test {
namespace {

using geometry::Corners;
using Triangles = std::vector<Corners>;

const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 2, 0}, z{0, 0, 4}, far{1, 2, 0};
/// Coordinates are small powers of two, so that floats and texts hold them exactly.
const Triangles tetrahedron{{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
const Triangles quadrilateral{{o, x, far}, {o, far, y}};  // a fan from its first corner

/// What reading throws; empty if the file is read.
std::string refusal_of(const std::string& bytes, const std::string& name) {
  try {
    read_mesh_file(bytes, name, 1);
    return "";
  } catch (const MeshFileError& error) {
    return error.what();
  }
}

/// The bytes of a number in this byte order.
template <class T>
std::string bytes_of(T value, bool little) {
  using Bits = std::conditional_t<
      sizeof(T) == 8, std::uint64_t,
      std::conditional_t<sizeof(T) == 4, std::uint32_t,
                         std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
  const auto bits = std::bit_cast<Bits>(value);
  std::string text(sizeof(T), '\0');
  for (std::size_t k = 0; k < sizeof(T); ++k)
    text[little ? k : sizeof(T) - 1 - k] = static_cast<char>(bits >> 8 * k & 0xff);
  return text;
}

// STL

TEST(Stl, binary_and_ascii_are_the_same_triangles) {
  EXPECT_EQ(read_mesh_file(tests::binary_stl(tetrahedron, 1), "a.stl", 1), tetrahedron);
  EXPECT_EQ(read_mesh_file(stl_text(geometry::weld(tetrahedron)), "a.stl", 1), tetrahedron);
  Triangles in_mm = tetrahedron;
  for (Corners& c : in_mm)
    for (Vec3& p : c) p = 0.001 * p;
  EXPECT_EQ(read_mesh_file(tests::binary_stl(tetrahedron, 1), "a.stl", 0.001), in_mm);
}

TEST(Stl, of_fewer_bytes_than_a_header_is_refused) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{80}, std::size_t{83}})
    EXPECT_THROW(read_stl(std::string(size, '\0'), 1), MeshFileError) << size << " bytes";
  EXPECT_EQ(refusal_of(std::string(84, '\0'), "a.stl"), "it has no triangles");
}

TEST(Stl, that_ends_before_its_last_triangle_is_refused) {
  const std::string whole = tests::binary_stl(tetrahedron, 1);
  EXPECT_EQ(refusal_of(whole.substr(0, whole.size() - 1), "a.stl"),
            "its header gives 4 triangles, and it ends in triangle 4");
}

// OBJ

TEST(Obj, is_read_with_normals_textures_groups_and_continued_lines) {
  const std::string text =
      "# a tetrahedron\nmtllib none.mtl\no solid\nv 0 0 0\nv 1 0 0\nv +0 2 0\nv 0 0 4 1.0\n"
      "vt 0 0\nvn 0 0 1\ng faces\nusemtl steel\ns off\n"
      "f 1 3 2\nf 1/1 2/1 4/1\nf 1//1 4//1 3//1 # the third\nf 2/1/1 3/1/1 \\\n4/1/1\n";
  EXPECT_EQ(read_mesh_file(text, "a.obj", 1), tetrahedron);
  EXPECT_EQ(read_mesh_file(text, "A.OBJ", 1), tetrahedron);
}

TEST(Obj, polygon_is_a_fan_from_its_first_corner) {
  EXPECT_EQ(read_mesh_file("v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4\n", "a.obj", 1),
            quadrilateral);
}

TEST(Obj, negative_numbers_count_back_from_the_last_vertex_so_far) {
  EXPECT_EQ(
      read_mesh_file("v 0 0 0\nv 1 0 0\nv 1 2 0\nf -3 -2 -1\nv 0 2 0\nf -4 -2 -1\n", "a.obj", 1),
      quadrilateral);
}

TEST(Obj, corners_that_no_vertex_has_are_refused) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 2 0\n";
  const std::string none =
      "the face in line 4 has a corner that is none of the 3 vertices before it";
  EXPECT_EQ(refusal_of(three + "f 1 2 4\n", "a.obj"), none);
  EXPECT_EQ(refusal_of(three + "f 1 2 -4\n", "a.obj"), none);
  EXPECT_EQ(refusal_of(three + "f 1 2 -9223372036854775808\n", "a.obj"), none);
  EXPECT_EQ(refusal_of(three + "f 1 2 0\n", "a.obj"),
            "\"0\" in line 4 is not the number of a vertex");
  EXPECT_EQ(refusal_of(three + "f 1 2 3.5\n", "a.obj"),
            "\"3.5\" in line 4 is not the number of a vertex");
  EXPECT_EQ(refusal_of(three + "f 1 2 99999999999999999999\n", "a.obj"),
            "\"99999999999999999999\" in line 4 is not the number of a vertex");
  EXPECT_EQ(refusal_of(three + "f 1 2\n", "a.obj"), "the face in line 4 has 2 corners");
  EXPECT_EQ(refusal_of("v 0 0\n", "a.obj"), "\"\" in line 1 is not a number");
  EXPECT_EQ(refusal_of("v 0 0 nan\n", "a.obj"), "\"nan\" in line 1 is not a number");
  EXPECT_EQ(refusal_of(three, "a.obj"), "it has no triangles");
}

// PLY

const std::string vertex_properties = "property float x\nproperty float y\nproperty float z\n";

std::string ply_head(const std::string& format, const std::string& vertices = "4",
                     const std::string& properties = vertex_properties) {
  return "ply\n" + (format.empty() ? "" : "format " + format + "\n") +
         "comment made for a test\nelement vertex " + vertices + "\n" + properties +
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
}
const std::string ply_body = "0 0 0\n1 0 0\n1 2 0\n0 2 0\n4 0 1 2 3\n";

/// The quadrilateral in binary, with a property more of each size.
std::string binary_ply(bool little) {
  std::string text =
      "ply\nformat binary_" + std::string(little ? "little" : "big") +
      "_endian 1.0\nelement vertex 4\nproperty double x\nproperty uchar red\nproperty float z\n"
      "property short s\nproperty double y\nelement strip 1\nproperty list uint float s\n"
      "element face 1\nproperty char c\nproperty list ushort int32 vertex_index\nend_header\n";
  for (const Vec3& p : {o, x, far, y})
    text += bytes_of(p.x, little) + bytes_of(std::uint8_t{200}, little) +
            bytes_of(static_cast<float>(p.z), little) + bytes_of(std::int16_t{-3}, little) +
            bytes_of(p.y, little);
  text += bytes_of(std::uint32_t{2}, little) + bytes_of(1.5F, little) + bytes_of(2.5F, little);
  text += bytes_of(std::int8_t{-1}, little) + bytes_of(std::uint16_t{4}, little);
  for (const std::int32_t corner : {0, 1, 2, 3}) text += bytes_of(corner, little);
  return text;
}

TEST(Ply, ascii_and_binary_of_both_byte_orders_are_the_same_triangles) {
  EXPECT_EQ(read_mesh_file(ply_head("ascii 1.0") + ply_body, "a.ply", 1), quadrilateral);
  EXPECT_EQ(read_mesh_file(binary_ply(true), "a.ply", 1), quadrilateral);
  EXPECT_EQ(read_mesh_file(binary_ply(false), "a.stl", 1), quadrilateral) << "known by its word";
}

TEST(Ply, ascii_with_line_ends_of_windows_is_read) {
  std::string text;
  for (const char c : ply_head("ascii 1.0") + ply_body) text += c == '\n' ? "\r\n" : std::string{c};
  EXPECT_EQ(read_mesh_file(text, "a.ply", 1), quadrilateral);
}

TEST(Ply, without_a_known_format_is_refused) {
  const std::string known =
      ", not \"ascii 1.0\", \"binary_little_endian 1.0\" or \"binary_big_endian 1.0\"";
  EXPECT_EQ(refusal_of(ply_head("") + ply_body, "a.ply"), "its header has no line \"format\"");
  EXPECT_EQ(refusal_of(ply_head("binary 1.0") + ply_body, "a.ply"),
            "its format is \"binary 1.0\"" + known);
  EXPECT_EQ(refusal_of(ply_head("ascii 2.0") + ply_body, "a.ply"),
            "its format is \"ascii 2.0\"" + known);
  EXPECT_EQ(refusal_of(ply_head("ascii") + ply_body, "a.ply"), "its format is \"ascii\"" + known);
  EXPECT_EQ(refusal_of(ply_head("ascii 1.0\nformat ascii 1.0") + ply_body, "a.ply"),
            "its header has two lines \"format\"");
}

TEST(Ply, with_counts_that_its_length_has_no_room_for_is_refused) {
  const std::string many = "1000000000000";
  const std::string refused =
      "its header gives 1000000000000 of the element \"vertex\", more than "
      "its length has room for";
  EXPECT_EQ(refusal_of(ply_head("ascii 1.0", many) + ply_body, "a.ply"), refused);
  EXPECT_EQ(refusal_of(ply_head("binary_little_endian 1.0", many) + ply_body, "a.ply"), refused);
  EXPECT_EQ(refusal_of(ply_head("ascii 1.0", "-4") + ply_body, "a.ply"),
            "its header has an element without a number");
  // The count of a list is held against what is left, too.
  const std::string long_list =
      ply_head("ascii 1.0") + "0 0 0\n1 0 0\n1 2 0\n0 2 0\n" + many + " 0";
  EXPECT_EQ(refusal_of(long_list, "a.ply"), "it is cut off");
  const std::string whole = binary_ply(true);
  EXPECT_EQ(refusal_of(whole.substr(0, whole.size() - 1), "a.ply"), "it is cut off");
}

/// Elements of which one has no number take no bytes: such a count is nothing to go through.
TEST(Ply, with_elements_without_properties_is_read) {
  std::string text = ply_head("ascii 1.0") + ply_body;
  text.insert(text.find("element face"), "element nothing 1000000000000\n");
  EXPECT_EQ(read_mesh_file(text, "a.ply", 1), quadrilateral);
}

TEST(Ply, needs_x_y_and_z_once_each_and_one_list_of_corners) {
  const auto refused = [](const std::string& properties) {
    return refusal_of(ply_head("ascii 1.0", "4", properties) + ply_body, "a.ply");
  };
  EXPECT_EQ(refused("property float x\nproperty float x\nproperty float y\n"),
            "its vertices have several x instead of one each of x, y and z");
  EXPECT_EQ(refused("property float x\nproperty float y\n"),
            "its vertices have no z instead of one each of x, y and z");
  EXPECT_EQ(refused("property float x\nproperty list uchar float y\nproperty float z\n"),
            "its vertices have no y instead of one each of x, y and z");
  std::string other = ply_head("ascii 1.0") + ply_body;
  other.replace(other.find("vertex_indices"), 14, "corner_numbers");
  EXPECT_EQ(refusal_of(other, "a.ply"), "its faces have not one list \"vertex_indices\"");
}

TEST(Ply, corners_that_no_vertex_has_are_refused) {
  const std::string vertices = ply_head("ascii 1.0") + "0 0 0\n1 0 0\n1 2 0\n0 2 0\n";
  EXPECT_EQ(refusal_of(vertices + "3 0 1 4\n", "a.ply"),
            "face 1 has a corner that is none of the 4 vertices before it");
  EXPECT_EQ(refusal_of(vertices + "3 0 1 -1\n", "a.ply"),
            "a corner of face 1 is not a whole number");
  EXPECT_EQ(refusal_of(vertices + "3 0 1 1.5\n", "a.ply"),
            "a corner of face 1 is not a whole number");
  EXPECT_EQ(refusal_of(ply_head("ascii 1.0") + "0 0 nan\n1 0 0\n1 2 0\n0 2 0\n3 0 1 2\n", "a.ply"),
            "vertex 1 has a coordinate that is not a number");
}

}  // namespace
}  // namespace mahlwerk::cases::mesh_formats_test
