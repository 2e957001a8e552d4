// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A case from its first section to its last.
#include <fmt/format.h>

#include <limits>

#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

void describe_top(Walk& w, Case& c) {
  w.formed({"title", "what it is about"}, [&] { return in_quotes(c.title); });
  w.formed({"seed", "chooses the starts among those that chance allows"}, [&] {
    const std::string seed = std::to_string(c.seed);
    return std::in_range<std::int64_t>(c.seed) ? seed : in_quotes(seed);
  });
  w.fields(c, case_fields());
}

void describe_grinding(CaseWalk& w, Case& c) {
  if (c.capture) {
    w.section("capture");
    describe(w, *c.capture, c, false);
  }
  if (c.grinding) {
    w.section("breakage");
    describe(w, c.grinding->breakage, c);
    w.section("fragments");
    describe(w, c.grinding->fragments, c);
    w.section("grinding");
    describe(w, *c.grinding, c);
  }
  if (c.kinetics) {
    w.section("kinetics");
    describe(w, *c.kinetics, c);
  }
}

void describe_contact(CaseWalk& w, Case& c) {
  w.section("contact");
  describe(w, c.contact, c);
  for (std::size_t i = 0; i < c.contact.pairs.size(); ++i) {
    w.section("contact.pairs", i + 1);
    describe(w, c.contact.pairs[i], c.contact, &c.contact.model);
  }
}

}  // namespace

void describe(CaseWalk& w, Case& c) {
  describe_top(w, c);
  w.section("mill");
  describe(w, c.mill, c);
  w.section("jar");
  describe(w, c.jar);
  for (std::size_t i = 0; i < c.balls.size(); ++i) {
    if (c.balls[i].grains) continue;  // [powder] says them
    w.section("balls", i + 1);
    describe(w, c.balls[i], c.jar);
  }
  if (c.powder) {
    w.section("powder");
    describe(w, *c.powder, c.balls, c.jar);
  }
  describe_contact(w, c);
  w.section("run");
  describe(w, c.run);
  w.section("observe");
  describe(w, c.observe);
  if (c.wear) {
    w.section("wear");
    describe(w, *c.wear);
  }
  if (c.heat) {
    w.section("heat");
    describe(w, *c.heat);
  }
  describe_grinding(w, c);
}

}  // namespace mahlwerk::cases
