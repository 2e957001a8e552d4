// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Files that a case or a command names: a mesh, a measured motion, measurements.
#include "mahlwerk/campaign/fit/measurements.hpp"
#include "mahlwerk/cases/file/mesh_file.hpp"
#include "mahlwerk/cases/file/stl.hpp"
#include "mahlwerk/cases/read.hpp"
#include "targets.hpp"

namespace mahlwerk::fuzz {
namespace {

const std::string balls_and_run = R"([[balls]]
count = 1
diameter = "5 mm"
density = "7850 kg/m3"
[run]
time = "1 s"
)";

/// As a jar in a file of STL or PLY, and as OBJ, which only the name of a file tells.
void read_mesh(const std::string& bytes) {
  try {
    cases::read_obj(bytes, 1e-3);
  } catch (const cases::MeshFileError&) {
  }
  write_file(scratch() / "jar.stl", bytes);
  cases::read_text(R"(title = "t"
[mill]
kind = "still"
[jar]
kind = "mesh"
file = "jar.stl"
unit = "mm"
origin = "centre"
)" + balls_and_run,
                   scratch() / "case.toml", catalogue());
}

std::vector<std::string> tetrahedra() {
  const Vec3 o{0, 0, 0}, x{60, 0, 0}, y{0, 60, 0}, z{0, 0, 60};
  const std::vector<geometry::Corners> faces{{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
  std::string binary(80, 's');
  const auto append = [&](const auto& value) {
    binary.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<std::uint32_t>(faces.size()));
  for (const geometry::Corners& face : faces) {
    for (int i = 0; i < 3; ++i) append(0.0F);  // normal
    for (const Vec3& p : face)
      for (const double v : {p.x, p.y, p.z}) append(static_cast<float>(v));
    append(std::uint16_t{0});
  }
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n60 0 0\n0 60 "
      "0\n0 0 60\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  return {cases::stl_text(geometry::weld(faces)), binary, ply};
}

void read_motion(const std::string& bytes) {
  write_file(scratch() / "motion.csv", bytes);
  cases::read_text(R"(title = "t"
[mill]
kind = "tabulated"
file = "motion.csv"
[jar]
kind = "sphere"
diameter = "20 mm"
)" + balls_and_run,
                   scratch() / "case.toml", catalogue());
}

std::vector<std::string> motions() {
  return {"time_s,x_m,y_m,z_m\n0,0,0,0\n0.01,0.001,0,0\n0.02,0,0,0\n0.03,-0.001,0,0\n0.04,0,0,0\n",
          "# turns\ntime_s,x_m,y_m,z_m,angle_rad\n0,0,0,0,0\n0.1,0,0,0.001,1\n0.2,0,0,0,2\n"
          "0.3,0,0,0,3\n"};
}

void read_measurements(const std::string& text) {
  campaign::read_measurements_text(text, "data.csv",
                                   {{"drawn_power", "W"}, {"collision_rate", "1/s"}});
}

std::vector<std::string> measurements() {
  return {"time [min],D50 [um],D50_error [um]\n10,40,2\n20,30,1\n60,12,1\n",
          "mill.frequency,drawn_power [W],drawn_power_error [W]\n10 Hz,20,0.1\n20 Hz,40,0.1\n"};
}

}  // namespace

Target mesh_target() {
  return {"mesh", read_mesh, tetrahedra};
}
Target motion_target() {
  return {"motion", read_motion, motions};
}
Target measurements_target() {
  return {"measurements", read_measurements, measurements};
}

}  // namespace mahlwerk::fuzz
