// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// ask: evaluates the file of a surrogate.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/campaigns/surrogate.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/study_json.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/quantities/traits.hpp"

namespace mahlwerk::commands {

using campaign::CampaignSurrogate;
using campaign::SurrogateQuantity;
using results::Json;

namespace {

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * share);
}

std::string warnings_of(const CampaignSurrogate& s) {
  const std::string lines = report::notice_lines(s.notices, s.settings + s.failed, "setting");
  return lines.empty() ? "" : '\n' + lines;
}

/// Share of the spread that a surrogate predicts wrongly, in words; empty up to `good`.
std::string caution(const CampaignSurrogate& s) {
  constexpr double good = 0.3;
  std::string names;
  for (const SurrogateQuantity& q : s.quantities)
    if (q.hold_out.error > good) names += (names.empty() ? "" : ", ") + q.name;
  if (names.empty()) return "";
  return fmt::format(
      "\nWarning: the hold-out error of {} is above {} of the spread over the settings: more "
      "settings, or more replicates, are needed.\n",
      names, percent(good));
}

}  // namespace

std::string surrogate_words(const CampaignSurrogate& s) {
  std::string text =
      fmt::format("{}\n\nmade from {} settings by the engine {}{}, digest {}\n\n", s.title,
                  s.settings, fmt::join(s.engines, " or "),
                  s.failed > 0 ? fmt::format(" ({} failed)", s.failed) : "", s.digest);
  std::vector<std::array<std::string, 3>> keys{{"key", "from", "to"}};
  for (const campaign::SurrogateKey& key : s.keys) keys.push_back({key.key, key.least, key.most});
  text += report::aligned(keys) + '\n';
  std::vector<std::array<std::string, 3>> lines{
      {"quantity", "hold-out error", "hold-outs in their interval"}};
  for (const SurrogateQuantity& q : s.quantities)
    lines.push_back({q.name, percent(q.hold_out.error), percent(q.hold_out.coverage)});
  text += report::aligned(lines) +
          "\nThe hold-out error is that of each setting predicted from the others, over the spread "
          "of the quantity; 95 % of the hold-outs should be in their intervals.\n";
  return text + caution(s) + warnings_of(s);
}

Json surrogate_json(const CampaignSurrogate& s) {
  Json keys = Json::object(), quantities = Json::object();
  for (const campaign::SurrogateKey& key : s.keys)
    keys[key.key] = Json::object({{"from", key.least}, {"to", key.most}});
  for (const SurrogateQuantity& q : s.quantities)
    quantities[q.name] = Json::object({{"unit", q.unit},
                                       {"hold_out_error", q.hold_out.error},
                                       {"hold_out_coverage", q.hold_out.coverage}});
  return report::with(report::study_head("surrogate", s.version, s.title, ""),
                      {{"digest", s.digest},
                       {"settings", s.settings},
                       {"failed", s.failed},
                       {"engines", s.engines},
                       {"keys", std::move(keys)},
                       {"quantities", std::move(quantities)},
                       {"notices", results::notices_json(s.notices)}});
}

