// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Parts in the jar that do not fit into it, or that the engine cannot move.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"
#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::cases {
namespace {

class PartCheck {
 public:
  PartCheck(const Case& c, std::vector<Fault>& found) : c_(c), found_(found) {}

  void all() {
    motions();
    for (std::size_t i = 0; i < c_.machine_parts.size(); ++i) {
      in_the_jar(i);
      opening(i);
      hole(i);
      in_a_periodic_jar(i);
    }
    if (c_.liquid)
      fault(0, "kind", "parts in a jar with a liquid are not computed",
            "remove [liquid] or the parts");
    if (c_.run.device == DeviceName::gpu)
      fault(0, "kind", "parts in the jar are computed on the processor only",
            "write device = \"cpu\", or leave it out");
  }

 private:
  void fault(std::size_t part, const char* key, std::string what, std::string remedy) {
    found_.push_back({location_of(c_, fmt::format("parts.{}.{}", part + 1, key)), std::move(what),
                      std::move(remedy), "bad-part"});
  }
  const std::string& name(std::size_t i) const { return c_.machine_parts[i].name; }

  void motions() {
    constexpr std::size_t most = 8;  // soft::max_part_motions
    std::vector<std::pair<kinematics::PartMotion, bool>> different;
    for (const MachinePart& part : c_.machine_parts) {
      const std::pair one(part.body.motion, part.body.in_laboratory);
      if (std::ranges::find(different, one) == different.end()) different.push_back(one);
    }
    if (different.size() > most)
      fault(
          0, "motion",
          fmt::format("the parts have {} different motions, more than {}", different.size(), most),
          "give parts that move together the same axis, pivot and speed");
  }

  /// A part that the jar does not reach at any time touches nothing.
  void in_the_jar(std::size_t i) {
    const scene::MachinePart& body = c_.machine_parts[i].body;
    const double own = std::visit([](const auto& s) { return s.reach(); }, *body.solid);
    const double jar = geometry::reach(*c_.jar.shape);
    if (body.in_laboratory || !std::isfinite(own) || !std::isfinite(jar)) return;
    const kinematics::PartMotion& m = body.motion;
    const bool tabulated = m.kind == kinematics::PartMotion::Kind::tabulated;
    if (tabulated && m.path.samples().empty()) return;  // its file has a fault
    double path = m.kind == kinematics::PartMotion::Kind::oscillating ? m.amplitude : 0;
    if (tabulated) path = m.path.bounds().speed * m.period();
    const double away =
        m.moves() ? std::abs(norm(m.pivot) - norm(body.position - m.pivot)) : norm(body.position);
    if (!(away - own - path > jar)) return;  // values with a fault are no numbers
    fault(i, "position",
          fmt::format("the part {} is outside the jar: {} from its middle, which reaches {} far",
                      name(i), show_rounded(away - own, "m"), show_rounded(jar, "m")),
          "give positions from the middle of the jar, in its own axes");
  }

  void opening(std::size_t i) {
    const double opening = c_.machine_parts[i].body.opening;
    const double smallest = smallest_ball_or_grain();
    if (!(opening > 0) || opening >= smallest) return;
    fault(i, "opening",
          fmt::format("opening = {}: no ball is that small; the smallest is {}",
                      show_rounded(opening, "m"), show_rounded(smallest, "m")),
          "give a wider opening, or leave it out");
  }
  void hole(std::size_t i) {
    const auto* ring = std::get_if<geometry::RingSolid>(&*c_.machine_parts[i].body.solid);
    if (ring == nullptr || !(ring->hole >= ring->diameter)) return;
    fault(i, "hole",
          fmt::format("hole = {}: the ring {} has an outer diameter of {}",
                      show_rounded(ring->hole, "m"), name(i), show_rounded(ring->diameter, "m")),
          "give a smaller hole, or a larger diameter");
  }
  double smallest_ball_or_grain() const {
    double least = INFINITY;
    for (const BallSet& set : c_.balls)
      for (const SizeClass& size : set.sizes()) least = std::min(least, size.diameter);
    return least;
  }

  /// In a periodic jar a part has images; it may turn about the periodic axis alone.
  void in_a_periodic_jar(std::size_t i) {
    const Vec3 periods = geometry::periods(*c_.jar.shape);
    if (!std::isfinite(periods.x) && !std::isfinite(periods.y) && !std::isfinite(periods.z)) return;
    const kinematics::PartMotion& m = c_.machine_parts[i].body.motion;
    if (m.spin_bound() == 0) return;
    const bool along_z = !std::isfinite(periods.x) && norm(cross(m.axis, {0, 0, 1})) < 1e-12;
    if (along_z && m.kind != kinematics::PartMotion::Kind::tabulated &&
        !c_.machine_parts[i].body.in_laboratory)
      return;
    fault(i, "motion",
          fmt::format("the part {} turns in a periodic jar about an axis other than that of the "
                      "jar: its images would not fit together",
                      name(i)),
          "let it turn about the jar's axis, or take a jar with ends");
  }

  const Case& c_;
  std::vector<Fault>& found_;
};

}  // namespace

void bad_parts(const Case& c, std::vector<Fault>& found) {
  if (!c.machine_parts.empty()) PartCheck(c, found).all();
}

}  // namespace mahlwerk::cases
