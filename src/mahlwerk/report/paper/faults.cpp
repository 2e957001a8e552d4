// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Checks a paper's references to its campaigns before any of them runs.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/paper/claim_lines.hpp"
#include "mahlwerk/report/paper/paper.hpp"
#include "mahlwerk/report/paper/tables.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"

namespace mahlwerk::report {
namespace {

/// Checks the references of one figure or claim to its campaign.
class ReferenceCheck {
 public:
  ReferenceCheck(std::string where, const std::string& campaign, const cases::Case& mill_case,
                 std::vector<Fault>& faults)
      : where_(std::move(where)), campaign_(campaign), case_(mill_case), faults_(faults) {}

  void key(const std::string& name) {
    if (!name.empty()) find(name);
  }
  void value(const std::string& key, const std::string& text) {
    const cases::SweptKey* swept = text.empty() ? nullptr : find(key);
    if (swept == nullptr || swept->range) return;
    if (std::ranges::any_of(swept->values,
                            [&](const std::string& v) { return same_value(v, text); }))
      return;
    fault(fmt::format("{} does not take the value {} in {}.toml", key, text, campaign_),
          "its values are " + listed(swept->values), "paper-unknown-value");
  }
  void at(const PointSelector& where) {
    for (const auto& [key, values] : where)
      for (const std::string& v : values) value(key, v);
  }
  void quantity(const std::string& name) {
    if (name.empty()) return;
    std::vector<std::string> names;
    for (const results::Quantity& q : quantities()) names.push_back(q.name);
    if (std::ranges::find(names, name) != names.end()) return;
    const std::string near = nearest_word(name, names);
    fault(fmt::format("a result of {}.toml has no quantity {}", campaign_, name),
          near.empty() ? "docs/formats.md lists them" : fmt::format("do you mean {}?", near),
          "paper-unknown-quantity");
  }

  /// The campaign has captures whose bounds are known.
  void capture() {
    if (!has_capture_bounds(case_))
      fault(fmt::format("{}.toml has no captures with known bounds", campaign_),
            "give it [capture] model = \"barrios\" and a cylinder", "paper-no-capture");
  }

  /// The measurements that a figure draws exist and are numbers on both of its axes.
  void drawn(const Paper& paper, const PaperFigure& figure) {
    for (const std::string& name : figure.measurements) {
      const Measurement* measured = paper.measurement(name);
      if (measured == nullptr) {
        no_measurement(name);
        continue;
      }
      for (const Measurement::Value& v : measured->values) {
        in_unit_of(v, figure.quantity, unit_of(figure.quantity));
        try {
          parse_quantity(v.at);
        } catch (const UnitError& error) {
          fault(fmt::format("the measured values \"{}\" have no place on the axis: {}", name,
                            error.what()),
                "draw only values against a number", "bad-quantity");
        }
      }
    }
  }

  /// The measurement exists, its values are quantities of that dimension at points of the campaign.
  void measurement(const Claim& claim, const Measurement* measured) {
    if (measured == nullptr) {
      no_measurement(claim.measured);
      return;
    }
    const std::string unit = claim.relative_to.empty() ? unit_of(claim.quantity) : "";
    for (const Measurement::Value& v : measured->values) {
      if (claim.against.empty() != v.at.empty())
        fault(
            fmt::format("[[measured]] \"{}\" and the claim do not both have a key", claim.measured),
            "give `against` and a value of this key in each row, or neither",
            "paper-unknown-measurement");
      value(claim.against, v.at);
      in_unit_of(v, claim.quantity, unit);
    }
  }

 private:
  std::string unit_of(const std::string& name) const {
    for (const results::Quantity& q : quantities())
      if (q.name == name) return q.unit;
    return "";
  }
  void in_unit_of(const Measurement::Value& v, const std::string& name, const std::string& unit) {
    try {
      v.in(unit);
      v.error_in(unit);
    } catch (const UnitError& error) {
      fault(error.what(), fmt::format("{} is in {}", name, unit.empty() ? "1" : unit),
            "bad-quantity");
    }
  }
  void no_measurement(const std::string& name) {
    fault(fmt::format("there is no section [[measured]] with the name \"{}\"", name),
          "write one, or name another", "paper-unknown-measurement");
  }
  std::vector<results::Quantity> quantities() const {
    results::Outcome none;
    none.mill_case = case_;
    return results::summarise(none).quantities;
  }
  static std::string listed(const std::vector<std::string>& values) {
    std::string all;
    for (const std::string& v : values) all += (all.empty() ? "" : ", ") + v;
    return all;
  }
  const cases::SweptKey* find(const std::string& name) {
    const auto& keys = case_.sweep.keys;
    const auto found = std::ranges::find(keys, name, &cases::SweptKey::key);
    if (found != keys.end()) return &*found;
    fault(fmt::format("{}.toml does not vary {}", campaign_, name),
          fmt::format("name a key of its [sweep], or put {} there", name), "paper-unknown-key");
    return nullptr;
  }
  void fault(std::string what, std::string remedy, const char* code) {
    faults_.push_back({where_, std::move(what), std::move(remedy), code});
  }

  std::string where_;
  const std::string& campaign_;
  const cases::Case& case_;
  std::vector<Fault>& faults_;
};

}  // namespace

std::vector<Fault> paper_faults(const Paper& paper,
                                const std::map<std::string, cases::Case>& cases) {
  std::vector<Fault> faults;
  for (const PaperFigure& figure : paper.figures) {
    ReferenceCheck check(figure.where, figure.campaign, cases.at(figure.campaign), faults);
    check.key(figure.against);
    check.at(figure.at);
    check.quantity(figure.quantity);
    check.drawn(paper, figure);
  }
  for (const Claim& claim : paper.claims) {
    ReferenceCheck check(claim.where, claim.campaign, cases.at(claim.campaign), faults);
    check.key(claim.against);
    check.at(claim.at);
    check.value(claim.against, claim.first);
    check.value(claim.against, claim.second);
    check.value(claim.against, claim.relative_to);
    check.quantity(claim.quantity);
    if (claim.kind == Claim::Kind::measured)
      check.measurement(claim, paper.measurement(claim.measured));
    if (claim.kind == Claim::Kind::capture_bounds) check.capture();
  }
  for (const PaperTable& table : paper.tables) {
    ReferenceCheck check(table.where, table.campaign, cases.at(table.campaign), faults);
    check.key(table.against);
    check.at(table.at);
    check.quantity(table.quantity);
    if (table.kind == PaperTable::Kind::captured) check.capture();
  }
  return faults;
}

}  // namespace mahlwerk::report
