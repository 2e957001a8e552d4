// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <variant>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/contact/contact_model.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/report/methods_milling.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {
namespace {

using cases::Case;

class MethodsText {
 public:
  explicit MethodsText(const Case& c) : c_(c) {}

  /// A value as text, with an asterisk if the key was assumed.
  std::string marked(std::string_view key, std::string_view words) const {
    const auto origin = std::ranges::find(c_.origins, key, &cases::Origin::key);
    const bool assumed = origin != c_.origins.end() && origin->assumed;
    return std::string(words) + (assumed ? "*" : "");
  }
  std::string value(std::string_view key, double v, std::string_view unit) const {
    return marked(key, show_rounded(v, unit));
  }
  /// "orbit radius 70 mm, speed 400 rpm": the numbers of a model.
  template <class Model>
  std::string numbers(std::string_view section, const Model& model) const {
    std::string words;
    for (const auto& field : model.fields()) {
      constexpr std::array otherwise{"fracture_energy", "t10", "cut"};  // 0: not used
      if (model.*field.value == 0 && std::ranges::find(otherwise, field.key) != otherwise.end())
        continue;
      std::string name(field.key);
      constexpr std::array symbols{"f_mat", "x_w_min", "x_e_min", "d_0", "e_infinity"};
      if (std::ranges::find(symbols, field.key) == symbols.end())
        std::ranges::replace(name, '_', ' ');
      words += fmt::format(
          "{}{} {}", words.empty() ? "" : ", ", name,
          value(fmt::format("{}.{}", section, field.key), model.*field.value, field.unit));
    }
    return words;
  }

  std::string mill() const {
    const auto [kind, numbers_of] = std::visit(
        [&](const auto& m) { return std::pair(std::string(m.name), numbers("mill", m)); },
        *c_.mill.motion);
    const auto [shape, sizes] =
        std::visit([&](const auto& s) { return std::pair(std::string(s.name), numbers("jar", s)); },
                   *c_.jar.shape);
    const auto plain = [](std::string text) {
      std::ranges::replace(text, '_', ' ');
      std::ranges::replace(text, '-', ' ');
      return text;
    };
    const std::string text =
        fmt::format("Mill: {}{}{}{}. ", plain(kind),
                    c_.mill.model.empty() ? "" : fmt::format(" ({})", c_.mill.model),
                    numbers_of.empty() ? "" : ", ", numbers_of);
    const double volume = geometry::volume(*c_.jar.shape);
    return text + fmt::format("Jar: {}{}{}{}, volume {} ml{}. ", plain(shape),
                              c_.jar.model.empty() ? "" : fmt::format(" ({})", c_.jar.model),
                              sizes.empty() ? "" : ", ", sizes, fmt::format("{:.3g}", volume * 1e6),
                              c_.jar.material.empty() ? "" : ", " + c_.jar.material);
  }

  /// The parts in the jar: "rotor (cylinder, turning)".
  std::string bodies() const {
    static constexpr std::array motions{"fixed", "turning", "oscillating", "swinging", "tabulated"};
    constexpr std::size_t most = 8;
    std::string list;
    for (std::size_t i = 0; i < std::min(most, c_.machine_parts.size()); ++i) {
      const cases::MachinePart& part = c_.machine_parts[i];
      list += fmt::format("{}{} ({}, {})", i > 0 ? ", " : "", part.name,
                          geometry::name_of(*part.body.solid),
                          motions[static_cast<std::size_t>(part.body.motion.kind)]);
    }
    if (list.empty()) return "";
    const std::size_t more = c_.machine_parts.size() - std::min(most, c_.machine_parts.size());
    return fmt::format("Parts in the jar: {}{}. ", list,
                       more > 0 ? fmt::format(" and {} more", more) : "");
  }

  std::string drive() const {
    const kinematics::SpeedProgram& program = c_.mill.speed_over_time;
    if (!program.empty())
      return fmt::format(
          "The speed that is stated is the full one; it changed over time{}{}, as the case gives "
          "it. ",
          program.reverses() ? ", in both senses" : "",
          program.repeats() ? fmt::format(", again every {}", show_rounded(program.end(), "s"))
                            : "");
    if (!c_.drive) return "";
    const kinematics::Motor& m = *c_.drive;
    const std::string inertia = value("drive.inertia", m.inertia, "kg m2");
    const std::string_view what = cases::drum_motion(c_) != nullptr ? "jar" : "stirrer";
    if (m.torque == 0)
      return fmt::format("The {}, of a moment of inertia of {}, turns freely from {:.4g} rad/s. ",
                         what, inertia, m.start_speed);
    return fmt::format(
        "A motor turns the {}, of a moment of inertia of {}; the speed that is stated is that "
        "without load. Its torque {} {}. ",
        what, inertia,
        m.kind == kinematics::Motor::Kind::linear ? "falls linearly from standstill, from"
                                                  : "follows the formula of Kloss, with at most",
        value("drive.torque", m.torque, "N m"));
  }

