// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Single values that are out of range.
#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/grinding_fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

/// Checks single values, for a case that was constructed without a reader.
class ValueCheck : public CaseVisitor {
 public:
  explicit ValueCheck(const Case& c) : c_(c) {}

  void section(std::string_view name, std::size_t number = 0) override {
    prefix_ = number > 0 ? fmt::format("{}.{}.", name, number) : fmt::format("{}.", name);
  }
  void number(const NumberSpec& spec, double& value) override {
    if (!refusal(value, spec.range, spec.unit).empty())
      fault(spec.key, "{} = {} is out of range", show(value, spec.unit));
  }
  void optional_number(const NumberSpec& spec, std::optional<double>& value) override {
    if (value) number(spec, *value);
  }
  void integer(const IntegerSpec& spec, std::int64_t& n) override {
    if (n < spec.least || n > spec.most)
      fault(spec.key, "{} = {} must be from {} to {}", n, spec.least, spec.most);
  }
  bool visits_all() override { return true; }
  void flag(const Flag&, bool&) override {}
  void text(const TextSpec&, std::string&) override {}
  bool choose(const Choice& choice, std::size_t& word_index) override {
    const bool sound = word_index < choice.words.size();
    if (!sound) fault(choice.key, "{} must be {}", quoted_list(choice.words));
    return sound;
  }
  void custom(const CustomKey& key, const std::function<std::string()>&) override {
    if (!key.sound) fault(key.key, "{} is out of range: {}", key.about);
  }
  /// Adds a fault; the dotted key is the first value formatted into `what`.
  template <class... Values>
  void fault(std::string_view key, fmt::format_string<const std::string&, const Values&...> what,
             const Values&... values) {
    const std::string dotted = prefix_ + std::string(key);
    found.push_back({location_of(c_, dotted), fmt::format(what, dotted, values...),
                     "see docs/cases.md for the values of a case", "out-of-range"});
  }

  std::vector<Fault> found;

 private:
  const Case& c_;
  std::string prefix_;
};

/// Reports size classes that do not sum to the count of their set.
void check_classes(ValueCheck& check, BallSet& set) {
  if (set.classes.empty()) return;
  std::int64_t count = 0;
  for (SizeClass& size : set.classes) {
    check.number({"diameter", "m", positive, ""}, size.diameter);
    check.integer({"count", 1, max_balls, ""}, size.count);
    count += size.count;
  }
  if (count != set.count)
    check.fault("count", "{} = {}, but its classes have {} balls", set.count, count);
}

}  // namespace

std::vector<Fault> bad_values(const Case& c) {
  ValueCheck check(c);
  if (c.balls.empty()) check.fault("balls", "there are no {}");
  Case copy = c;  // describe() needs a mutable case; ValueCheck does not change it
  describe(check, copy);
  for (std::size_t i = 0; i < c.balls.size(); ++i) {
    BallSet& set = copy.balls[i];
    check.section("balls", i + 1);
    if (set.grains) describe(check, set, copy.jar);  // describe() of a case skips grains
    if (set.distribution.law != Distribution::Law::equal)
      check.number({"diameter", "m", positive, ""}, set.diameter);
    check_classes(check, set);
  }
  if (c.grinding && c.grinding->classes_per_octave % size_step != 0) {
    check.section("grinding");
    check.fault("classes_per_octave", "{} = {} is not a multiple of {}",
                c.grinding->classes_per_octave, size_step);
  }
  return std::move(check.found);
}

}  // namespace mahlwerk::cases
