// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/kinetics/section.hpp"

#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/powder/models.hpp"

namespace mahlwerk::parts::kinetics {

using namespace cases;  // the words of sections

namespace {

/// A number with a default, or one that must be measured on the powder.
void describe_conversion(KeyVisitor& v, const NumberSpec& spec, double& value) {
  SectionReader* in = v.reader();
  if (in == nullptr || in->gives(spec.key) || spec.standard) return v.number(spec, value);
  in->missing(spec.key, spec.about,
              fmt::format("write for instance {} = \"{}\", or let `mahlwerk fit` find it from "
                          "measurements",
                          spec.key, example_of(spec.unit)));
}

/// Numbers of a model by their keys.
template <class M>
class ModelNumbers {
 public:
  ModelNumbers(KeyVisitor& v, M& model) : v_(v), model_(model) {}

  static NumberSpec spec(std::string_view key) {
    for (const auto& field : M::fields())
      if (field.key == key) return NumberSpec(field);
    throw std::logic_error("no such field");
  }
  double& value(std::string_view key) {
    for (const auto& field : M::fields())
      if (field.key == key) return model_.*field.value;
    throw std::logic_error("no such field");
  }
  void number(std::string_view key) { number(spec(key)); }
  void number(const NumberSpec& s) { describe_conversion(v_, s, value(s.key)); }
  /// Numbers that have a meaning only if `meaningful`; refused otherwise.
  void numbers(bool meaningful, std::initializer_list<std::string_view> keys, std::string_view why,
               const std::string& remedy) {
    if (!meaningful) return v_.refuse(keys, why, remedy);
    for (const std::string_view key : keys) number(key);
  }

