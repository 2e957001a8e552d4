// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/writer.hpp"

namespace mahlwerk::cases {
namespace {

void write_mill(Writer& out, const Mill& mill) {
  out.section("[mill]", "mill.");
  const auto kind = std::visit([](const auto& m) { return std::string(m.name); }, mill.motion);
  out.word("kind", kind);
  out.name("model", mill.model);
  out.name("file", mill.motion_file);
  std::visit([&](const auto& m) { out.fields(m, m.fields()); }, mill.motion);
  if (std::holds_alternative<kinematics::Planetary>(mill.motion))
    out.word("ratio_convention", "relative");
  out.name("jar_axis", axis_word(mill.jar_axis));
  if (mill.jars_carried != 1) out.line("jars_carried", std::to_string(mill.jars_carried));
}

void write_jar(Writer& out, const Jar& jar) {
  out.section("[jar]", "jar.");
  out.word("kind", std::visit([](const auto& s) { return std::string(s.name); }, jar.shape));
  out.name("model", jar.model);
  if (std::holds_alternative<geometry::Mesh>(jar.shape)) {
    out.word("file", jar.mesh.file);
    out.word("unit", jar.mesh.unit);
    out.word("origin", jar.mesh.centred ? "centre" : "file");
  }
  std::visit([&](const auto& s) { out.fields(s, s.fields()); }, jar.shape);
  out.name("material", jar.material);
  out.fields(jar.elastic, elastic_fields());
  out.fields(jar.substance, substance_fields());
  out.fields(jar, std::array{wall_density, wall_thickness});
}

void write_distribution(Writer& out, const Distribution& d) {
  using Law = Distribution::Law;
  out.word("distribution", distribution_words()[static_cast<std::size_t>(d.law)]);
  if (d.law == Law::sieves) {
    out.line("passing", passing_text(d.passing));
    return;
  }
  if (d.law == Law::uniform) {
    out.number("smallest", d.smallest, "m");
    out.number("largest", d.largest, "m");
  } else {
    out.number("diameter", d.diameter, "m");
    out.number("spread", d.spread, "");
  }
  out.line("classes", std::to_string(d.classes));
}

void write_balls(Writer& out, const std::vector<BallSet>& balls) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls[i].grains) continue;  // [powder] says them
    out.section("[[balls]]", fmt::format("balls.{}.", i + 1));
    if (balls[i].positions.empty())
      out.line("count", std::to_string(balls[i].count));
    else
      out.line("positions", places_text(balls[i].positions));
    if (balls[i].distribution.law == Distribution::Law::equal)
      out.number("diameter", balls[i].diameter, "m");
    else
      write_distribution(out, balls[i].distribution);
    out.number("density", balls[i].density, "kg/m3");
    out.name("material", balls[i].material);
    out.fields(balls[i].elastic, elastic_fields());
    out.fields(balls[i].substance, substance_fields());
  }
}

void write_powder(Writer& out, const Powder& powder, const std::vector<BallSet>& balls) {
  out.section("[powder]", "powder.");
  out.name("material", powder.material);
  out.number("mass", powder.mass, "kg");
  write_feed(out, powder);
  if (powder.density) out.number("density", *powder.density, "kg/m3");
  if (!powder.grain_size) return;
  out.word("as", "grains");
  out.number("grain_size", *powder.grain_size, "m");
  out.fields(balls.back().elastic, elastic_fields());
  out.fields(balls.back().substance, substance_fields());
}

void write_rule(Writer& out, const contact::BounceRule& rule) {
  const contact::Restitution& e = rule.restitution;
  using Law = contact::Restitution::Law;
  out.word("restitution_law", restitution_laws()[static_cast<std::size_t>(e.law())]);
  if (e.law() == Law::tabulated)
    out.line("restitution_table", table_text(e));
  else
    out.number("restitution", e.value(), "");
  if (e.law() == Law::viscoelastic) out.number("restitution_speed", e.speed(), "m/s");
  const bool coulomb = std::isfinite(rule.friction);
  out.word("bounce", coulomb ? "walton" : "constant");
  out.number("tangential_restitution", rule.tangential_restitution, "");
  if (coulomb) out.number("friction", rule.friction, "");
}

template <class Owner>
void write_touch(Writer& out, const Owner& owner, const contact::ContactModel& model) {
  for (const auto& f : touch_fields<Owner>())
    if (has_meaning(f.key, model)) out.number(f.key, owner.*f.value, unit_of(f.key, f.unit, model));
}

template <class L>
void write_law_fields(Writer& out, const L& law) {
  for (const auto& f : L::fields())
    if (contact::is_given(law, f)) out.number(f.key, law.*f.value, f.unit);
}

template <class L>
void write_switches(Writer& out, const L& law) {
  for (const auto& s : contact::switches_of<L>()) out.word(s.key, s.words[law.*s.second ? 1 : 0]);
}

