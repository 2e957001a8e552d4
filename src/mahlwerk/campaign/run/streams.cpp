// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/streams.hpp"

#include "mahlwerk/cases/write.hpp"

namespace mahlwerk::campaign {

void Streams::add(const cases::Case& point, const results::Folder& folder,
                  const std::string& below) {
  Point made;
  if (point.observe.collisions)
    made.collisions = std::make_unique<results::CollisionFile>(folder.file(below + "collisions.h5"),
                                                               cases::write(point), version_);
  if (point.observe.frames)
    made.frames = [point, &folder, below](int replicate) {
      return std::make_unique<results::FrameFiles>(
          folder.file(below + results::frames_name(replicate)), point);
    };
  points_.push_back(std::move(made));
}

std::unique_ptr<scene::Observer> Streams::records(std::size_t point, int replicate) const {
  const Point& p = points_.at(point);
  if (!p.collisions) return nullptr;
  return std::make_unique<results::CollisionLog>(*p.collisions, replicate);
}

std::unique_ptr<results::FrameFiles> Streams::frames(std::size_t point, int replicate) const {
  const Point& p = points_.at(point);
  return p.frames ? p.frames(replicate) : nullptr;
}

void Streams::attach(RunOptions& options) const {
  options.records = [this](std::size_t point, int replicate) { return records(point, replicate); };
  options.frames = [this](std::size_t point, int replicate) { return frames(point, replicate); };
}

void Streams::close() {
  for (Point& point : points_)
    if (point.collisions) point.collisions->close();
}

}  // namespace mahlwerk::campaign
