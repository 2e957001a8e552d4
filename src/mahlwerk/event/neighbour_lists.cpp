// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/neighbour_lists.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/event/collision_prediction.hpp"

namespace mahlwerk::event {
namespace {

// A ball at its safe time is on its sphere except for rounding. It counts as outside this much
// earlier, so that no safe time is zero again and again.
constexpr double slack = 1e-7;

}  // namespace

NeighbourLists::NeighbourLists(std::span<const double> radii, double skin, const Vec3& periods,
                               std::size_t balls)
    : radii_(radii.begin(), radii.end()),
      skin_(skin),
      periods_(periods),
      spheres_(balls),
      entries_(balls * capacity_) {}

double NeighbourLists::safe_time(std::int32_t ball, const Vec3& position,
                                 const Vec3& velocity) const {
  const Vec3 x = nearest_image(position - centre(ball), periods_);
  const double b = dot(x, velocity), v2 = squared(velocity), c = skin_ * skin_ - squared(x);
  if (!(v2 > 0)) return never;
  return std::max(0.0, (std::sqrt(std::max(0.0, b * b + v2 * c)) - b) / v2);
}

bool NeighbourLists::has_left(std::int32_t ball, const Vec3& position) const {
  const Vec3 x = nearest_image(position - centre(ball), periods_);
  return squared(x) >= (1 - slack) * (1 - slack) * skin_ * skin_;
}

void NeighbourLists::place(std::int32_t ball, std::uint32_t species, const Vec3& position) {
  spheres_[as_index(ball)] = {position, 0, species};
}

void NeighbourLists::renew(std::int32_t ball, const Vec3& position,
                           std::span<const std::int32_t> candidates) {
  remove_from_others(ball);
  Sphere& mine = spheres_[as_index(ball)];
  mine.centre = position;
  mine.count = 0;
  if (found_.size() < candidates.size()) found_.resize(candidates.size());
  const double reach = radii_[mine.species] + 2 * skin_;
  std::size_t count = 0;
  for (const std::int32_t other : candidates) {  // without branches that no predictor foresees
    const Sphere& theirs = spheres_[as_index(other)];
    const Vec3 apart = nearest_image(position - theirs.centre, periods_);
    const double near = reach + radii_[theirs.species];
    found_[count] = other;
    count += squared(apart) <= near * near ? 1 : 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (found_[i] == ball) continue;
    add(ball, found_[i]);
    add(found_[i], ball);
  }
}

void NeighbourLists::remove_from_others(std::int32_t ball) {
  for (const std::int32_t other : of(ball)) {
    std::int32_t& count = spheres_[as_index(other)].count;
    std::int32_t* const first = &entries_[row(other)];
    *std::find(first, first + count, ball) = first[count - 1];
    --count;
  }
}

void NeighbourLists::add(std::int32_t ball, std::int32_t other) {
  std::int32_t& count = spheres_[as_index(ball)].count;
  if (as_index(count) == capacity_) grow();
  entries_[row(ball) + as_index(count)] = other;
  ++count;
}

void NeighbourLists::grow() {
  const std::size_t larger = capacity_ + 8;
  HugePageVector<std::int32_t> entries(spheres_.size() * larger);
  for (std::size_t i = 0; i < spheres_.size(); ++i)
    std::copy_n(&entries_[i * capacity_], spheres_[i].count, &entries[i * larger]);
  entries_ = std::move(entries);
  capacity_ = larger;
}

void NeighbourLists::renumber(std::span<const std::int32_t> number) {
  HugePageVector<Sphere> spheres(spheres_.size());
  HugePageVector<std::int32_t> entries(entries_.size());
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const std::size_t to = as_index(number[i]);
    spheres[to] = spheres_[i];
    for (std::size_t k = 0; k < as_index(spheres_[i].count); ++k)
      entries[to * capacity_ + k] = number[as_index(entries_[i * capacity_ + k])];
  }
  spheres_ = std::move(spheres);
  entries_ = std::move(entries);
}

void NeighbourLists::prefetch(std::int32_t ball) const {
  __builtin_prefetch(&spheres_[as_index(ball)]);
  __builtin_prefetch(&entries_[row(ball)]);
  __builtin_prefetch(&entries_[row(ball) + capacity_ - 1]);
}

void NeighbourLists::serialize(Archive& archive) {
  archive(capacity_)(spheres_)(entries_);
}

/// Whether all spheres are in the box and all lists are symmetric and name each ball once.
bool NeighbourLists::is_consistent(std::size_t balls) const {
  if (spheres_.size() != balls || capacity_ < 1 || entries_.size() / capacity_ != balls ||
      entries_.size() % capacity_ != 0)
    return false;
  const auto valid = [&](std::int32_t ball) { return ball >= 0 && as_index(ball) < balls; };
  const auto inside = [](double x, double period) { return std::abs(x) <= 0.5 * period; };
  for (const Sphere& s : spheres_)
    if (s.count < 0 || as_index(s.count) > capacity_ || s.species >= radii_.size() ||
        !inside(s.centre.x, periods_.x) || !inside(s.centre.y, periods_.y) ||
        !inside(s.centre.z, periods_.z))
      return false;
  for (std::size_t i = 0; i < balls; ++i) {
    const auto ball = static_cast<std::int32_t>(i);
    for (const std::int32_t other : of(ball))
      if (!valid(other) || other == ball || std::ranges::count(of(other), ball) != 1 ||
          std::ranges::count(of(ball), other) != 1)
        return false;
  }
  return true;
}

}  // namespace mahlwerk::event
