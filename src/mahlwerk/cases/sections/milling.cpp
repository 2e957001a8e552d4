// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [milling], and the one milling time that a case may state in several sections.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

constexpr Range milling_times{.least = 0, .most = 1e8, .without_least = true};  // three years

/// A milling time that a section states.
struct StatedTime {
  std::string_view section;
  std::string text;  ///< "grinding.time = 1 h"
  double time;       ///< [s]
  const Node* at;
};

/// [s] The value of a key; none if it is missing or no time, which its section reports.
std::optional<double> time_at(const Node* node) {
  if (node == nullptr || (node->kind != Node::Kind::text && node->kind != Node::Kind::number))
    return std::nullopt;
  try {
    const double time = parse_in(node->text, "s");
    if (milling_times.holds(time)) return time;
  } catch (const UnitError&) {
  }
  return std::nullopt;
}

std::vector<StatedTime> stated_times(const Node& root) {
  std::vector<StatedTime> found;
  const auto add = [&](std::string_view section, std::string_view key) {
    const Node* table = root.find(section);
    if (table == nullptr || table->kind != Node::Kind::table) return;
    const Node* at = table->find(key);
    const std::optional<double> time = time_at(at);
    if (!time) return;
    const Node* cycles = section == "heat" ? table->find("cycles") : nullptr;
    const double count = cycles == nullptr ? 1 : whole_number(*cycles).value_or(1);
    found.push_back({section,
                     fmt::format("{}.{} = {}{}", section, key, at->text,
                                 cycles == nullptr ? "" : fmt::format(" in {} cycles", count)),
                     *time * count, at});
  };
  add("milling", "time");
  add("grinding", "time");
  add("kinetics", "time");
  add("heat", "milling");
  return found;
}

}  // namespace

std::optional<double> whole_number(const Node& node) {
  std::int64_t n = 0;
  const char* end = node.text.data() + node.text.size();
  const auto [stop, error] = std::from_chars(node.text.data(), end, n);
  if (error != std::errc{} || stop != end || n < 1) return std::nullopt;
  return static_cast<double>(n);
}

void describe(KeyVisitor& v, MillingTime& milling) {
  v.optional_number(
      NumberSpec("time", "s", milling_times, "operating time of the mill, without pauses")
          .with_default_text("time of [grinding] or [kinetics], or milling x cycles of [heat]; "
                             "otherwise none"),
      milling.time);
  v.number({"dose", "J/kg", positive, "energy per mass of powder, whose milling time is computed",
            MillingTime().dose, "a round number"},
           milling.dose);
  v.flag({"reverse", false, "the mill always turns the same way",
          "whether the sense of rotation changes after each cycle of milling"},
         milling.reverse);
}

void find_milling_time(const Node& root, Findings& findings) {
  constexpr double rounding = 1e-9;
  const std::vector<StatedTime> all = stated_times(root);
  if (all.empty()) return;
  const StatedTime& first = all.front();
  findings.milling_time = first.time;
  findings.milling_time_of = first.section;
  for (const StatedTime& other : all)
    if (std::abs(other.time - first.time) > rounding * first.time)
      findings.faults.push_back(
          {other.at->where,
           fmt::format("{}, but {}: a case has one milling time", other.text, first.text),
           "give it once, as [milling] time: the other sections then use it", "two-milling-times"});
}

void describe_milling_time(KeyVisitor& v, NumberSpec spec, double& time) {
  SectionReader* in = v.reader();
  if (v.tries_all_words()) {
    spec = spec.with_default_text("that of [milling] or of another section, if given");
  } else if (in != nullptr && in->findings().milling_time) {
    const std::string_view section = in->findings().milling_time_of;
    spec = spec.with_default(*in->findings().milling_time,
                             section == "milling"    ? "that of [milling]"
                             : section == "grinding" ? "that of [grinding]"
                             : section == "kinetics" ? "that of [kinetics]"
                                                     : "total milling time of [heat]");
  }
  v.number(spec, time);
}

}  // namespace mahlwerk::cases