  std::string flow() const {
    if (!c_.flow) return "";
    const cases::Flow& f = *c_.flow;
    static constexpr std::array feeds{"", " at an inlet", " at an inlet at a rate"};
    const char* how = feeds[static_cast<std::size_t>(f.feed)];
    std::string sets;
    for (const std::string& name : f.fresh_feed) sets += (sets.empty() ? "" : ", ") + name;
    return fmt::format(
        "Balls that pass an outlet leave the jar{}{}. {}",
        cases::flow_in_jar_frame(c_).returns && *how != 0 ? ", and enter it again" : "",
        sets.empty() ? how : "",
        sets.empty()
            ? ""
            : fmt::format("Those of {} are outside at the start and enter{}. ", sets, how));
  }

  /// "cylpebs of 15 mm across and 15 mm long, rigid clumps of up to 21 spheres"
  std::string bodies(const cases::BallSet& set, const std::string& key) const {
    static constexpr std::array names{"spheres", "cylpebs", "rods", "cubes", "ellipsoids"};
    const cases::BallShape& b = set.body;
    if (b.kind == cases::BallShape::Kind::clump)
      return fmt::format("rigid clumps of {} spheres", b.members.size());
    const std::string sizes = b.kind == cases::BallShape::Kind::cube
                                  ? value(key + "edge", b.edge, "m") + ", edges rounded to " +
                                        value(key + "rounding", b.rounding, "m")
                                  : value(key + "diameter", b.diameter, "m") + " across and " +
                                        value(key + "length", b.length, "m") + " long";
    const char* name = names[static_cast<std::size_t>(b.kind)];
    if (b.is_convex()) return fmt::format("{} of {}, rounded convex bodies", name, sizes);
    return fmt::format("{} of {}, rigid clumps of up to {} spheres", name, sizes, b.spheres);
  }

  std::string charge() const {
    std::string text;
    for (std::size_t i = 0; i < c_.balls.size(); ++i) {
      const cases::BallSet& set = c_.balls[i];
      const std::string key = fmt::format("balls.{}.", i + 1);
      text += fmt::format(
          "{}: {} {}{}, density {}{}{}. ", set.grains ? "Powder as grains" : "Balls", set.count,
          set.body.is_sphere() ? fmt::format("spheres of {}{}", set.classes.empty() ? "" : "mean ",
                                             value(key + "diameter", set.diameter, "m"))
                               : bodies(set, key),
          set.material.empty() ? "" : ", " + set.material,
          value(key + "density", set.density, "kg/m3"),
          set.wall_thickness ? ", hollow with a shell of " +
                                   value(key + "wall_thickness", *set.wall_thickness, "m")
                             : "",
          set.coating_thickness
              ? fmt::format(
                    ", with a coating of {} and {}",
                    value(key + "coating_thickness", *set.coating_thickness, "m"),
                    value(key + "coating_density", set.coating_density.value_or(0), "kg/m3"))
              : "");
    }
    if (c_.powder && c_.powder->mass > 0)
      text += fmt::format("Powder: {:.4g} g{}{}. ", 1000 * c_.powder->mass,
                          c_.powder->material.empty() ? "" : " of " + c_.powder->material,
                          c_.powder->grain_size ? "" : ", not simulated itself");
    return text;
  }

  std::string liquid() const {
    if (!c_.liquid) return "";
    const contact::Liquid& l = c_.liquid->model;
    const std::string name = c_.liquid->material.empty() ? "a liquid" : c_.liquid->material;
    const std::string viscosity = value("liquid.viscosity", l.viscosity, "Pa s");
    const std::string where =
        l.flooded ? fmt::format(
                        "The jar was full of {} (viscosity {}, density {}), which turned "
                        "with it",
                        name, viscosity, value("liquid.density", l.density, "kg/m3"))
                  : fmt::format("Balls and wall carried films of {} (viscosity {}, thickness {})",
                                name, viscosity, value("liquid.film", l.film, "m"));
    return fmt::format("{}; lubrication ended at a separation of {}. ", where,
                       value("liquid.roughness", l.roughness, "m"));
  }

  /// "barrios (fracture energy 1 kJ/kg)"
  template <class AnyModel>
  std::string model(std::string_view section, const AnyModel& any) const {
    return std::visit(
        [&](const auto& m) {
          const std::string words = numbers(section, m);
          return std::string(m.name) + (words.empty() ? "" : " (" + words + ")");
        },
        any);
  }

  std::string powder() const {
    if (!c_.capture) return "";
    constexpr std::array energies{"of the normal motion", "at the contact points",
                                  "that is dissipated"};
    std::string text = fmt::format(
        "The effect of the collisions on the powder was computed after the motion. Collisions "
        "capture grains by the model {}; captured grains receive {} of the energy {}. ",
        model("capture", *c_.capture->model),
        marked("capture.energy_share", fmt::format("{:.4g} %", 100 * c_.capture->energy_share)),
        energies[static_cast<std::size_t>(c_.capture->energy)]);
    if (!c_.grinding) return text;
    const cases::Grinding& g = *c_.grinding;
    constexpr std::array methods{"a population balance", "a sample of {} grains",
                                 "a population balance and a sample of {} grains"};
    text += fmt::format(
        "Grains break by {}, into pieces by {}; sizes after {} of milling by {}, {}",
        model("breakage", *g.breakage), model("fragments", *g.fragments), show_rounded(g.time, "s"),
        fmt::format(fmt::runtime(methods[static_cast<std::size_t>(g.method)]), g.sample),
        g.bed == powder::Bed::mixed ? "in mixed beds" : "each bed of one size");
    if (g.sticking > 0) text += fmt::format(", {:.4g} % of the grains stuck", 100 * g.sticking);
    if (g.welding > 0)
      text += fmt::format(", welding with a probability of {:.4g} per impact", g.welding);
    return text + ". ";
  }

