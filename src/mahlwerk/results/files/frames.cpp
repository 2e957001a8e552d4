// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <utility>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/scene/drawn_spheres.hpp"

namespace mahlwerk::results {

InputError cannot_write_frames(const std::filesystem::path& file) {
  return InputError(Fault{file.string(), std::string("cannot be written: ") + std::strerror(errno),
                          "free some space, or write fewer frames: a longer [observe] frames",
                          "cannot-write"});
}

FrameFiles::FrameFiles(const std::filesystem::path& stem, const cases::Case& mill_case)
    : chamber_(cases::chamber(mill_case)), shapes_(cases::body_shapes(mill_case)) {
  using cases::FramesFormat;
  const auto with = [&](const char* ending) { return stem.string() + ending; };
  if (mill_case.observe.frames_format != FramesFormat::vtk)
    xyz_.emplace(with(".xyz"), *chamber_.shape);
  if (mill_case.observe.frames_format != FramesFormat::xyz)
    vtk_.emplace(with(".pvd"), chamber_, cases::jar_mesh_is_static(mill_case));
}

void FrameFiles::move_with(const kinematics::AnyMotion& motion) {
  chamber_.motion = motion;
  if (vtk_) vtk_->move_with(motion);
}

void FrameFiles::add(double time, const std::vector<scene::Ball>& balls,
                     const std::vector<Vec3>& forces) {
  if (failed_) return;
  const Vec3 centre = kinematics::frame_motion(*chamber_.motion, time).centre;
  const Rotation turn = kinematics::rotation(*chamber_.motion, time) * chamber_.mount;
  if (shapes_.empty()) return write({time, balls, forces, centre, turn});
  auto [spheres, of_ball] = scene::drawn_spheres(balls, shapes_);
  std::vector<Vec3> on_bodies;
  for (std::size_t k = 0; k < of_ball.size() && !forces.empty(); ++k)
    on_bodies.push_back(forces[static_cast<std::size_t>(of_ball[k])]);
  write({time, spheres, on_bodies, centre, turn, of_ball});
}

void FrameFiles::write(const Frame& frame) try {
  if (xyz_) xyz_->add(frame);
  if (vtk_) vtk_->add(frame);
} catch (...) {
  if (!keep_) throw;
  failed_ = true;
  keep_(std::current_exception());
}

std::string frames_name(int replicate) {
  return fmt::format("frames-{}", replicate + 1);
}

FrameTimes::FrameTimes(const cases::Case& mill_case)
    : begin_(std::numeric_limits<double>::infinity()),
      length_(mill_case.run.time),
      every_(mill_case.observe.frames.value_or(0)) {
  if (every_ > 0) count_ = 1 + static_cast<std::int64_t>(mill_case.run.time / every_ * (1 + 1e-12));
}

double FrameTimes::next() const {
  if (done_ == count_) return std::numeric_limits<double>::infinity();
  return begin_ + std::min(length_, every_ * static_cast<double>(done_));
}

}  // namespace mahlwerk::results