void write_model(Writer& out, const contact::ContactModel& model) {
  out.word("law", contact::name_of(model.law));
  out.word("rolling", contact::rule_of(model.rolling).name);
  std::visit([&](const auto& law) { write_switches(out, law); }, model.law);
  if (has_meaning(rolling_damping.key, model))
    out.number(rolling_damping.key, model.rolling_damping, rolling_damping.unit);
  std::visit([&](const auto& law) { write_law_fields(out, law); }, model.law);
  out.line("curved_walls", model.curved_walls ? "true" : "false");
  out.line("rescaled_unloading", model.rescaled_unloading ? "true" : "false");
}

void write_contact(Writer& out, const Contact& contact) {
  out.section("[contact]", "contact.");
  write_model(out, contact.model);
  write_rule(out, contact.rule);
  write_touch(out, contact, contact.model);
  out.fields(contact, contact_fields());
  out.word("lasting", lasting_words()[static_cast<std::size_t>(contact.lasting)]);
  for (std::size_t i = 0; i < contact.pairs.size(); ++i) {
    out.section("[[contact.pairs]]", fmt::format("contact.pairs.{}.", i + 1));
    out.line("between", between_text(contact.pairs[i]));
    write_rule(out, contact.pairs[i].rule);
    write_touch(out, contact.pairs[i], contact.model);
  }
}

void write_run(Writer& out, const Run& run) {
  out.section("[run]", "run.");
  out.word("engine", name_of(run.engine));
  if (run.until) {
    out.word("time", fmt::format("until {}", show(run.until->within, "")));
    out.word("until", run.until->quantity);
  }
  for (const auto& field : run_fields())
    if (run.until && field.value == &Run::time)
      out.number(longest.key, run.time, longest.unit);
    else
      out.number(field.key, run.*field.value, field.unit);
  out.word("start_frame", start_frames()[static_cast<std::size_t>(run.start_frame)]);
  if (run.time_step)
    out.number("time_step", *run.time_step, "s");
  else
    out.number(step_share.key, run.time_step_fraction, step_share.unit);
  out.line("hop", run.hop ? "true" : "false");
  out.line("replicates", std::to_string(run.replicates));
}

void write_wear(Writer& out, const Wear& wear) {
  out.section("[wear]", "wear.");
  out.word("model", wear_models()[static_cast<std::size_t>(wear.model)]);
  out.number(wear_coefficient.key, wear.coefficient, wear_coefficient.unit);
}

void write_heat(Writer& out, const Heat& heat) {
  out.section("[heat]", "heat.");
  out.fields(heat, std::array{cycle_milling, pause_time});
  out.line("cycles", std::to_string(heat.cycles));
  out.fields(heat, heat_fields());
}

void write_fit(Writer& out, const std::map<std::string, FitRange>& fit) {
  if (fit.empty()) return;
  out.section("[fit]", "fit.");
  for (const auto& [key, ends] : fit)
    out.plain(
        fmt::format("{} = [{}, {}]\n", in_quotes(key), in_quotes(ends[0]), in_quotes(ends[1])));
}

}  // namespace

std::string write(const Case& c) {
  Writer out(c);
  out.word("title", c.title);
  const bool fits = c.seed <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  out.line("seed", fits ? std::to_string(c.seed) : in_quotes(std::to_string(c.seed)));
  out.fields(c, case_fields());
  write_mill(out, c.mill);
  write_jar(out, c.jar);
  write_balls(out, c.balls);
  if (c.powder) write_powder(out, *c.powder, c.balls);
  write_contact(out, c.contact);
  write_run(out, c.run);
  out.section("[observe]", "observe.");
  out.fields(c.observe, observe_fields());
  out.line("collisions", c.observe.collisions ? "true" : "false");
  if (c.observe.frames) out.number("frames", *c.observe.frames, "s");
  out.word("frames_format", frames_formats()[static_cast<std::size_t>(c.observe.frames_format)]);
  if (c.wear) write_wear(out, *c.wear);
  if (c.heat) write_heat(out, *c.heat);
  write_grinding(out, c);
  write_sweep(out, c);
  write_fit(out, c.fit);
  return out.text();
}

std::string contents_of_files(const Case& c) {
  std::string bytes;
  const auto add = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  if (const auto* mesh = std::get_if<geometry::Mesh>(&c.jar.shape)) {
    for (const Vec3& point : mesh->surface().points) add(point);
    for (const auto& triangle : mesh->surface().triangles) add(triangle);
  }
  if (const auto* measured = std::get_if<kinematics::Tabulated>(&c.mill.motion))
    for (const kinematics::Sample& sample : measured->samples()) add(sample);
  return fmt::format("# files {:016x}\n", fingerprint(bytes));
}

}  // namespace mahlwerk::cases
