// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/report/plot/laws.hpp"

// What a paper shows and says, as paper.toml has it (docs/papers.md): which campaigns its figures
// are drawn from, and how each of its claims is put to the test.
namespace mahlwerk::report {

/// Chooses points of a campaign: swept keys, each with the values it may take there.
using PointSelector = std::map<std::string, std::vector<std::string>>;

struct PaperFigure {
  enum class Drawn {
    quantity,      ///< against a key, with intervals and a fitted law
    trajectories,  ///< ways of the balls, point by point
    snapshots      ///< balls and grains at one time, point by point
  };
  std::string number;    ///< the paper's: "6a"
  std::string title;     ///< ours
  std::string about;     ///< below it; may be empty
  std::string campaign;  ///< file name beside paper.toml, without .toml
  Drawn drawn = Drawn::quantity;
  std::string quantity, against;  ///< of summary.json; a key of [sweep]
  std::optional<LawForm> law;
  PointSelector at;            ///< which points; empty: all
  bool seen_from_jar = false;  ///< trajectories and snapshots; otherwise from what carries the jar
  std::string where;           ///< the place a fault cites
};

/// A sentence of a paper and its test. Points that differ in other keys than `against` are judged
/// line by line.
struct Claim {
  enum class Kind {
    law,      ///< the quantity goes with the key by a law: R2, exponent
    trend,    ///< it rises or falls at each step by more than both intervals
    compare,  ///< it is larger or smaller at one value of the key than at another
    alike,    ///< it is the same all along
    regime,   ///< the charge moves so
    bound     ///< it is above or below a number
  };
  std::string figure;  ///< or section: as the paper counts
  std::string says, why;
  Kind kind = Kind::trend;
  std::string campaign, quantity, against;
  PointSelector at;
  /// rises, falls; larger, smaller; above, below (of a bound, or of an exponent instead of at it);
  /// a regime's word
  std::string is;
  LawForm law = LawForm::line;
  double r2 = 0.99;  ///< [1] least share of the scatter that the law must explain
  std::optional<double> exponent;
  double within = 0.1;        ///< [1] about the exponent; relative, of `alike`
  std::string first, second;  ///< of `compare`: is the second larger than the first?
  double bound = 0;           ///< in SI units
  std::string bound_text;
  std::string where;  ///< the place a fault cites
};

struct Paper {
  std::string title, source, about;
  std::vector<PaperFigure> figures;
  std::vector<Claim> claims;
  std::filesystem::path folder;  ///< of the campaigns

  /// Those that figures and claims name, each once, in the order of first mention.
  std::vector<std::string> campaigns() const;
};

/// Reads a paper.toml strictly. Throws InputError with all faults: file, line, what, remedy.
Paper read_paper(const std::filesystem::path& file);
/// The same from text; `file` is the name faults cite.
Paper read_paper_text(const std::string& text, const std::filesystem::path& file);

/// What figures and claims ask of campaigns that those do not have: keys, values, quantities.
/// `cases` holds each campaign's case with its [sweep].
std::vector<Fault> paper_faults(const Paper& paper,
                                const std::map<std::string, cases::Case>& cases);

}  // namespace mahlwerk::report
