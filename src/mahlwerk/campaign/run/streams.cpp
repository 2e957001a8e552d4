// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/streams.hpp"

#include <span>
#include <system_error>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/write.hpp"

namespace mahlwerk::campaign {

/// Observer that writes records until that fails.
class Streams::Records final : public scene::Observer {
 public:
  Records(const Streams& owner, results::CollisionFile& file, int replicate)
      : owner_(owner), log_(file, replicate) {}
  void collisions(std::span<const scene::Collision> finished) override try {
    if (!owner_.failed()) log_.collisions(finished);
  } catch (...) {
    owner_.keep(std::current_exception());
  }

 private:
  const Streams& owner_;
  results::CollisionLog log_;
};

bool Streams::failed() const {
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr;
}

void Streams::keep(std::exception_ptr why) const {
  {
    const std::lock_guard lock(mutex_);
    if (failure_ != nullptr) return;
    failure_ = why;
  }
  if (on_failure_) try {
      std::rethrow_exception(why);
    } catch (const InputError& e) {
      Fault fault = e.faults().front();
      fault.remedy = "the run goes on without this file; " + fault.remedy;
      on_failure_(fault);
    } catch (const std::exception&) {  // reported by close()
    }
}

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
  made.folder = folder.file(below + "collisions.h5").parent_path();
  points_.push_back(std::move(made));
}

std::unique_ptr<scene::Observer> Streams::records(std::size_t point, int replicate) const {
  const Point& p = points_.at(point);
  if (!p.collisions || failed()) return nullptr;
  try {
    return std::make_unique<Records>(*this, *p.collisions, replicate);
  } catch (const InputError&) {
    keep(std::current_exception());
    return nullptr;
  }
}

std::unique_ptr<results::FrameFiles> Streams::frames(std::size_t point, int replicate) const {
  const Point& p = points_.at(point);
  if (!p.frames || failed()) return nullptr;
  try {
    auto files = p.frames(replicate);
    files->on_failure([this](std::exception_ptr why) { keep(std::move(why)); });
    return files;
  } catch (const InputError&) {
    keep(std::current_exception());
    return nullptr;
  }
}

void Streams::attach(RunOptions& options) const {
  options.records = [this](std::size_t point, int replicate) { return records(point, replicate); };
  options.frames = [this](std::size_t point, int replicate) { return frames(point, replicate); };
}

void Streams::close() {
  for (Point& point : points_)
    if (point.collisions) try {
        point.collisions->close();
      } catch (...) {
        keep(std::current_exception());
      }
  if (failure_ == nullptr) return;
  for (const Point& point : points_) remove_files(point);
  std::rethrow_exception(failure_);
}

void Streams::remove_files(const Point& point) {
  namespace fs = std::filesystem;
  std::vector<fs::path> parts;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(point.folder, none)) {
    const std::string name = entry.path().filename().string();
    if (name == "collisions.h5" || name.starts_with("frames-")) parts.push_back(entry.path());
  }
  for (const fs::path& part : parts) fs::remove_all(part, none);
}

}  // namespace mahlwerk::campaign
