// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/build.hpp"

namespace mahlwerk::results {
namespace {

InputError cannot_write(const std::filesystem::path& file) {
  return InputError(Fault{file.string(), std::string("cannot be written: ") + std::strerror(errno),
                          "free some space, or keep fewer frames: a longer [observe] frames",
                          "cannot-write"});
}

std::string numbers(const Vec3& a) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", a.x, a.y, a.z);
}

/// The jar's box: a cube that it fits into however it turns, or the periods of a periodic box.
std::string cell_of(const geometry::AnyShape& shape) {
  const auto* periodic = std::get_if<geometry::PeriodicBox>(&shape);
  const double reach = std::visit([](const auto& s) { return s.reach(); }, shape);
  const Vec3 size = periodic != nullptr ? periodic->periods() : 2 * reach * Vec3{1, 1, 1};
  return fmt::format("Lattice=\"{:.9g} 0 0 0 {:.9g} 0 0 0 {:.9g}\" Origin=\"{}\" pbc=\"{}\"",
                     size.x, size.y, size.z, numbers(-0.5 * size),
                     periodic != nullptr ? "T T T" : "F F F");
}

}  // namespace

FrameFile::FrameFile(std::filesystem::path file, const cases::Case& what)
    : path_(std::move(file)),
      file_(std::fopen(path_.c_str(), "wb")),
      chamber_(cases::chamber(what)),
      cell_(cell_of(chamber_.shape)) {
  if (!file_) throw cannot_write(path_);
}

void FrameFile::add(double time, const std::vector<scene::Ball>& balls) {
  const auto [centre, turn] = std::visit(
      [&](const auto& m) { return std::pair(m.ride(time).centre, m.turn(time) * chamber_.mount); },
      chamber_.motion);
  std::string text = fmt::format(
      "{}\n{} Properties=id:I:1:species:S:1:pos:R:3:radius:R:1:velo:R:3:angular_velocity:R:3 "
      "Time={:.9g} axes=\"of the laboratory, origin at the centre of the jar\" jar_centre=\"{}\" "
      "jar_x=\"{}\" jar_y=\"{}\" jar_z=\"{}\"\n",
      balls.size(), cell_, time, numbers(centre), numbers(turn.ex), numbers(turn.ey),
      numbers(turn.ez));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const scene::Ball& b = balls[i];
    fmt::format_to(std::back_inserter(text), "{} {} {} {:.9g} {} {}\n", i + 1, b.kind + 1,
                   numbers(b.position), b.radius, numbers(b.velocity), numbers(b.spin));
  }
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw cannot_write(path_);
}

std::string frames_name(int replicate) {
  return fmt::format("frames-{}.xyz", replicate + 1);
}

FrameTimes::FrameTimes(const cases::Case& what)
    : settle_(what.run.settle),
      end_(what.run.settle + what.run.time),
      every_(what.observe.frames.value_or(0)) {
  if (every_ > 0) count_ = 1 + static_cast<std::int64_t>(what.run.time / every_ * (1 + 1e-12));
}

double FrameTimes::next() const {
  if (done_ == count_) return std::numeric_limits<double>::infinity();
  return std::min(end_, settle_ + every_ * static_cast<double>(done_));
}

}  // namespace mahlwerk::results
