// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Powder between bodies that damps their bounce: the section. The run finds the restitution
// (campaign/run/powder_effect).
#include "mahlwerk/cases/powder_feedback.hpp"

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::parts::powder_feedback {
namespace {

using cases::Case;
using cases::NumberSpec;
using cases::PowderFeedback;

void describe(cases::KeyVisitor& v, PowderFeedback& feedback, const Case&) {
  v.number(NumberSpec("absorbed_energy", "J/kg", positive,
                      "energy that captured powder takes out of a hit, at most, by its mass")
               .with({.start = "1 kJ/kg"}),
           feedback.absorbed_energy);
  constexpr Range shares{.least = 1e-3, .most = 0.2};
  v.number(
      NumberSpec("accuracy", "", shares, "change of the restitution below which it is consistent")
          .with_default(PowderFeedback().accuracy, "below the error of a measured restitution"),
      feedback.accuracy);
}

void check(const Case& c, std::vector<Fault>& found) {
  const auto fault = [&](const char* key, std::string what, std::string remedy) {
    found.push_back(
        {cases::location_of(c, key), std::move(what), std::move(remedy), "bad-powder-feedback"});
  };
  if (!c.capture)
    fault("powder_feedback.absorbed_energy",
          "[powder_feedback] needs [capture]: how much powder a collision captures",
          "add [capture] with a model, or remove [powder_feedback]");
  if (c.powder && c.powder->grain_size)
    fault("powder.as", "powder that is simulated as grains damps by itself",
          "remove [powder_feedback], or as = \"grains\"");
  if (c.uncertainty)
    fault(
        "powder_feedback.absorbed_energy",
        "each draw of [uncertainty] has contacts of its own, and one restitution is found for all",
        "remove [uncertainty] or [powder_feedback]");
  if (c.contact.rule.restitution.law() != contact::Restitution::Law::constant)
    fault("contact.restitution_law",
          "[powder_feedback] replaces a restitution that is the same at every speed",
          "write restitution_law = \"constant\", or remove [powder_feedback]");
}

/// Restitution of balls with `other`, as the run found it (fbk.1).
double found(const Case& c, std::string_view other) {
  const auto* feedback = c.parts.find<PowderFeedback>();
  if (feedback != nullptr && feedback->found)
    for (const cases::PairRule& pair : c.contact.pairs)
      if (pair.between[0] == "balls" && pair.between[1] == other)
        return pair.rule.restitution.value();
  return c.contact.rule.restitution.value();
}

results::Measures quantities() {
  const auto present = [](const Case& c) { return c.parts.find<PowderFeedback>() != nullptr; };
  return results::where(
      present, "with `[powder_feedback]`",
      {{"restitution_balls_with_powder",
        "1",
        "restitution of balls with each other, with powder between them",
        [](const Case& c, const results::Replicate&) { return found(c, "balls"); },
        {.equation = "fbk.1", .heading = "Powder that damps the bounce"}},
       {"restitution_jar_with_powder",
        "1",
        "restitution of balls with the jar, with powder between them",
        [](const Case& c, const results::Replicate&) { return found(c, "jar"); },
        {.equation = "fbk.1"}}});
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "powder_feedback",
      .sections = {cases::section_of<PowderFeedback, describe>(
          {"powder_feedback", "", "powder between bodies that damps their bounce"})},
      .check = check,
      .quantities = quantities};
  return made;
}

}  // namespace mahlwerk::parts::powder_feedback
