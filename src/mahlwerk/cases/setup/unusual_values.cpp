// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Warnings about valid values that are probably a mistake.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::cases {
namespace {

/// Warns of values beyond the plausible magnitudes that their keys declare.
class MagnitudeCheck : public CaseVisitor {
 public:
  void section(std::string_view name, std::size_t number = 0) override {
    prefix_ = name.empty() ? ""
              : number > 0 ? fmt::format("{}.{}.", name, number)
                           : fmt::format("{}.", name);
  }
  void number(const NumberSpec& spec, double& value) override {
    const std::array<double, 2> ends = plausible_magnitude(spec.unit, spec.plausible);
    const double size = std::abs(value);
    const bool small = size < ends[0];
    if (size == 0 || !std::isfinite(size) || !(small || size > ends[1])) return;
    found.push_back(warning(
        "unusual-value",
        fmt::format(
            "{}{} = {} is {} than {}, which is beyond the mills and materials that we know: "
            "check the unit and the number. It is: {}.",
            prefix_, spec.key, show_rounded(value, spec.unit), small ? "smaller" : "larger",
            show_rounded(ends[small ? 0 : 1], spec.unit), spec.about)));
  }
  void optional_number(const NumberSpec& spec, std::optional<double>& value) override {
    if (value) number(spec, *value);
  }
  void integer(const IntegerSpec&, std::int64_t&) override {}
  void flag(const Flag&, bool&) override {}
  void text(const TextSpec&, std::string&) override {}
  bool choose(const Choice& choice, std::size_t& word_index) override {
    return word_index < choice.words.size();
  }
  void custom(const CustomKey&, const std::function<std::string()>&) override {}

  Notices found;

 private:
  std::string prefix_;
};

Notices magnitudes(const Case& c) {
  MagnitudeCheck check;
  Case copy = c;  // describe() needs a mutable case; the check does not change it
  describe(check, copy);
  return std::move(check.found);
}

/// Powder, grains and films that have no room among the balls.
Notices sizes_among_balls(const Case& c) {
  double largest = 0, smallest = std::numeric_limits<double>::infinity();
  for (const BallSet& set : c.balls) {
    if (set.grains) continue;
    for (const SizeClass& size : set.sizes()) {
      largest = std::max(largest, size.diameter);
      smallest = std::min(smallest, size.diameter);
    }
  }
  Notices found;
  const auto add = [&](const char* key, double size, const char* than, double limit) {
    found.push_back(
        warning("unusual-value",
                fmt::format("{} = {} is larger than {} ({}): check the unit and the "
                            "number.",
                            key, show_rounded(size, "m"), than, show_rounded(limit, "m"))));
  };
  const double grain = c.powder ? c.powder->size.value_or(0) : 0;
  if (largest > 0 && grain > largest) add("powder.size", grain, "the largest ball", largest);
  if (c.liquid && !c.liquid->model.flooded && c.liquid->model.film > 0.05 * smallest)
    add("liquid.film", c.liquid->model.film, "a twentieth of the smallest ball", 0.05 * smallest);
  return found;
}

/// What the reader of the file noticed. Only drums have a usual filling.
Notices remarks_on(const Case& c) {
  Notices found = c.remarks;
  if (drum_motion(c) == nullptr)
    std::erase_if(found, [](const Notice& one) { return one.code == "solid-filling"; });
  return found;
}

Notices ratios(const Case& c) {
  const auto* planetary = kinematics::as<kinematics::Planetary>(*c.mill.motion);
  if (planetary == nullptr || planetary->ratio <= 0) return {};
  return {warning(
      "unusual-ratio",
      fmt::format("The jar turns the same way as the disc, {} times as fast. Planetary "
                  "mills counter-rotate: was ratio = {} meant?",
                  show_rounded(planetary->ratio, ""), show_rounded(-planetary->ratio, "")))};
}

/// The motion with every assumed number of the mill at one end of its range.
kinematics::AnyMotion motion_at(const Case& c, std::size_t end) {
  kinematics::AnyMotion motion = *c.mill.motion;
  const auto set = [&]<class M>(M& one) {
    if constexpr (requires { M::fields(); })
      for (const auto& field : M::fields())
        for (const Origin& o : c.origins)
          if (o.key == fmt::format("mill.{}", field.key) && !o.range[end].empty())
            one.*field.value = parse_in(o.range[end], field.unit);
  };
  std::visit(set, motion);
  return motion;
}

/// Numbers of the mill that the catalogue assumes, and their effect on the speed of its jar.
Notices assumed_numbers(const Case& c) {
  std::string list;
  for (const Origin& o : c.origins)
    if (o.key.starts_with("mill.") && !o.range[0].empty())
      list += fmt::format("{}{} = {} ({} to {})", list.empty() ? "" : ", ", o.key, o.value,
                          o.range[0], o.range[1]);
  if (list.empty()) return {};
  const double now = kinematics::bounds(*c.mill.motion).speed;
  const auto change = [&](std::size_t end) {
    const double other = kinematics::bounds(motion_at(c, end)).speed / now;
    return fmt::format("{:+.0f}", 100 * (other * other - 1));
  };
  return {warning("assumed-mill",
                  fmt::format("Assumed, because they are not known of this mill: {}. Energies of "
                              "hits grow with the square of the speed of the jar, which these "
                              "ranges change by {} to {} %. Measure your mill, and give the "
                              "numbers in [mill].",
                              list, change(0), change(1)))};
}

}  // namespace

Notices unusual_values(const Case& c) {
  Notices found = magnitudes(c);
  append(found, sizes_among_balls(c));
  append(found, ratios(c));
  append(found, assumed_numbers(c));
  append(found, remarks_on(c));
  return found;
}

}  // namespace mahlwerk::cases
