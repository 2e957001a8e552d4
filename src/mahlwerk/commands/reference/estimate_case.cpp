// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reference/estimate_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"

namespace mahlwerk::commands {
namespace {

using cases::Catalogue;
using cases::CatalogueEntry;

/// `key = "value"`, quoted as TOML asks.
std::string line(std::string_view key, std::string_view value) {
  std::string quoted;
  for (const char c : value) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) < ' ')
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    else
      quoted += c;
  }
  return fmt::format("{} = \"{}\"\n", key, quoted);
}
std::string line_if(std::string_view key, std::string_view value) {
  return value.empty() ? "" : line(key, value);
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// The value of a text in a unit; none if it has another one, or is no quantity.
std::optional<double> in_unit(std::string_view text, std::string_view unit) {
  try {
    return parse_in(text, unit);
  } catch (const UnitError&) {
    return std::nullopt;
  }
}

/// The jars of a mill that have a volume or, if the word is none, are called so.
std::vector<std::string> jars_called(const CatalogueEntry& mill, const std::string& word,
                                     const Catalogue& catalogue) {
  const std::optional<double> volume = in_unit(word, "m3");
  const std::vector<std::string> called =
      volume ? std::vector<std::string>{} : catalogue.entries_called("jars", word);
  std::vector<std::string> found;
  for (const std::string& name : mill.jars) {
    const CatalogueEntry jar = catalogue.find("jars", name);
    const auto own = jar.values.find("volume");
    const bool fits = volume && own != jar.values.end() &&
                      std::abs(parse_in(own->second.text, "m3") - *volume) < 0.01 * *volume;
    if (fits || std::ranges::find(called, name) != called.end()) found.push_back(name);
  }
  return found;
}

/// The name of the jar; empty if neither the words nor the mill have one.
std::string jar_name(const EstimateWords& words, const CatalogueEntry& mill,
                     const Catalogue& catalogue) {
  if (words.jar.empty()) return mill.jars.empty() ? "" : mill.jars[mill.jars.size() / 2];
  const std::vector<std::string> found = jars_called(mill, words.jar, catalogue);
  if (found.size() == 1) return found.front();
  if (found.empty() && !in_unit(words.jar, "m3") &&
      !catalogue.entries_called("jars", words.jar).empty())
    return catalogue.find("jars", words.jar, "--jar").name;
  const std::string has = fmt::format("{}", fmt::join(found.empty() ? mill.jars : found, ", "));
  throw InputError(Fault{
      "--jar " + words.jar,
      found.empty() ? fmt::format("the catalogue has no such jar for the {}", mill.title)
                    : fmt::format("the {} has several such jars", mill.title),
      has.empty() ? "give its inner sizes: --set jar.kind=cylinder --set jar.diameter=\"60 mm\" "
                    "--set jar.height=\"50 mm\""
                  : fmt::format("choose one of {}; or give sizes with --set jar.diameter and --set "
                                "jar.height",
                                has),
      "unknown-name"});
}

Fault ball_fault(const std::string& word, const std::string& what) {
  return {word.empty() ? "--balls" : "--balls " + word, what,
          "write for instance --balls 2x10mm, --balls \"50 g x 3 mm\" or --balls \"30 % x 5 mm\" "
          "(of the volume of the jar); or a name from mahlwerk list media",
          "bad-command-line"};
}

/// One [[balls]]: number, mass or filling before the "x", diameter after it.
std::string ball_set(const std::string& word, const std::string& material,
                     const Catalogue& catalogue) {
  std::string set = "\n[[balls]]\n";
  if (!catalogue.entries_called("media", word).empty())
    return set + line("model", catalogue.find("media", word, "--balls").name) +
           line_if("material", material);
  constexpr std::string_view sign = "\u00d7";  // the multiplication sign
  std::size_t cross = word.find_first_of("xX*"), width = 1;
  if (cross == std::string::npos) cross = word.find(sign), width = sign.size();
  if (cross == std::string::npos)
    throw InputError(ball_fault(word, "this is neither \"NUMBER x DIAMETER\" nor a ball set"));
  const std::string_view amount = trimmed(std::string_view(word).substr(0, cross)),
                         diameter = trimmed(std::string_view(word).substr(cross + width));
  if (!in_unit(diameter, "m"))
    throw InputError(ball_fault(word, diameter.find(',') == std::string_view::npos
                                          ? "after the x there is no length"
                                          : "there is a comma; write a decimal point"));
  set += line("diameter", diameter) + line_if("material", material);
  const NumberText count = number_text(amount);
  if (count.rest.empty() && std::isfinite(count.number))
    return set + fmt::format("count = {}\n", count.number);
  if (in_unit(amount, "kg")) return set + line("mass", amount);
  if (amount.ends_with('%') && in_unit(amount, "")) return set + line("bulk_filling", amount);
  throw InputError(
      ball_fault(word, "before the x there is no number, mass or percentage of the jar"));
}

/// [powder]: a mass, or "10:1".
std::string powder_section(const std::string& word) {
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) return "\n[powder]\n" + line("mass", word);
  const std::string_view text = word;
  const NumberText balls = number_text(trimmed(text.substr(0, colon))),
                   powder = number_text(trimmed(text.substr(colon + 1)));
  const double ratio = balls.number / powder.number;
  if (!balls.rest.empty() || !powder.rest.empty() || !(ratio > 0) || !std::isfinite(ratio))
    throw InputError(Fault{"--powder " + word, "this is no ratio of masses",
                           "write a mass, --powder 200mg, or the mass of the balls over that of "
                           "the powder, --powder 10:1",
                           "bad-command-line"});
  return fmt::format("\n[powder]\nball_to_powder = {}\n", ratio);
}

std::string title(const EstimateWords& words, const CatalogueEntry& mill, const std::string& jar) {
  std::string title = mill.title;
  for (const std::string& part :
       {words.jar.empty() ? jar : words.jar, fmt::format("{}", fmt::join(words.balls, " and ")),
        words.material, words.frequency + words.speed})
    if (!part.empty()) title += ", " + part;
  return title;
}

}  // namespace

std::string estimate_case(const EstimateWords& words, const Catalogue& catalogue,
                          const std::string& counted) {
  const CatalogueEntry mill = catalogue.find("mills", words.mill, "MILL");
  if (words.balls.empty()) throw InputError(ball_fault("", "no balls are given"));
  if (!words.time.empty() && words.powder.empty())
    throw InputError(Fault{"--time " + words.time, "no powder is given, so no dose follows",
                           "give --powder, or leave out --time", "bad-command-line"});
  const std::string jar = jar_name(words, mill, catalogue);
  std::string text = line("title", title(words, mill, jar)) + "\n[mill]\n" +
                     line("model", mill.name) + line_if("frequency", words.frequency) +
                     line_if("speed", words.speed);
  text += "\n[jar]\n" + line_if("model", jar) + line_if("material", words.material);
  for (const std::string& one : words.balls) text += ball_set(one, words.material, catalogue);
  if (!words.powder.empty()) text += powder_section(words.powder);
  if (!words.time.empty()) text += "\n[milling]\n" + line("time", words.time);
  return text + "\n[run]\n" + line("time", counted) + line("sensitivity", "on");
}

}  // namespace mahlwerk::commands
