// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/writer.hpp"

namespace mahlwerk::cases {

std::string write(const Case& c) {
  Writer out(c);
  Case copy = c;  // a walk may change what it walks over; this one does not
  describe(out, copy);
  write_sweep(out, c);
  return out.text();
}

std::string contents_of_files(const Case& c) {
  std::string bytes;
  const auto add = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  if (const auto* mesh = std::get_if<geometry::Mesh>(&c.jar.shape)) {
    for (const Vec3& point : mesh->surface().points) add(point);
    for (const auto& triangle : mesh->surface().triangles) add(triangle);
  }
  if (const auto* measured = std::get_if<kinematics::Tabulated>(&c.mill.motion))
    for (const kinematics::Sample& sample : measured->samples()) add(sample);
  return fmt::format("# files {:016x}\n", fingerprint(bytes));
}

}  // namespace mahlwerk::cases