namespace {

struct AskArguments {
  std::string file;
  std::vector<cases::Override> set;
  std::vector<std::string> quantities;  ///< empty: all
  bool json = false;
};

std::vector<SurrogateQuantity> asked_for(const CampaignSurrogate& s,
                                         const std::vector<std::string>& names) {
  if (names.empty()) return s.quantities;
  std::vector<std::string> known;
  for (const SurrogateQuantity& q : s.quantities) known.push_back(q.name);
  std::vector<SurrogateQuantity> chosen;
  for (const std::string& name : names) {
    const auto there = std::ranges::find(s.quantities, name, &SurrogateQuantity::name);
    if (there == s.quantities.end()) {
      const std::string near = nearest_word(name, known);
      throw InputError(Fault{"--quantity " + name, "the surrogate has no such quantity",
                             near.empty() ? fmt::format("it has {}", fmt::join(known, ", "))
                                          : fmt::format("did you mean {}?", near),
                             "no-such-quantity"});
    }
    chosen.push_back(*there);
  }
  return chosen;
}

Json answer_json(const CampaignSurrogate& s, const std::vector<cases::Override>& set,
                 const std::vector<SurrogateQuantity>& asked, const campaign::DesignPoint& point) {
  Json setting = Json::object(), quantities = Json::object();
  for (const cases::Override& one : set) setting[one.key] = one.value;
  for (const SurrogateQuantity& q : asked) {
    const observe::IntervalEstimate p = campaign::predict(q, point);
    quantities[q.name] = Json::object({{"value", p.value},
                                       {"low", p.low},
                                       {"high", p.high},
                                       {"unit", q.unit},
                                       {"hold_out_error", q.hold_out.error}});
  }
  return Json::object({{"title", s.title},
                       {"digest", s.digest},
                       {"set", std::move(setting)},
                       {"quantities", std::move(quantities)},
                       {"notices", results::notices_json(s.notices)}});
}

std::string answer_words(const CampaignSurrogate& s, const std::vector<cases::Override>& set,
                         const std::vector<SurrogateQuantity>& asked,
                         const campaign::DesignPoint& point) {
  std::string text = s.title + '\n';
  for (std::size_t i = 0; i < set.size(); ++i)
    text += fmt::format("{}{} = {}", i > 0 ? ", " : "", set[i].key, set[i].value);
  text += "\n\n";
  std::vector<std::array<std::string, 4>> lines{{"", "value", "95 % interval", "hold-out error"}};
  for (const SurrogateQuantity& q : asked) {
    const observe::IntervalEstimate p = campaign::predict(q, point);
    const results::Range range = results::range_of(q.name);
    const auto shown = [&](double value) {
      return report::readable(std::clamp(value, range.least, range.most), NAN, q.unit,
                              std::abs(p.value))
          .number;
    };
    const std::string unit = report::readable(p.value, 0, q.unit).unit;
    lines.push_back({report::label(q.name), fmt::format("{} {}", shown(p.value), unit),
                     fmt::format("{} to {} {}", shown(p.low), shown(p.high), unit),
                     percent(q.hold_out.error)});
  }
  return text + report::aligned(lines) +
         "\nThe interval is that of the mean over replicates. The hold-out error is that of each "
         "setting of the campaign predicted from the others, over the spread of the quantity.\n" +
         caution(s) + warnings_of(s);
}

int ask(const AskArguments& given) {
  const CampaignSurrogate s = campaign::read_surrogate(given.file);
  const std::vector<SurrogateQuantity> asked = asked_for(s, given.quantities);
  if (given.set.empty()) {
    given.json ? json_to_stdout(surrogate_json(s)) : to_stdout(surrogate_words(s));
    return success;
  }
  const campaign::DesignPoint point = s.point(given.set);
  for (const SurrogateQuantity& q : asked) {
    const observe::IntervalEstimate p = campaign::predict(q, point);
    if (!std::isfinite(p.low) || !std::isfinite(p.high))
      throw InputError(Fault{given.file, fmt::format("the file gives no number for {}", q.name),
                             "make the surrogate again: mahlwerk surrogate FOLDER --out FILE",
                             "cannot-read"});
  }
  if (given.json)
    json_to_stdout(answer_json(s, given.set, asked, point));
  else
    to_stdout(answer_words(s, given.set, asked, point));
  return success;
}

}  // namespace

Command ask_command() {
  const auto given = std::make_shared<AskArguments>();
  return {"ask",
          "ask the file of a surrogate for the results at a setting",
          {{.name = "FILE",
            .target = &given->file,
            .about = "the file that `mahlwerk surrogate` wrote",
            .required = true},
           {"--set", &given->set,
            "value of a swept key: --set mill.speed=\"500 rpm\"; once for each key (default: show "
            "what the file knows)",
            "KEY=VALUE"},
           {.name = "--quantity",
            .target = &given->quantities,
            .about = "a quantity of the file; may be repeated (default: all)"},
           json(given->json)},
          [given] { return ask(*given); }};
}

}  // namespace mahlwerk::commands