  std::string kinetics() const {
    if (!c_.kinetics) return "";
    const cases::Kinetics& k = *c_.kinetics;
    const auto* dose = std::get_if<powder::DoseKinetics>(&*k.model);
    if (dose == nullptr)
      return fmt::format("Conversion after {} of milling by the model {}. ",
                         show_rounded(k.time, "s"), model("kinetics", *k.model));
    return fmt::format(
        "Conversion after {} of milling: 1 - exp(-((D - {})/({}))^{:.4g}) of the dose D of energy "
        "{} by mass of powder. ",
        show_rounded(k.time, "s"), value("kinetics.onset", dose->onset, "J/kg"),
        value("kinetics.dose_constant", dose->dose_constant, "J/kg"), dose->exponent,
        k.dose == cases::Kinetics::Dose::captured ? "captured" : "dissipated");
  }

  std::string contact(cases::EngineName engine) const {
    const contact::BounceRule& rule = c_.contact.rule;
    std::string text =
        fmt::format("Contacts: restitution {}",
                    marked("contact.restitution", fmt::format("{:.4g}", rule.restitution.value())));
    text += std::isfinite(rule.friction)
                ? ", friction " + marked("contact.friction", fmt::format("{:.4g}", rule.friction))
                : ", no Coulomb limit in bounces";
    if (engine == cases::EngineName::event)
      text +=
          ", tangential restitution " + marked("contact.tangential_restitution",
                                               fmt::format("{:.4g}", rule.tangential_restitution));
    text += ", rolling friction " +
            marked("contact.rolling_friction", fmt::format("{:.4g}", c_.contact.rolling_friction));
    if (!c_.contact.pairs.empty())
      text += fmt::format(", with {} exceptions by pair", c_.contact.pairs.size());
    return text + ". ";
  }

 private:
  const Case& c_;
};

std::string engine_words(const Case& c, cases::EngineName engine) {
  if (engine == cases::EngineName::event)
    return "an event-driven simulation of rough hard spheres with exact free flight and "
           "instantaneous collisions";
  const contact::ContactModel& model = c.contact.model;
  return fmt::format("the discrete element method (soft spheres, law {}, rolling {}){}",
                     contact::name_of(*model.law), contact::rule_of(model.rolling).name,
                     engine == cases::EngineName::lammps ? " in LAMMPS" : "");
}

/// "5 replicates of 60 s each were counted after 0.8 s of settling, from ...".
std::string extent_words(const CountedRuns& runs, const Case& c) {
  const bool one = runs.replicates == 1;
  const std::string settling = !runs.settling ? " after the mill had settled"
                               : *runs.settling > 0
                                   ? fmt::format(" after {:.4g} s of settling", *runs.settling)
                                   : "";
  if (runs.replicates == 0) return "The run was interrupted before anything was counted.";
  const std::string ramp =
      c.run.start == cases::StartLayout::ramp
          ? fmt::format(", while the mill came to its speed within {:.4g} s", c.run.ramp_time)
          : "";
  return fmt::format(
      "{} of {:.4g} s each {} counted{}, from random starts (seed {}){}; intervals are 95 % "
      "confidence, by Student's t over replicates{}.",
      one ? "One replicate" : fmt::format("{} replicates", runs.replicates), runs.time,
      one ? "was" : "were", settling, c.seed, ramp,
      one ? " or, of one alone, by batch means over time" : "");
}

}  // namespace

std::string methods(const Case& c, cases::EngineName engine, const CountedRuns& runs,
                    std::string_view version) {
  const MethodsText say(c);
  std::string text = fmt::format("The mill was simulated with Mahlwerk {} by {}. ", version,
                                 engine_words(c, engine));
  text += say.mill() + say.bodies() + say.drive() + say.flow() + say.charge() +
          say.contact(engine) + say.liquid() + say.powder() + say.kinetics() + milling_words(c) +
          extent_words(runs, c);
  if (text.find('*') != std::string::npos)
    text += " * Assumed, not measured: a default of the program.";
  return text;
}

std::string methods(const results::Outcome& outcome, std::string_view version) {
  const auto chosen = results::averaged_replicates(outcome);
  const auto mean = [&](const auto& of) { return results::mean_over(chosen, of); };
  return methods(outcome.mill_case, outcome.engine,
                 {.replicates = chosen.size(),
                  .time = mean([](const results::Replicate& r) { return r.time(); }),
                  .settling = mean([](const results::Replicate& r) { return r.at_settled.time; })},
                 version);
}

}  // namespace mahlwerk::report
