// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/vtk_frames.hpp"

#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "mahlwerk/base/base64.hpp"
#include "mahlwerk/base/units.hpp"

namespace mahlwerk::results {
namespace {

constexpr std::uint32_t facets_still = 96, facets_turning = 48;  // fewer for smaller files
constexpr std::string_view list_end = "</Collection>\n</VTKFile>\n";

std::string vtk_head(const char* type, const char* version) {
  const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"{}\" byte_order=\"{}\" "
      "header_type=\"UInt64\">\n",
      type, version, order);
}

template <class Number>
constexpr const char* type_name = std::is_same_v<Number, double> ? "Float64" : "Int32";

/// Inline, uncompressed base64 data, preceded by its length: ParaView of Debian 12 does not read
/// appended data.
template <class Number>
std::string array(const char* name, const std::vector<Number>& values, int components = 1) {
  const std::uint64_t size = values.size() * sizeof(Number);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}"
      "</DataArray>\n",
      type_name<Number>, name, components, base64(bytes));
}

using Doubles = std::vector<double>;
using Integers = std::vector<std::int32_t>;

void add(Doubles& all, const Vec3& a) {
  for (const double x : {a.x, a.y, a.z}) all.push_back(x);
}

/// Cells of `each` points.
std::string cells(const char* kind, const Integers& points, std::int32_t each) {
  Integers ends;
  for (std::int32_t end = each; end <= std::ssize(points); end += each) ends.push_back(end);
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", kind, array("connectivity", points),
                     array("offsets", ends));
}

std::string vtk_piece(std::size_t points, std::size_t verts, std::size_t polys,
                      const std::string& content) {
  return fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n{}</Piece>\n</PolyData>\n</VTKFile>\n",
      points, verts, polys, content);
}

std::string balls_text(const Frame& frame) {
  Doubles places, radii, velocities, spins, forces, orientations;
  Integers numbers, species, points, bodies;
  for (std::size_t i = 0; i < frame.balls.size(); ++i) {
    const scene::Ball& b = frame.balls[i];
    if (b.outside) continue;
    add(places, b.position);
    radii.push_back(b.radius);
    add(velocities, b.velocity);
    add(spins, b.spin);
    species.push_back(b.kind + 1);
    points.push_back(static_cast<std::int32_t>(points.size()));
    numbers.push_back(static_cast<std::int32_t>(i) + 1);
    if (!frame.forces.empty()) add(forces, frame.forces[i]);
    if (frame.bodies.empty()) continue;
    bodies.push_back(frame.bodies[i] + 1);
    const Quaternion& q = b.orientation;
    orientations.insert(orientations.end(), {q.x, q.y, q.z, q.w});
  }
  const std::string content =
      "<PointData Scalars=\"radius\" Vectors=\"velocity\">\n" + array("radius", radii) +
      array("velocity", velocities, 3) + array("spin", spins, 3) +
      (frame.forces.empty() ? "" : array("force", forces, 3)) + array("species", species) +
      array("id", numbers) +
      (frame.bodies.empty() ? "" : array("body", bodies) + array("orientation", orientations, 4)) +
      "</PointData>\n<Points>\n" + array("Points", places, 3) + "</Points>\n" +
      cells("Verts", points, 1);
  const Vec3& c = frame.centre;
  return vtk_head("PolyData", "1.0") +
         fmt::format(
             "<PolyData>\n<FieldData>\n"
             "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
             "format=\"ascii\">{}</DataArray>\n"
             "<DataArray type=\"Float64\" Name=\"jar_centre\" NumberOfComponents=\"3\" "
             "NumberOfTuples=\"1\" format=\"ascii\">{} {} {}</DataArray>\n</FieldData>\n",
             shortest(frame.time), shortest(c.x), shortest(c.y), shortest(c.z)) +
         vtk_piece(points.size(), points.size(), 0, content);
}

}  // namespace

VtkFrames::VtkFrames(std::filesystem::path list, const scene::Chamber& mill, bool still)
    : path_(std::move(list)),
      folder_(std::filesystem::path(path_).replace_extension()),
      mill_(mill),
      still_(still),
      jar_(jar_surface(*mill.shape, still ? facets_still : facets_turning)),
      parts_(part_surfaces(mill)) {
  std::error_code failed;
  std::filesystem::create_directory(folder_, failed);
  errno = failed.value();
  if (!failed) list_.reset(std::fopen(path_.c_str(), "wb"));
  if (!list_) throw cannot_write_frames(path_);
  end_list(vtk_head("Collection", "0.1") + "<Collection>\n");
}

void VtkFrames::add(const Frame& frame) {
  const std::string balls = fmt::format("balls-{:05}.vtp", frames_);
  const std::string jar = fmt::format("jar-{:05}.vtp", still_ ? 0 : frames_);
  write(balls, balls_text(frame));
  if (!still_ || frames_ == 0) write(jar, jar_text(frame));
  const std::string beside = folder_.filename().string(), time = shortest(frame.time);
  constexpr std::string_view entry =
      "<DataSet timestep=\"{}\" part=\"{}\" name=\"{}\" file=\"{}/{}\"/>\n";
  end_list(fmt::format(entry, time, 0, "balls", beside, balls) +
           fmt::format(entry, time, 1, "jar", beside, jar));
  ++frames_;
}

/// All surfaces as one PolyData. Each triangle has the number of its surface.
std::string VtkFrames::jar_text(const Frame& frame) const {
  Doubles places;
  Integers corners, parts;
  std::int32_t part = 0;
  const auto put = [&](const JarMesh& mesh, const Rotation& turn, const Vec3& origin) {
    const auto first = static_cast<std::int32_t>(places.size() / 3);
    for (const Vec3& p : mesh.vertices) results::add(places, origin + turn * p);
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle)
        corners.push_back(first + static_cast<std::int32_t>(corner));
    parts.insert(parts.end(), mesh.triangles.size(), part++);
  };
  const Rotation rotor =
      frame.turn * rotor_turn(*mill_.shape, kinematics::clock(*mill_.motion, frame.time).time);
  for (const JarMesh& mesh : jar_) put(mesh, mesh.rotor ? rotor : frame.turn, {});
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const scene::PartPose pose =
        scene::part_pose(mill_.parts[i].motion, mill_.parts[i].in_laboratory, *mill_.motion,
                         mill_.mount, frame.time);
    put(parts_[i], pose.axes, pose.origin);
  }
  return vtk_head("PolyData", "1.0") + "<PolyData>\n" +
         vtk_piece(places.size() / 3, 0, parts.size(),
                   "<CellData Scalars=\"part\">\n" + array("part", parts) +
                       "</CellData>\n<Points>\n" + array("Points", places, 3) + "</Points>\n" +
                       cells("Polys", corners, 3));
}

void VtkFrames::write(const std::string& name, std::string_view text) const {
  const std::filesystem::path path = folder_ / name;
  errno = 0;
  OpenFile file(std::fopen(path.c_str(), "wb"));
  if (!file || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0)
    throw cannot_write_frames(path);
}

/// Overwrites the old end in a single write, so that the list is always valid XML.
void VtkFrames::end_list(std::string_view entries) {
  const std::string text = std::string(entries) + std::string(list_end);
  errno = 0;
  if (std::fseek(list_.get(), written_, SEEK_SET) != 0 ||
      std::fwrite(text.data(), 1, text.size(), list_.get()) != text.size() ||
      std::fflush(list_.get()) != 0)
    throw cannot_write_frames(path_);
  written_ += static_cast<long>(entries.size());
}

}  // namespace mahlwerk::results
