// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/xyz_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <iterator>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/geometry/shape.hpp"

namespace mahlwerk::results {
namespace {

/// Each component as the shortest text that reads back as the same double: at most 17 digits.
std::string numbers(const Vec3& a) {
  return fmt::format("{} {} {}", shortest(a.x), shortest(a.y), shortest(a.z));
}

/// The jar's cell: a cube that holds it in any orientation; along a periodic axis, the period.
/// `axis` is the direction of the jar's z axis, which a periodic cylinder keeps along a laboratory
/// axis.
std::string cell_of(const geometry::AnyShape& shape, const Vec3& axis) {
  Vec3 periods = geometry::periods(shape);
  if (!std::isfinite(periods.x) && std::isfinite(periods.z)) {
    const auto along = [&](double component) {
      return std::abs(component) > 0.5 ? periods.z : geometry::never;
    };
    periods = {along(axis.x), along(axis.y), along(axis.z)};
  }
  const double cube = 2 * geometry::reach(shape);
  const auto side = [&](double period) { return std::isfinite(period) ? period : cube; };
  const auto letter = [](double period) { return std::isfinite(period) ? 'T' : 'F'; };
  const Vec3 size{side(periods.x), side(periods.y), side(periods.z)};
  return fmt::format("Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{}\" pbc=\"{} {} {}\"",
                     shortest(size.x), shortest(size.y), shortest(size.z), numbers(-0.5 * size),
                     letter(periods.x), letter(periods.y), letter(periods.z));
}

}  // namespace

XyzFrames::XyzFrames(std::filesystem::path file, const geometry::AnyShape& shape)
    : path_(std::move(file)), file_(std::fopen(path_.c_str(), "wb")), shape_(shape) {
  if (!file_) throw cannot_write_frames(path_);
}

void XyzFrames::add(const Frame& frame) {
  const bool forces = !frame.forces.empty(), bodies = !frame.bodies.empty();
  if (cell_.empty()) cell_ = cell_of(*shape_, frame.turn.ez);
  std::string text = fmt::format(
      "{}\n{} Properties=id:I:1:species:S:1:pos:R:3:radius:R:1:velo:R:3:angular_velocity:R:3{}{} "
      "Time={} axes=\"of the laboratory, origin at the centre of the jar\" jar_centre=\"{}\" "
      "jar_x=\"{}\" jar_y=\"{}\" jar_z=\"{}\"\n",
      std::ranges::count(frame.balls, false, &scene::Ball::outside), cell_,
      forces ? ":forces:R:3" : "", bodies ? ":body:I:1:orientation:R:4" : "", shortest(frame.time),
      numbers(frame.centre), numbers(frame.turn.ex), numbers(frame.turn.ey),
      numbers(frame.turn.ez));
  for (std::size_t i = 0; i < frame.balls.size(); ++i) {
    const scene::Ball& b = frame.balls[i];
    if (b.outside) continue;
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {}", i + 1, b.kind + 1,
                   numbers(b.position), shortest(b.radius), numbers(b.velocity), numbers(b.spin));
    if (forces) text += ' ' + numbers(frame.forces[i]);
    if (bodies) {
      const Quaternion& q = b.orientation;
      text +=
          fmt::format(" {} {} {}", frame.bodies[i] + 1, numbers({q.x, q.y, q.z}), shortest(q.w));
    }
    text += '\n';
  }
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw cannot_write_frames(path_);
}

}  // namespace mahlwerk::results