 private:
  KeyVisitor& v_;
  M& model_;
};

/// A model whose numbers always have a meaning.
template <class M>
void describe_model(KeyVisitor& v, M& m, Kinetics&, const Case&) {
  for (const auto& field : M::fields()) describe_conversion(v, NumberSpec(field), m.*field.value);
}

void describe_model(KeyVisitor& v, powder::DoseKinetics& m, Kinetics&, const Case&) {
  std::size_t avrami = m.exponent != 1 ? 1 : 0;
  v.choose({"law",
            {"first-order", "avrami"},
            "first-order",
            "the simplest law",
            "conversion as a function of the dose",
            {"rate in proportion to what is not converted", "Avrami's law, with an exponent"}},
           avrami);
  for (const auto& field : powder::DoseKinetics::fields())
    if (avrami || field.value != &powder::DoseKinetics::exponent)
      describe_conversion(v, NumberSpec(field), m.*field.value);
  if (!avrami)
    v.refuse({"exponent"}, "under law = \"first-order\"", "remove it, or write law = \"avrami\"");
}

/// Powder that a hit captures, and its energy, where no [capture] gives them.
void describe_hits(KeyVisitor& v, Kinetics& k, const Case& c) {
  if (c.capture && !v.visits_all())
    return v.refuse({"mass_per_hit", "energy"}, "with [capture], which gives it",
                    "remove it, or remove [capture]");
  v.optional_number(NumberSpec("mass_per_hit", "kg", positive, "powder that each hit captures")
                        .with_default_text("by [capture]"),
                    k.mass_per_hit);
  v.word({"energy",
          {"normal", "contact-point", "lost"},
          "normal",
          "the part along the line of centres; sliding does not press",
          "energy of a hit; without [capture], which has a key of its own",
          {"kinetic energy of the approach along the line of centres",
           "kinetic energy of the relative motion at the contact point",
           "energy that the collision dissipates"}},
         k.hit_energy);
}

void describe_model(KeyVisitor& v, powder::ImpactKinetics& m, Kinetics& k, const Case& c) {
  ModelNumbers numbers(v, m);
  v.word({"scheme",
          {"simple", "sequential", "parallel"},
          "simple",
          "one reaction",
          "reactions of the powder",
          {"A -> B", "A -> B -> C, each by a hit", "A -> B and A -> C"}},
         m.scheme);
  for (const std::string_view key : {"processed_share", "threshold_energy", "energy_exponent"})
    numbers.number(key);
  numbers.numbers(m.energy_exponent != 0 || v.tries_all_words(), {"reference_energy"},
                  "without `energy_exponent`", "remove it, or write energy_exponent = 1 or so");
  numbers.numbers(m.has_second(), {"second_share", "second_threshold"}, "under scheme = \"simple\"",
                  "remove it, or write scheme = \"sequential\" or \"parallel\"");
  if (!m.has_second())
    v.integer({"hits_needed", 1, powder::ImpactKinetics::most_hits,
               "hits that convert a part of the powder", 1, "one hit converts"},
              m.hits_needed);
  else
    v.refuse({"hits_needed"}, "under this scheme", "remove it, or write scheme = \"simple\"");
  describe_hits(v, k, c);
}

/// The temperature of the powder.
void describe_temperature(KeyVisitor& v, Kinetics& k, const Case& c) {
  v.optional_number(NumberSpec("temperature", "K", positive, "constant temperature of the powder")
                        .with_default_text("by [heat]"),
                    k.temperature);
  if (k.temperature || !(c.heat || v.visits_all()))
    return v.refuse({"temperature_of"}, "without [heat] or with `temperature`", "remove it");
  v.word({"temperature_of",
          {"balls", "jar"},
          "balls",
          "powder is hit by balls",
          "part of the mill whose temperature by [heat] the powder has",
          {"the balls", "the jar"}},
         k.temperature_of);
}

void describe_model(KeyVisitor& v, powder::ThermalKinetics& m, Kinetics& k, const Case& c) {
  using Attempts = powder::ThermalKinetics::Attempts;
  ModelNumbers numbers(v, m);
  v.word({"attempts",
          {"by-time", "by-impact"},
          "by-time",
          "as in a flask",
          "what the frequency factor is in proportion to",
          {"time, with the pauses of the mill", "collisions above the threshold of [observe]"}},
         m.attempts);
  numbers.numbers(m.attempts == Attempts::by_time, {"frequency_factor"},
                  "under attempts = \"by-impact\"", "give `factor_per_impact`");
  numbers.numbers(m.attempts == Attempts::by_impact, {"factor_per_impact"},
                  "under attempts = \"by-time\"", "give `frequency_factor`");
  for (const std::string_view key : {"activation_energy", "activation_volume", "stress"})
    numbers.number(key);
  describe_temperature(v, k, c);
}

void describe_model(KeyVisitor& v, powder::IgnitionKinetics& m, Kinetics& k, const Case& c) {
  using Trigger = powder::IgnitionKinetics::Trigger;
  ModelNumbers numbers(v, m);
  v.word({"trigger",
          {"dose", "temperature"},
          "dose",
          "the simplest criterion",
          "what ignites the powder",
          {"a critical dose of energy",
           "its temperature, once it exceeds an ignition temperature that milling lowers"}},
         m.trigger);
  const bool by_dose = m.trigger == Trigger::dose;
  numbers.numbers(by_dose, {"ignition_dose"}, "under trigger = \"temperature\"",
                  "give `ignition_temperature`");
  numbers.numbers(!by_dose,
                  {"ignition_temperature", "milled_temperature", "activation_dose", "flash_rise"},
                  "under trigger = \"dose\"", "remove it, or write trigger = \"temperature\"");
  numbers.number("converted_share");
  if (!by_dose)
    describe_temperature(v, k, c);
  else
    v.refuse({"temperature", "temperature_of"}, "under trigger = \"dose\"",
             "remove it, or write trigger = \"temperature\"");
}

/// A property that changes from an initial to a final value with conversion.
void describe_property(KeyVisitor& v, Kinetics& k) {
  v.text({"property", "name of a property that changes in proportion to conversion"}, k.property);
  if (k.property.empty() && !v.visits_all())
    return v.refuse({"initial", "final"}, "without `property`",
                    "remove it, or write property = \"amorphous content\" or so");
  v.number({"initial", "", any_number, "the property before milling, in its own unit"}, k.initial);
  v.number({"final", "", any_number, "the property after complete conversion"}, k.final);
}

}  // namespace

void describe(KeyVisitor& v, Kinetics& k, const Case& c) {
  if (!v.model({.key = "model",
                .words = {},
                .standard = "dose",
                .source = "needs the fewest constants",
                .about = "what converts the powder"},
               *k.model))
    return v.ignore_unknown_keys();
  std::visit([&](auto& model) { describe_model(v, model, k, c); }, *k.model);
  v.word({"dose",
          {"dissipated", "captured"},
          "dissipated",
          "all energy that collisions lose",
          "energy that counts as dose, by mass of powder",
          {"all energy that collisions dissipate", "energy that captured powder receives"}},
         k.dose);
  describe_milling_time(v, {"time", "s", positive, "milling time"}, k.time);
  v.optional_number(NumberSpec("molar_mass", "kg/mol", positive,
                               "molar mass of the powder, for doses by amount of substance")
                        .with_default_text("no such doses"),
                    k.molar_mass);
  describe_property(v, k);
}

}  // namespace mahlwerk::parts::kinetics
