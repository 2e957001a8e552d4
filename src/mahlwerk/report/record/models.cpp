// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "mahlwerk/cases/mill_power.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/contact_model.hpp"
#include "mahlwerk/contact/rolling.hpp"
#include "mahlwerk/contact/twisting.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/powder/any_model.hpp"

namespace mahlwerk::report {
namespace {

using cases::Case, cases::EngineName;

constexpr std::string_view rigid = "kinematics of a rigid body";

// What the theory pages (docs/theory) cite.
const std::vector<CitedModel> models{
    {"motion of balls", "one-ball event", {"chen2016"}},
    {"motion of balls", "many-ball event", {"lubachevsky1991", "bannerman2014"}},
    {"motion of balls", "soft", {"cundall1979"}},
    {"motion of balls", "lammps", {"cundall1979", "thompson2022"}},

    {"mill motion", "still", {}, rigid},
    {"mill motion", "vibration", {}, rigid},
    {"mill motion", "planetary", {"burgio1991"}},
    {"mill motion", "tumbling", {}, rigid},
    {"mill motion", "arc-shaker", {}, rigid},
    {"mill motion", "figure-eight", {}, rigid},
    {"mill motion", "circular", {}, rigid},
    {"mill motion", "tabulated", {}, "measured by the user"},

    {"contact law", "hertz-mindlin", {"mindlin1949", "mhadhbi2021"}},
    {"contact law", "hertz-tsuji", {"tsuji1992", "mindlin1949"}},
    {"contact law", "linear-spring", {"cundall1979"}},
    {"contact law", "adams-impact", {"mhadhbi2021"}},
    {"contact law", "walton-braun", {"walton1986"}},
    {"contact law", "jkr", {"johnson1971", "mindlin1949"}},
    {"contact law", "sjkr", {"kloss2012", "mindlin1949"}},
    {"contact law", "thornton-ning", {"thornton1997", "thornton1998"}},
    {"contact law", "capillary", {"willett2000", "lian1993", "mindlin1949"}},

    {"tangential spring", "full-stiffness", {"luding2008"}},
    {"tangential spring", "partial-slip", {"mindlin1953", "walton1986", "thornton1991"}},

    {"rolling resistance", "none", {}, "no model"},
    {"rolling resistance", "cdt", {"ai2011"}},
    {"rolling resistance", "viscous", {"ai2011"}},
    {"rolling resistance", "epsd", {"ai2011"}},
    {"rolling resistance", "own-spin", {"mhadhbi2021"}},

    {"twisting friction", "none", {}, "no model"},
    {"twisting friction", "marshall", {"marshall2009"}},

    {"bounce rule", "constant", {"chen2016"}},
    {"bounce rule", "walton", {"walton1993", "foerster1994"}},

    {"restitution", "constant", {}, "a number of the user"},
    {"restitution", "viscoelastic", {"ramirez1999"}},
    {"restitution", "tabulated", {}, "measured by the user"},

    {"sustained contacts", "roll", {"dormand1980"}},
    {"sustained contacts", "tc", {"luding1998"}},
    {"sustained contacts", "none", {}, "no model"},

    {"liquid", "film", {"davis1986", "barnocky1988"}},
    {"liquid", "flooded", {"davis1986", "barnocky1988", "schiller1933"}},

    {"capture", "barrios", {"barrios2011"}},
    {"capture", "trapped-volume", {"maurice1990"}},
    {"capture", "surface-layer", {"magini1996"}},
    {"capture", "fixed", {}, "a number of the user"},

    {"breakage", "vogel-peukert", {"vogel2003"}},
    {"breakage", "shi-kojovic", {"shi2007"}},
    {"breakage", "tavares", {"tavares2009"}},
    {"breakage", "threshold", {}, "a power law in size, of Mahlwerk"},

    {"fragments", "vogel", {"vogel2003"}},
    {"fragments", "austin", {"austin1971"}},
    {"fragments", "t10", {"king2001"}},
    {"fragments", "binary", {"ziff1985"}},
    {"fragments", "halves", {}, "two equal pieces"},

    {"sizes over time", "balance", {"reid1965"}},
    {"sizes over time", "statistical", {}, "a sample of grains, of Mahlwerk"},
    {"sizes over time", "both", {"reid1965"}},

    {"kinetics", "dose", {}, "an exponential of the dose"},
    {"kinetics", "by-impact", {"colacino2018"}},
    {"kinetics", "thermal", {"andersen2017"}},
    {"kinetics", "ignition", {"takacs2002", "schaffer1991"}},

    {"wear", "archard", {"archard1953"}},
    {"wear", "finnie", {"finnie1960"}},
    {"wear", "energy", {}, "worn volume in proportion to the energy lost"},

    {"heat", "flash", {"carslaw1959"}},

    {"power by formula", "bond", {"bond1961"}},
    {"power by formula", "hogg-fuerstenau", {"hogg1972"}},
    {"power by formula", "morrell-c", {"napiermunn1996"}},

    {"mixing index", "lacey", {"lacey1954"}},

    {"settling time", "auto", {"white1997"}},

    {"regime", "tumbling", {"mellmann2001"}},
    {"regime", "planetary", {"rosenkranz2011"}},
};

/// The models of a case, one after the other.
class Chosen {
 public:
  Chosen(const Case& c, const RunState& run) : c_(c), run_(run) {}

