// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// bond-test: Bond's grindability test of a simulated mill and a rock.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/powder/locked_cycle.hpp"
#include "mahlwerk/powder/population_balance.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/json_value.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/mill_speed.hpp"

namespace mahlwerk::commands {
namespace {

struct BondArguments {
  CaseArguments of;
  std::string screen = "150 um", load = "250 %", full_scale = "", full_speed = "72 %";
};

/// A replicate's test, or the mean of all.
struct BondNumbers {
  double per_turn = 0, f80 = 0, p80 = 0, work_index = 0;  // [g], [m], [m], [kWh/t]
};

/// An option with a number, and the range in which the test and its rules mean something.
struct BondOption {
  const char* name;
  std::string_view unit;
  double least, most;
  const char* remedy;
};
constexpr BondOption screen_option{"--screen", "m", 10e-6, 5e-3,
                                   "write the opening of the closing screen, for instance 150um"};
constexpr BondOption load_option{"--load", "", 0.1, 10, "write for instance 250%, that of Bond"};
constexpr BondOption diameter_option{"--mill-diameter", "m", 0.1, 20,
                                     "write the inner diameter of the mill, for instance 4m"};
constexpr BondOption speed_option{
    "--mill-speed", "", 0.1, 0.99,
    "write a share of the critical speed, at which a mill centrifuges, for instance 72%"};

double bond_quantity(const std::string& text, const BondOption& option) {
  double value = NAN;
  try {
    value = parse_in(text, option.unit);
  } catch (const UnitError&) {
  }
  if (value >= option.least && value <= option.most) return value;
  const auto shown = [&](double end) {
    return option.unit.empty() ? fmt::format("{:.0f} %", 100 * end)
                               : show_rounded(end, option.unit);
  };
  throw InputError(Fault{
      option.name,
      fmt::format("\"{}\" is no {} from {} to {}", text, option.unit.empty() ? "share" : "length",
                  shown(option.least), shown(option.most)),
      option.remedy, "bad-command-line"});
}

/// The mill whose largest ball is wanted.
struct FullScaleMill {
  std::optional<double> diameter;  // [m]
  double speed = 0;                // [1] share of the critical speed
};

FullScaleMill full_scale_mill(const BondArguments& given) {
  FullScaleMill mill;
  if (!given.full_scale.empty()) mill.diameter = bond_quantity(given.full_scale, diameter_option);
  mill.speed = bond_quantity(given.full_speed, speed_option);
  return mill;
}

cases::Case read_bond_case(const BondArguments& given) {
  cases::Case c = cases::read(one_case_file(given.of.target, "bond-test"), catalogue(),
                              given.of.changes.overrides());
  const auto need = [&](bool there, const char* what, const char* remedy) {
    if (!there) throw InputError(Fault{c.file, what, remedy, "no-bond-test"});
  };
  need(c.sweep.empty(), "the case has a [sweep]", "give a case of one run");
  need(cases::drum_motion(c) != nullptr, "Bond's test needs a mill that turns: a drum",
       "write kind = \"tumbling\", or model = \"Bond mill\"");
  need(cases::shaft_speed(c).has_value(), "the mill does not turn: its speed is 0",
       "give [mill] speed, for instance 70 rpm, that of Bond's mill");
  need(c.grinding.has_value() && c.powder.has_value(), "the case has no rock that breaks",
       "add [powder], [capture], [breakage], [fragments] and [grinding] (docs/howto/bond.md)");
  if (std::vector<Fault> wrong = campaign::run_faults(c); !wrong.empty()) throw InputError(wrong);
  return c;
}

/// The test of the spectra of these replicates.
powder::LockedCycleTest locked_cycles(const results::Outcome& outcome,
                                      const std::vector<const results::Replicate*>& of,
                                      const powder::LockedCycleRules& rules) {
  const cases::Case& c = outcome.mill_case;
  const powder::StressSpectrum stresses = results::stress_spectrum(c, of);
  const powder::SizeGrid grid = results::size_grid(c);
  const powder::CaptureTable beds = results::beds(c, stresses);
  const double rate =
      results::mean_over(of, [&](const results::Replicate& r) { return results::mill_rate(c, r); });
  const double turn = 2 * std::numbers::pi / (cases::shaft_speed(c).value() * rate);
  const bool mixed = c.grinding->bed == powder::Bed::mixed;
  const auto grind = [&](const std::vector<double>& shares, double turns) {
    powder::PopulationBalance balance(cases::process(c), stresses, grid, shares,
                                      mixed ? nullptr : &beds);
    balance.advance(turns * turn);
    return balance.shares();
  };
  try {
    return powder::locked_cycle_test(grid, grid.shares(c.powder->feed), rules, grind);
  } catch (const std::invalid_argument& error) {
    throw InputError(Fault{c.file, error.what(),
                           "check the feed, the closing screen and the breakage model",
                           "no-bond-test"});
  }
}

BondNumbers bond_numbers(const cases::Case& c, const powder::LockedCycleTest& test,
                         const powder::LockedCycleRules& rules) {
  BondNumbers n{1000 * c.powder->mass * test.per_turn, test.f80, test.p80, 0};
  n.work_index = powder::bond_work_index(rules.closing_size, n.per_turn, n.f80, n.p80);
  return n;
}

/// The largest ball of a full-scale mill by the rules of Bond and of Azzaroni.
struct LargestBall {
  double diameter = 0, speed = 0;  // [m] and share of the critical speed, of the mill
  double bond = 0, azzaroni = 0;   // [m]
};

/// None without --mill-diameter.
std::optional<LargestBall> largest_ball(const FullScaleMill& mill, const cases::Case& c,
                                        const BondNumbers& n) {
  if (!mill.diameter) return std::nullopt;
  const double d = *mill.diameter, density = *c.powder->density;
  return LargestBall{d, mill.speed,
                     powder::bond_ball_size(n.f80, n.work_index, density, mill.speed, d),
                     powder::azzaroni_ball_size(n.f80, n.work_index, density, mill.speed, d)};
}

results::Json test_json(const powder::LockedCycleTest& test, const BondNumbers& n, double ci95,
                        double mass, const std::optional<LargestBall>& ball,
                        const Notices& notices) {
  using results::Json;
  Json cycles = Json::array();
  for (const powder::Cycle& k : test.cycles)
    cycles.push_back(Json::object({{"turns", k.turns},
                                   {"fed_g", 1000 * mass * k.fed},
                                   {"undersize_fed_g", 1000 * mass * k.undersize_fed},
                                   {"product_g", 1000 * mass * k.product},
                                   {"g_per_turn", 1000 * mass * k.per_turn},
                                   {"circulating_load", k.circulating_load},
                                   {"p80_m", k.p80}}));
  Json all = Json::object(
      {{"study", "bond-test"},
       {"mahlwerk", version()},
       {"work_index", Json::object({{"value", n.work_index}, {"ci95", ci95}, {"unit", "kWh/t"}})},
       {"g_per_turn", n.per_turn},
       {"f80_m", n.f80},
       {"p80_m", n.p80},
       {"steady", test.steady},
       {"mass_error", test.mass_error},
       {"cycles", std::move(cycles)},
       {"notices", results::notices_json(notices)}});
  if (ball)
    all["largest_ball"] = Json::object({{"mill_diameter_m", ball->diameter},
                                        {"mill_speed", ball->speed},
                                        {"bond_m", ball->bond},
                                        {"azzaroni_m", ball->azzaroni}});
  return all;
}

std::string test_words(const powder::LockedCycleTest& test, const BondNumbers& n, double ci95,
                       double mass, const powder::LockedCycleRules& rules) {
  std::string text = fmt::format(
      "Bond's test, closing screen {}, circulating load {:.0f} %\n\n"
      "{:>5}  {:>7}  {:>9}  {:>10}  {:>9}  {:>10}  {:>8}\n",
      show_rounded(rules.closing_size, "m"), 100 * rules.circulating_load, "cycle", "turns",
      "feed (g)", "product (g)", "g/turn", "load (%)", "P80");
  int number = 0;
  for (const powder::Cycle& k : test.cycles)
    text +=
        fmt::format("{:>5}  {:>7.0f}  {:>9.1f}  {:>11.1f}  {:>9.3f}  {:>9.0f}  {:>8}\n", ++number,
                    k.turns, 1000 * mass * k.fed, 1000 * mass * k.product, 1000 * mass * k.per_turn,
                    100 * k.circulating_load, show_rounded(k.p80, "m"));
  text += fmt::format(
      "\nF80 {}, P80 {}, {:.3f} g of undersize per turn (mean of the last three cycles)\n"
      "work index  {:.2f}{} kWh/t  ({:.2f} kWh per short ton) (bnd.3)\n",
      show_rounded(n.f80, "m"), show_rounded(n.p80, "m"), n.per_turn, n.work_index,
      std::isfinite(ci95) ? fmt::format(" ± {:.2f}", ci95) : "", 0.90718474 * n.work_index);
  if (!test.steady)
    text += fmt::format(
        "\nWarning: after {} cycles the grams per turn still differ by more than "
        "{:.0f} %: the test has no steady state.\n",
        test.cycles.size(), 100 * rules.agreement);
  text +=
      "\nThe rock breaks as [capture], [breakage] and [fragments] of the case say; grains of a new "
      "cycle have no damage. ± is chance over replicates alone.\n";
  return text;
}

std::string ball_words(const std::optional<LargestBall>& ball, double f80) {
  if (!ball) return "";
  return fmt::format(
      "\nLargest ball of a mill of {} at {:.0f} % of its critical speed, for a feed of F80 {}:\n"
      "  Bond {} (bnd.4), Azzaroni {} (bnd.5)\n",
      show_rounded(ball->diameter, "m"), 100 * ball->speed, show_rounded(f80, "m"),
      show_rounded(ball->bond, "m"), show_rounded(ball->azzaroni, "m"));
}

std::string notice_words(const Notices& notices) {
  std::string text;
  for (const Notice& one : notices)
    text += fmt::format("\n{}{}\n", one.warns() ? "Warning: " : "", one.text);
  return text;
}

int bond_test(const BondArguments& given) {
  catch_ctrl_c();
  powder::LockedCycleRules rules;
  rules.closing_size = bond_quantity(given.screen, screen_option);
  rules.circulating_load = bond_quantity(given.load, load_option);
  const FullScaleMill mill = full_scale_mill(given);
  const cases::Case c = read_bond_case(given);
  ProgressLine line(given.of.running.quiet);
  campaign::RunOptions options = run_options(given.of.running.threads);
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  const results::Outcome outcome = campaign::run(c, options);
  if (stop_wanted())
    return report_interrupted(given.of.running, "the test keeps no numbers; start it again.");
  if (const int ended = report_exit_status({outcome}); ended != success) return ended;
  const std::vector<const results::Replicate*> all = results::averaged_replicates(outcome);
  const powder::LockedCycleTest test = locked_cycles(outcome, all, rules);
  const BondNumbers n = bond_numbers(outcome.mill_case, test, rules);
  std::vector<double> each;
  for (const results::Replicate* r : all)
    each.push_back(
        bond_numbers(outcome.mill_case, locked_cycles(outcome, {r}, rules), rules).work_index);
  const double ci95 = observe::estimate(each).ci95, mass = c.powder->mass;
  const std::optional<LargestBall> ball = largest_ball(mill, outcome.mill_case, n);
  if (given.of.running.json) json_to_stdout(test_json(test, n, ci95, mass, ball, outcome.notices));
  if (given.of.running.prints_text())
    to_stdout(test_words(test, n, ci95, mass, rules) + ball_words(ball, n.f80) +
              notice_words(outcome.notices));
  return success;
}

}  // namespace

Command bond_test_command() {
  const auto given = std::make_shared<BondArguments>();
  return {
      "bond-test", "Bond's grindability test in locked cycles: work index, grams per turn, P80",
      joined(
          {{one_case(given->of.target)},
           options_of(given->of.changes),
           {{.name = "--screen",
             .target = &given->screen,
             .about = "opening of the closing screen, 10 um to 5 mm (default 150 um)"},
            {.name = "--load",
             .target = &given->load,
             .about = "circulating load, 10 % to 1000 % (default 250 %)"},
            {.name = "--mill-diameter",
             .target = &given->full_scale,
             .about =
                 "of a full-scale mill, 10 cm to 20 m: its largest ball by Bond and by Azzaroni"},
            {.name = "--mill-speed",
             .target = &given->full_speed,
             .about = "of that mill, share of its critical speed, 10 % to 99 % (default 72 %)"},
            threads(given->of.running.threads),
            quiet(given->of.running.quiet),
            json(given->of.running.json)}}),
      [given] { return bond_test(*given); }};
}

}  // namespace mahlwerk::commands
