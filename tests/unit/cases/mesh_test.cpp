// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A jar from an STL file: reading it, and every kind of faulty file.
#include <gtest/gtest.h>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/file/mesh_file.hpp"
#include "mahlwerk/cases/file/stl.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/setup/fill.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "meshes.hpp"
#include "sample.hpp"
#include "statement.hpp"

namespace mahlwerk::cases::mesh_test {
namespace {

using namespace sample;
using geometry::Mesh;
using tests::binary_stl;
using tests::box;
using tests::Triangles;

const std::string meshed = R"([mill]
kind = "tumbling"
speed = "60 rpm"
[jar]
kind = "mesh"
file = "jar.stl"
unit = "mm"
[[balls]]
count = 3
diameter = "8 mm"
density = "7850 kg/m3"
[run]
engine = "soft"
time = "1 s"
)";

Case read_with(const std::string& stl, const std::string& text = meshed) {
  const Folder folder;
  folder.write("jar.stl", stl);
  folder.write("case.toml", text);
  return read(folder.path() / "case.toml", catalogue());
}

/// The only fault, without the name of the folder: "what|remedy|code".
std::string fault_with(const std::string& stl, const std::string& text = meshed) {
  const Folder folder;
  folder.write("jar.stl", stl);
  folder.write("case.toml", text);
  std::string all;
  try {
    read(folder.path() / "case.toml", catalogue());
  } catch (const InputError& error) {
    for (const Fault& f : error.faults())
      all += (all.empty() ? "" : "\n") + f.what + "|" + f.remedy + "|" + f.code;
  }
  const std::string name = (folder.path() / "").generic_string();
  for (auto at = all.find(name); at != std::string::npos; at = all.find(name))
    all.erase(at, name.size());
  return all;
}

const Mesh& mesh_in(const Case& c) {
  return std::get<Mesh>(*c.jar.shape);
}

std::string as_text(const Triangles& t) {
  Triangles mm = t;
  for (geometry::Corners& c : mm)
    for (Vec3& p : c) p *= 1000;
  return stl_text(geometry::weld(mm));
}

Triangles moved(Triangles t, const Vec3& way) {
  for (geometry::Corners& c : t)
    for (Vec3& p : c) p += way;
  return t;
}
Triangles flipped(Triangles t) {
  for (geometry::Corners& c : t) std::swap(c[0], c[1]);
  return t;
}
Triangles both(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Triangles brick = box(0.03, 0.04, 0.05);

TEST(MeshFile, binary_and_text_are_the_same_jar) {
  const Case binary = read_with(binary_stl(brick)), text = read_with(as_text(brick));
  tests::states("volume [m3]", mesh_in(text).volume(), 6e-5, 1e-18, "sides of the brick");
  tests::states("volume [m3]", mesh_in(binary).volume(), 6e-5, 6e-5 * 3e-7, "floats of the file");
  EXPECT_EQ(mesh_in(text).faces, 6);
  EXPECT_EQ(text.jar.mesh, (MeshFile{"jar.stl", "mm", false}));
  EXPECT_EQ(face_names(*text.jar.shape).front(), "1");
  const std::string last = "jar.6";
  EXPECT_EQ(pair_selector(last, text).faces, std::vector<int>{5});
  EXPECT_EQ(pair_selector("jar", text).faces.size(), 6U);
  std::string loud = as_text(brick);
  for (char& c : loud) c = static_cast<char>(std::toupper(c));
  EXPECT_EQ(mesh_in(read_with(loud)), mesh_in(text));
}

TEST(MeshFile, a_case_with_a_mesh_that_was_written_reads_as_the_same) {
  const std::string stl = as_text(brick);
  const Folder folder;
  folder.write("jar.stl", stl);
  const Case c = read_text(meshed, folder.path() / "case.toml", catalogue());
  EXPECT_EQ(read_text(write(c), folder.path() / "case.toml", catalogue()), c);
}

TEST(MeshFile, centre_moves_the_middle_of_the_extent_to_the_origin) {
  const std::string far = binary_stl(moved(brick, {1, 2, 3}));
  const std::string centred = with(meshed, "unit", "unit = \"mm\"\norigin = \"centre\"");
  const Case c = read_with(far, centred);
  EXPECT_NEAR(norm(mesh_in(c).extent().middle()), 0, 1e-15);
  EXPECT_EQ(fault_with(far),
            "the origin of the file lies outside the jar, 3.742 m from the middle of its extent|"
            "write origin = \"centre\" to turn the jar about that middle, or origin = \"file\" if "
            "the mill's axis is meant to pass there|origin-outside");
  const Case said = read_with(far, with(meshed, "unit", "unit = \"mm\"\norigin = \"file\""));
  EXPECT_NEAR(mesh_in(said).extent().middle().z, 3, 1e-6);
}

TEST(MeshFile, crease_angle_divides_the_wall) {
  const std::string round = binary_stl(tests::cylinder(24, 0.04, 0.04));
  EXPECT_EQ(mesh_in(read_with(round)).faces, 3);
  EXPECT_EQ(
      mesh_in(read_with(round, with(meshed, "unit", "unit = \"mm\"\ncrease_angle = \"10 deg\"")))
          .faces,
      26);
}

TEST(MeshFile, what_is_missing_is_asked_for) {
  EXPECT_EQ(fault_with(binary_stl(brick), with(meshed, "unit", "")),
            "[jar] lacks `unit`: the unit of the file's numbers, as mesh files have none|write "
            "for instance unit = \"mm\"|missing-value");
  EXPECT_EQ(fault_with(binary_stl(brick), with(meshed, "file", "")),
            "[jar] lacks `file`: the jar's inner surface|write for instance file = "
            "\"my-mesh.stl\"|missing-value");
  EXPECT_EQ(
      fault_with(binary_stl(brick), with(meshed, "file", "file = \"no.stl\"")),
      "the mesh file no.stl cannot be read|give its path relative to the case file|no-such-file");
  EXPECT_EQ(fault_with(binary_stl(brick), with(meshed, "file", "file = \".\"")),
            "the mesh file . cannot be read|give its path relative to the case file|no-such-file");
  EXPECT_EQ(fault_with(binary_stl(brick), with(meshed, "unit", "unit = \"kg\"")).substr(0, 11),
            "unit = \"kg\"");
}

TEST(MeshFile, files_that_are_no_stl_say_why) {
  const std::string remedy =
      "|export the surface again as STL, OBJ or PLY, with fewer triangles if they are too "
      "many|bad-mesh-file";
  const std::string binary = binary_stl(brick);
  EXPECT_EQ(fault_with(""), "jar.stl: it is empty" + remedy);
  EXPECT_EQ(
      fault_with("hello"),
      "jar.stl: it is not an STL file: neither the length of a binary one nor "
      "the words of an ASCII one (OBJ files are known by their ending .obj, PLY files by their "
      "first word)" +
          remedy);
  EXPECT_EQ(fault_with(binary.substr(0, binary.size() - 60)),
            "jar.stl: its header gives 16 triangles, and it ends in triangle 15" + remedy);
  EXPECT_EQ(fault_with(binary + "more"),
            "jar.stl: it is not an STL file: neither the length of a binary one "
            "nor the words of an ASCII one (OBJ files are known by their ending .obj, PLY files by "
            "their first word)" +
                remedy);
  const std::string text = as_text(brick);
  EXPECT_EQ(fault_with(text.substr(0, text.size() / 2)).substr(0, 22), "jar.stl: it is cut off");
  EXPECT_EQ(fault_with("solid\nfacet\nvertex 1 2 nan\n"),
            "jar.stl: \"nan\" in line 3 is not a number" + remedy);
  EXPECT_EQ(fault_with("solid\nfacet\nvertex 1 2 3\nvertex 1 2 4\nendfacet\nendsolid"),
            "jar.stl: the facet that ends in line 5 has 2 corners" + remedy);
  EXPECT_EQ(fault_with("solid nothing\nendsolid"), "jar.stl: it has no triangles" + remedy);
  Triangles bad = brick;
  bad[4][1].y = NAN;
  EXPECT_EQ(fault_with(binary_stl(bad)),
            "jar.stl: triangle 5 has a coordinate that is not a number" + remedy);
  std::string huge(84 + 50, '\0');
  huge[83] = 0x10;
  EXPECT_EQ(fault_with(huge),
            "jar.stl: its header gives 268435456 triangles, and it ends in triangle 2" + remedy);
}

TEST(MeshFile, surfaces_that_enclose_nothing_say_why) {
  Triangles open = brick;
  open.pop_back();
  EXPECT_EQ(fault_with(binary_stl(open)),
            "jar.stl: the surface is open: 3 edges belong to one triangle only, one at (0, -20, "
            "-25) mm|close the holes: draw the inner volume as a solid and export that|open-mesh");
  EXPECT_EQ(
      fault_with(binary_stl(both(brick, {brick[0], flipped({brick[0]})[0]}))),
      "jar.stl: at 3 edges more than two triangles meet, at (15, 0, -25) mm for instance|join "
      "the parts to one solid before exporting, without inner walls|crowded-mesh");
  Triangles twisted = brick;
  std::swap(twisted[0][0], twisted[0][1]);
  EXPECT_EQ(fault_with(binary_stl(twisted)),
            "jar.stl: at 3 edges neighbours disagree which side is outside, at (15, 0, -25) mm for "
            "instance|let the CAD program orient all normals outwards|twisted-mesh");
  EXPECT_EQ(fault_with(binary_stl(both(brick, moved(brick, {0.1, 0, 0})))),
            "jar.stl: the surface has 2 parts that are not connected, the second at (115, -20, "
            "-25) mm|export the inner volume alone, as one solid: without the jar's outside and "
            "loose parts|several-meshes");
  EXPECT_EQ(fault_with(binary_stl(flipped(brick))),
            "jar.stl: the surface is inside out: its normals point into the jar|draw the inner "
            "volume as a solid, or flip all normals and export again|mesh-inside-out");
}

TEST(MeshFile, faults_are_told_also_where_frames_are_wanted) {
  const std::string framed = meshed + "[observe]\nframes = \"10 ms\"\n";
  EXPECT_NE(fault_with("", framed).find("|bad-mesh-file"), std::string::npos);
  const std::string other = with(framed, "file", "file = \"nope.stl\"");
  EXPECT_NE(fault_with("", other).find("|no-such-file"), std::string::npos);
}

TEST(MeshFile, a_size_that_cannot_be_meant_asks_for_the_unit) {
  EXPECT_EQ(fault_with(binary_stl(brick), with(meshed, "unit", "unit = \"m\"")),
            "the jar is 50 m wide: is the unit m?|give the unit the file was drawn in; jars are "
            "from 1 mm to 10 m wide|mesh-size");
  EXPECT_EQ(fault_with(binary_stl(brick), with(meshed, "unit", "unit = \"um\"")),
            "the jar is 50 um wide: is the unit um?|give the unit the file was drawn in; jars are "
            "from 1 mm to 10 m wide|mesh-size");
}

TEST(MeshFile, more_triangles_than_there_is_memory_for_are_refused) {
  std::string head(84, '\0');
  const std::size_t count = max_triangles + 1;
  for (std::size_t k = 0; k < 4; ++k) head[80 + k] = static_cast<char>(count >> 8 * k & 0xff);
  head.resize(84 + 50 * count);
  try {
    read_mesh_file(head, "head.stl", 1);
    ADD_FAILURE() << "taken";
  } catch (const MeshFileError& error) {
    EXPECT_STREQ(error.what(), "it has 4000001 triangles, more than the limit of 4000000");
  }
}

TEST(MeshFile, another_surface_under_the_same_name_is_another_case) {
  const std::string other = binary_stl(tests::box(0.03, 0.03, 0.03));
  const Case one = read_with(binary_stl(brick)), two = read_with(other);
  EXPECT_EQ(input_files_fingerprint(one), input_files_fingerprint(read_with(binary_stl(brick))));
  EXPECT_NE(input_files_fingerprint(one), input_files_fingerprint(two));
}

TEST(MeshFile, the_event_engine_takes_no_mesh) {
  const Case c = read_with(binary_stl(brick), with(meshed, "engine", "engine = \"event\""));
  const std::vector<Fault> found = engine_faults(c);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "jar-needs-soft");
  EXPECT_EQ(found[0].remedy, "write engine = \"soft\", or \"auto\"");
  EXPECT_TRUE(engine_faults(read_with(binary_stl(brick))).empty());
  EXPECT_TRUE(
      engine_faults(read_with(binary_stl(brick), with(meshed, "engine", "engine = \"auto\"")))
          .empty());
}

TEST(MeshFile, a_ball_larger_than_a_hollow_is_warned_of) {
  const std::string round = binary_stl(tests::prism(
      [] {  // two walls with a gutter of radius 3 mm between
        std::vector<Vec3> p{{0.02, 0.02, 0}, {-0.02, 0.02, 0}};
        for (int i = 0; i <= 16; ++i) {
          const double a = 3.14159265358979 * (1 + i / 16.0);
          p.push_back({0.003 * std::cos(a), -0.01 + 0.003 * std::sin(a), 0});
        }
        return p;
      }(),
      0.04));
  EXPECT_EQ(jar_warnings(read_with(round)).size(), 1U);
  EXPECT_EQ(
      jar_warnings(read_with(round))[0].text.substr(0, 94),
      "A ball of radius 4 mm is larger than the smallest concave radius of a smooth face of the "
      "jar, ");
  EXPECT_TRUE(
      jar_warnings(read_with(round, with(meshed, "diameter", "diameter = \"5 mm\""))).empty());
  EXPECT_TRUE(jar_warnings(read_with(binary_stl(brick))).empty());
}

TEST(MeshFile, balls_fill_a_jar_of_any_form) {
  const geometry::AnyShape jar = tests::mesh_of(
      moved(tests::drum_with_lifters(0.2, 0.06, 6, 0.012, 0.008), {0.02, 0.05, 0.4}));
  BallSet set;
  set.diameter = 0.012;
  set.density = 7850;
  for (const double filling : {0.05, 0.35}) {
    const double volume = geometry::volume(jar);
    set.count = static_cast<std::int64_t>(filling * volume / ball_volume(set));
    Random random(2, 1);
    const auto balls = fill(jar, {set}, random);
    ASSERT_EQ(std::ssize(balls), set.count);
    double least = 1, between = 1;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      bool inside = true;
      std::get<Mesh>(jar).near(balls[i].position, 0.02, [&](int, const geometry::Gap& gap) {
        least = std::min(least, gap.distance - 0.006);
        inside = inside && gap.distance > 0;
      });
      ASSERT_TRUE(inside);
      for (std::size_t j = 0; j < i; ++j)
        between = std::min(between, norm(balls[i].position - balls[j].position) - 0.012);
    }
    EXPECT_GT(least, 0);
    EXPECT_GT(between, 0);
  }
}

TEST(MeshFile, a_check_tells_what_the_mesh_is) {
  const Case c = read_with(binary_stl(brick));
  const auto follows = derived_quantities(c);
  const auto named = [&](std::string_view name) {
    return std::ranges::find(follows, name, &DerivedQuantity::name)->value;
  };
  EXPECT_EQ(named("jar_triangles"), 16);
  EXPECT_EQ(named("jar_faces"), 6);
  EXPECT_NEAR(named("jar_volume"), 6e-5, 6e-11);
  EXPECT_NEAR(named("jar_height"), 0.05, 1e-8);
}

}  // namespace
}  // namespace mahlwerk::cases::mesh_test
