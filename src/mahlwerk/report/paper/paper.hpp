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

// Contents of paper.toml (docs/papers.md): the figures of a paper with their campaigns, and its
// claims with their tests.
namespace mahlwerk::report {

/// Selects points of a campaign: swept keys, each with its allowed values.
using PointSelector = std::map<std::string, std::vector<std::string>>;

/// Measured values that a figure draws beside the computed ones.
struct MeasuredSeries {
  std::string name;                                        ///< in the legend
  std::vector<double> x;                                   ///< in the unit of the axis
  std::vector<double> y, error_low = {}, error_high = {};  ///< in SI units; errors may be empty
};

struct PaperFigure {
  enum class Drawn {
    quantity,      ///< over a key, with intervals and a fitted law
    trajectories,  ///< trajectories of the balls, a panel for each point
    snapshots      ///< balls and grains at one time, a panel for each point
  };
  std::string number;    ///< the paper's number: "6a"
  std::string title;     ///< our title
  std::string about;     ///< caption; may be empty
  std::string campaign;  ///< file name beside paper.toml, without .toml
  Drawn drawn = Drawn::quantity;
  std::string quantity, against;  ///< of summary.json; a key of [sweep]
  std::optional<LawForm> law;
  PointSelector at;  ///< selected points; empty: all
  /// Free or assumed numbers, keys of [sweep]: the figure has one band over all their values.
  std::vector<std::string> band_over = {};
  std::map<std::string, std::string> nominal = {};  ///< their values that are drawn as points
  std::vector<std::string> measurements = {};       ///< names of [[measured]] to draw
  std::vector<MeasuredSeries> measured = {};        ///< their values on the axis
  bool seen_from_jar = false;  ///< frame of trajectories and snapshots: the jar, else its carrier
  std::string where;           ///< location for faults
};

/// Measured values of a quantity, for instance the power of a mill against its speed.
struct Measurement {
  /// Where the numbers were read.
  enum class Status {
    verified,   ///< in the source itself
    quoted,     ///< in a work that quotes the source
    unverified  ///< not found in print; gives no verdict
  };
  struct Value {
    std::string at;                ///< value of the key, "70 rpm"; empty without a key
    std::string text, error_text;  ///< value and half-width of the interval: "83 W", "4 W"
    double in(std::string_view unit) const;        ///< the value in `unit`, as in summary.json
    double error_in(std::string_view unit) const;  ///< its half-width
  };
  std::string name;      ///< by which claims and figures refer to it
  std::string source;    ///< where the numbers stand: page, table or figure
  std::string error_is;  ///< what the errors are; may be empty
  Status status = Status::unverified;
  std::vector<Value> values;
  std::string where;  ///< location for faults
};

/// A table of a campaign, on the page and as tables/NAME.md and NAME.csv.
struct PaperTable {
  enum class Kind {
    quantity,  ///< mean and interval: a row for each combination of the other keys
    captured   ///< grains that a collision captures, by energy, between their bounds
  };
  std::string name;   ///< of its files
  std::string title;  ///< what it shows
  std::string about;  ///< text below it; may be empty
  std::string campaign;
  Kind kind = Kind::quantity;
  std::string quantity;                   ///< of summary.json; empty if captured
  std::string against;                    ///< key of [sweep] whose values are the columns
  PointSelector at;                       ///< selected points; empty: all
  bool ratio = false;                     ///< a column with the last value over the first
  std::string one, other;                 ///< captured: the pair, as in capture.csv
  std::vector<double> energies;           ///< [J] captured: a row for the decade around each
  std::vector<std::string> energy_texts;  ///< as in the file: "1 mJ"
  std::string where;                      ///< location for faults
};

/// A claim of a paper and its test. Points that differ in other keys than `against` are tested line
/// by line.
struct Claim {
  enum class Kind {
    law,            ///< the quantity follows a law of the key: curvature, exponent
    trend,          ///< it rises or falls at each step, intervals not overlapping
    compare,        ///< it is larger or smaller at one value of the key than at another
    alike,          ///< it is constant along the line
    regime,         ///< the charge is in this regime
    bound,          ///< it is above or below a number
    maximum,        ///< it is largest in a range of the key
    measured,       ///< it agrees with measured values; other keys are assumed and give a band
    capture_bounds  ///< captured grains lie between the bounds that no strength enters
  };
  std::string figure;  ///< figure or section number of the paper
  std::string says, why;
  Kind kind = Kind::trend;
  std::string campaign, quantity, against;
  PointSelector at;
  /// "rises", "falls"; "larger", "smaller"; "above", "below" (a bound, or an exponent); or a regime
  std::string is;
  LawForm law = LawForm::line;
  std::optional<double> exponent;
  /// [1] Tolerance of the exponent; relative tolerance of `alike`; greatest curvature of a line.
  double within = 0.1;
  /// Values of `against`. Of `compare`: is the second larger? Of `maximum`: ends of the range.
  std::string first, second;
  double bound = 0;  ///< in SI units
  std::string bound_text;
  std::string measured;     ///< name of a Measurement
  std::string relative_to;  ///< of `measured`: value of `against` whose quantity is the unit
  bool own = false;         ///< a statement of ours, not of the paper
  std::string where;        ///< location for faults
};

struct Paper {
  std::string title, source, about;
  std::string licence;  ///< of the measured data; may be empty
  bool quick = true;    ///< part of `mahlwerk papers --quick`
  std::vector<PaperFigure> figures;
  std::vector<Claim> claims;
  std::vector<PaperTable> tables = {};
  std::vector<Measurement> measured;
  std::filesystem::path folder;  ///< folder of the campaigns

  /// The measurement of that name; nullptr if there is none.
  const Measurement* measurement(std::string_view name) const;

  /// The campaigns that figures, claims and tables name, each once, in the order of first mention.
  std::vector<std::string> campaigns() const;
};

/// Reads a paper.toml strictly. Throws InputError with all faults: file, line, what, remedy.
Paper read_paper(const std::filesystem::path& file);
/// The same from text; `file` is the file name in faults.
Paper read_paper_text(const std::string& text, const std::filesystem::path& file);

/// Faults of references to keys, values or quantities that the campaigns do not have. `cases` holds
/// each campaign's case with its [sweep].
std::vector<Fault> paper_faults(const Paper& paper,
                                const std::map<std::string, cases::Case>& cases);

}  // namespace mahlwerk::report
