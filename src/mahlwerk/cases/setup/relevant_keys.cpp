// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The values of a case that its results depend on: marks assumptions and finds ignored keys.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::cases {
namespace {

/// The last part of a dotted key.
std::string_view name_in(std::string_view dotted) {
  return dotted.substr(dotted.rfind('.') + 1);  // npos + 1 == 0 without a dot
}

/// Lists the keys of a case that an engine does not read.
class UnreadKeys : public CaseVisitor {
 public:
  UnreadKeys(Case& c, EngineName engine) : engine_(engine) {
    // The event engine reads elastic constants for capture and twisting friction (evt.24) only.
    elastic_unread_ = engine == EngineName::event && !c.capture &&
                      c.contact.model.twisting == contact::Twisting::none;
    if (engine != EngineName::automatic) describe(*this, c);  // "auto" may read all values
  }

  bool contain(std::string_view dotted) const { return keys_.contains(dotted); }

  void section(std::string_view name, std::size_t number) override {
    prefix_ = name.empty()  ? ""
              : number == 0 ? fmt::format("{}.", name)
                            : fmt::format("{}.{}.", name, number);
  }
  void number(const NumberSpec& spec, double&) override {
    const bool elastic = spec.key == "youngs_modulus" || spec.key == "poisson_ratio";
    note(spec.key, elastic && elastic_unread_ ? soft_and_lammps : spec.engines);
  }
  void optional_number(const NumberSpec& spec, std::optional<double>&) override {
    note(spec.key, spec.engines);
  }
  void integer(const IntegerSpec&, std::int64_t&) override {}
  void flag(const Flag& flag, bool&) override { note(flag.key, flag.engines); }
  void text(const TextSpec&, std::string&) override {}
  bool choose(const Choice& choice, std::size_t&) override {
    note(choice.key, choice.engines);
    return true;
  }
  void custom(const CustomKey&, const std::function<std::string()>&) override {}

 private:
  void note(std::string_view key, Engines engines) {
    const bool read = engine_ == EngineName::event  ? engines.event
                      : engine_ == EngineName::soft ? engines.soft
                                                    : engines.lammps;
    if (!read) keys_.insert(prefix_ + std::string(key));
  }

  EngineName engine_;
  bool elastic_unread_ = false;
  std::string prefix_;
  std::set<std::string, std::less<>> keys_;
};

/// Whether a value is needed. Properties of materials that the motion of the balls does not depend
/// on are needed by parts only.
bool is_relevant(std::string_view dotted, const Case& c) {
  const std::string_view key = name_in(dotted);
  const bool of_parts = key == "hardness" || key == "conductivity" || key == "heat_capacity" ||
                        dotted == "jar.wall" || dotted == "jar.density";
  if (!of_parts) return true;
  // A default yield pressure follows from the hardness.
  const auto* law =
      std::get_if<contact::ThorntonNing>(&static_cast<const contact::Laws&>(*c.contact.model.law));
  if (key == "hardness" && law != nullptr && law->yield_pressure == 0) return true;
  return std::ranges::any_of(parts_of(c), [&](const Part* part) {
    return part->needs != nullptr && part->needs(c, dotted);
  });
}

}  // namespace

void drop_irrelevant_assumptions(Case& c) {
  const UnreadKeys unread(c, c.run.engine);
  for (Origin& origin : c.origins) {
    const bool asked = is_relevant(origin.key, c);
    origin.assumed = origin.assumed && asked && !unread.contain(origin.key);
    origin.unverified = origin.unverified && asked;
  }
}

namespace {

/// Where the event engine has no twisting friction although the case asks for it.
Notices free_twisting(const Case& c, EngineName engine) {
  if (engine != EngineName::event || c.contact.model.twisting == contact::Twisting::none ||
      c.contact.lasting != SustainedContactModel::tc)
    return {};
  return {note("twisting-in-impacts",
               "The event engine has twisting friction in impacts only: bodies in a sustained "
               "contact, which is a series of small bounces (lasting = \"tc\"), turn freely about "
               "the normal. engine = \"soft\" has it there, too.")};
}

}  // namespace

Notices ignored_keys(const Case& c, EngineName engine) {
  std::string keys;
  Notices notes = free_twisting(c, engine);
  Case copy = c;  // describe() needs a mutable case; UnreadKeys does not change it
  const UnreadKeys unread(copy, engine);
  for (const Origin& origin : c.origins) {
    const bool given =
        !origin.source.starts_with("default: ") && !origin.source.starts_with("catalogue");
    if (given && unread.contain(origin.key)) keys += (keys.empty() ? "" : ", ") + origin.key;
  }
  if (!keys.empty())
    notes.push_back(note(
        "ignored-keys", fmt::format("The {} engine, which ran, ignores these keys of the case: {}.",
                                    name_of(engine), keys)));
  return notes;
}

}  // namespace mahlwerk::cases
