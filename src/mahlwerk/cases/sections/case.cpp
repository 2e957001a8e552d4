// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// All sections of a case, in the order in which they are written.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

void describe_top(KeyVisitor& v, Case& c) {
  v.custom({"title", "title of the case", true, "text"}, [&] { return in_quotes(c.title); });
  v.custom({"seed", "seed of the random initial positions and velocities, a whole number from 0",
            true, "integer", false, "1"},
           [&] {
             const std::string seed = std::to_string(c.seed);
             return std::in_range<std::int64_t>(c.seed) ? seed : in_quotes(seed);
           });
  v.fields(c, case_fields());
  describe_gravity_direction(v, c.gravity_direction);
}

/// Three numbers, scaled to a length of 1. A written case has that length, and keeps its bits.
void read_gravity_direction(SectionReader& in, const CustomKey& key, Vec3& direction) {
  const Node* at = in.find(key.key);
  if (at == nullptr) return;
  const NumberSpec component(key.key, "", any_number, key.about);
  std::array<double, 3> x{};
  const bool three = at->kind == Node::Kind::list && at->items.size() == x.size();
  for (std::size_t i = 0; three && i < x.size(); ++i) x[i] = in.quantity(at->items[i], component);
  const Vec3 given{x[0], x[1], x[2]};
  const double length = norm(given);
  if (std::isnan(length)) return;  // already reported
  if (!three || !(length > 0) || !std::isfinite(length)) {
    in.fault(*at, "`gravity_direction` must be a list of three numbers, not all 0",
             "write x, y, z in the axes of the mill: gravity_direction = [0.1, 0, -1]",
             "wrong-type");
    return;
  }
  constexpr double rounding = 1e-12;
  direction = std::abs(length - 1) < rounding ? given : given / length;
  in.record_origin(key.key,
                   fmt::format("[{}, {}, {}]", shortest(direction.x), shortest(direction.y),
                               shortest(direction.z)),
                   at);
}

}  // namespace

void describe_gravity_direction(KeyVisitor& v, Vec3& direction) {
  constexpr CustomKey key{
      .key = "gravity_direction",
      .about = "direction of gravity in the axes of the mill, as x, y, z; of any length",
      .default_text = "[0, 0, -1], downwards"};
  SectionReader* in = v.reader();
  const bool sound = std::abs(norm(direction) - 1) < 1e-9;
  if (in == nullptr && (!sound || direction != Vec3{0, 0, -1} || v.visits_all())) {
    CustomKey written = key;
    written.sound = sound;
    v.custom(written, [&] {
      return fmt::format("[{}, {}, {}]", shortest(direction.x), shortest(direction.y),
                         shortest(direction.z));
    });
  }
  if (in != nullptr) read_gravity_direction(*in, key, direction);
}

void describe(CaseVisitor& v, Case& c) {
  const auto section = [&](const char* name, auto&&... values) {
    v.section(name);
    describe(v, values...);
  };
  describe_top(v, c);
  section("mill", c.mill, c);
  section("jar", c.jar);
  for (std::size_t i = 0; i < c.machine_parts.size(); ++i) {
    v.section("parts", i + 1);
    describe(v, c.machine_parts[i]);
  }
  for (std::size_t i = 0; i < c.balls.size(); ++i) {
    if (c.balls[i].grains) continue;  // part of [powder]
    v.section("balls", i + 1);
    describe(v, c.balls[i], c.jar);
  }
  if (c.powder) section("powder", *c.powder, c.balls, c.jar);
  v.section("contact");
  const ContactModel* model = describe(v, c.contact, c);
  for (std::size_t i = 0; i < c.contact.pairs.size(); ++i) {
    v.section("contact.pairs", i + 1);
    describe(v, c.contact.pairs[i], c.contact, model);
  }
  if (c.liquid) section("liquid", *c.liquid);
  section("run", c.run);
  section("observe", c.observe);
  if (c.milling) section("milling", *c.milling);
  for (const Part* part : parts())
    for (const PartSection& one : part->sections) {
      if (!one.present(c)) continue;
      v.section(one.spec.name);
      one.describe(v, c);
    }
}

void describe_many_runs(CaseVisitor& v) {
  v.section("sweep");
  list_sweep_keys(v);
  v.section("optimise");
  list_optimise_keys(v);
  v.section("match");
  list_match_keys(v);
  v.section("fit");
  list_fit_keys(v);
  v.section("uncertainty");
  list_uncertainty_keys(v);
}

}  // namespace mahlwerk::cases