  std::vector<const CitedModel*> all() {
    motion();
    if (in_time_steps(run_.engine))
      soft_contacts();
    else
      bounces();
    const contact::ContactModel& model = c_.contact.model;
    add("twisting friction",
        contact::twisting_rules[static_cast<std::size_t>(model.twisting)].name);
    if (c_.liquid) add("liquid", c_.liquid->model.flooded ? "flooded" : "film");
    powder();
    if (const std::string wear = word("wear.model"); !wear.empty()) add("wear", wear);
    if (c_.heat) add("heat", "flash");
    power_formulas();
    if (!word("mixing.colour").empty()) add("mixing index", "lacey");
    if (cases::settles(c_)) add("settling time", "auto");
    return std::move(used_);
  }

 private:
  /// The word of a key that only a part reads; empty if the case lacks it.
  std::string word(std::string_view key) const {
    const auto origin = std::ranges::find(c_.origins, key, &cases::Origin::key);
    if (origin == c_.origins.end()) return "";
    std::string text = origin->value;
    std::erase(text, '"');
    return text;
  }
  void add(std::string_view subject, std::string_view model) {
    const auto found = std::ranges::find_if(models, [&](const CitedModel& one) {
      return one.subject == subject && one.model == model;
    });
    if (found == models.end())
      throw std::logic_error(fmt::format("no references of {} {}", subject, model));
    used_.push_back(&*found);
  }

  void motion() {
    std::int64_t balls = 0;
    for (const cases::BallSet& set : c_.balls) balls += set.count;
    const std::string_view kind = kinematics::name_of(*c_.mill.motion);
    add("motion of balls", run_.engine == EngineName::event
                               ? (balls == 1 ? "one-ball event" : "many-ball event")
                               : cases::name_of(run_.engine));
    add("mill motion", kind);
    if (run_.has_regime && (kind == "tumbling" || kind == "planetary")) add("regime", kind);
  }
  void soft_contacts() {
    const contact::ContactModel& model = c_.contact.model;
    add("contact law", contact::name_of(*model.law));
    add("tangential spring", model.partial_slip ? "partial-slip" : "full-stiffness");
    add("rolling resistance", contact::rule_of(model.rolling).name);
  }
  void bounces() {
    constexpr std::array laws{"constant", "viscoelastic", "tabulated"};
    constexpr std::array sustained{"roll", "tc", "none"};
    std::vector<contact::BounceRule> rules{c_.contact.rule};
    for (const cases::PairRule& pair : c_.contact.pairs) rules.push_back(pair.rule);
    for (const contact::BounceRule& rule : rules) {
      add_once("bounce rule", std::isfinite(rule.friction) ? "walton" : "constant");
      add_once("restitution", laws[static_cast<std::size_t>(rule.restitution.law())]);
    }
    add("sustained contacts", sustained[static_cast<std::size_t>(c_.contact.lasting)]);
  }
  void add_once(std::string_view subject, std::string_view model) {
    if (std::ranges::none_of(used_, [&](const CitedModel* one) {
          return one->subject == subject && one->model == model;
        }))
      add(subject, model);
  }
  /// Those that a result has beside the power of a drum.
  void power_formulas() {
    if (cases::may_hold(cases::bond_range, c_)) add("power by formula", "bond");
    if (cases::may_hold(cases::hogg_fuerstenau_range, c_))
      add("power by formula", "hogg-fuerstenau");
    if (cases::may_hold(cases::morrell_range, c_)) add("power by formula", "morrell-c");
  }
  void powder() {
    constexpr std::array methods{"balance", "statistical", "both"};
    if (c_.capture) add("capture", name_of(*c_.capture->model));
    if (c_.grinding) {
      add("breakage", name_of(*c_.grinding->breakage));
      add("fragments", name_of(*c_.grinding->fragments));
      add("sizes over time", methods[static_cast<std::size_t>(c_.grinding->method)]);
    }
    if (c_.kinetics) add("kinetics", name_of(*c_.kinetics->model));
  }

  const Case& c_;
  const RunState& run_;
  std::vector<const CitedModel*> used_;
};

}  // namespace

std::span<const CitedModel> cited_models() {
  return models;
}

std::vector<const CitedModel*> used_models(const Case& c, const RunState& run) {
  std::vector<const CitedModel*> used = Chosen(c, run).all();
  std::ranges::sort(used);  // by their place in the table
  return used;
}

}  // namespace mahlwerk::report
