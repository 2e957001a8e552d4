// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Captured grains by energy, and their bounds.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <variant>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/report/paper/claim_lines.hpp"
#include "mahlwerk/report/paper/tables.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"

namespace mahlwerk::report {
namespace {

/// Index of a ball set: 0 for "balls.1"; nullopt for other words.
std::optional<std::size_t> ball_set(const cases::Case& c, std::string_view word) {
  constexpr std::string_view before = "balls.";
  std::size_t number = 0;
  if (!word.starts_with(before)) return std::nullopt;
  word.remove_prefix(before.size());
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool sound = read.ec == std::errc() && number > 0 && number <= c.balls.size();
  return sound ? std::optional(number - 1) : std::nullopt;
}

/// [m] R* of a pair (cap.3): two balls; a ball in the cylinder, or on one of its ends. NaN else.
double pair_radius(const cases::Case& c, double ball, std::string_view other) {
  if (const auto set = ball_set(c, other)) {
    const double second = 0.5 * c.balls[*set].diameter;
    return ball * second / (ball + second);
  }
  if (other == "jar.bottom" || other == "jar.top") return ball;
  if (other != "jar.side") return NAN;
  double side = NAN;
  std::visit(
      [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, geometry::Cylinder>)
          side = 0.5 * shape.diameter;
      },
      *c.jar.shape);
  return std::sqrt(ball / (1 / ball - 1 / side));
}

/// [m2/N] Compliance of a body: E* is the inverse of the sum of both.
double compliance(const contact::ElasticConstants& of) {
  return (1 - of.poisson_ratio * of.poisson_ratio) / of.youngs_modulus;
}

/// A bin of capture.csv.
struct CaptureBin {
  std::string one, other;
  double energy = 0, rate = 0, grains = 0, energy_per_grain = 0, specific_energy = 0;
};

std::vector<CaptureBin> capture_bins(const results::Outcome& outcome) {
  const results::Table table = results::capture(outcome);
  const auto column = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(table.columns, name, &results::Column::name) -
                                    table.columns.begin());
  };
  const std::size_t energy = column("energy"), rate = column("rate"), grains = column("grains"),
                    each = column("energy_per_grain"), specific = column("specific_energy");
  std::vector<CaptureBin> bins;
  for (const auto& row : table.rows)
    bins.push_back({table.columns[0].words[static_cast<std::size_t>(row[0])],
                    table.columns[1].words[static_cast<std::size_t>(row[1])], row[energy],
                    row[rate], row[grains], row[each], row[specific]});
  return bins;
}

/// A point of the campaign with its bins of the pair of a table.
struct Strength {
  std::string text;  ///< its value of `against`: "1000 J/kg"
  const results::Outcome* outcome = nullptr;
  std::vector<CaptureBin> bins;

  /// The bin nearest to an energy, on a logarithmic scale; nullptr without collisions.
  const CaptureBin* nearest(double energy) const {
    const auto off = [&](const CaptureBin& b) { return std::abs(std::log(b.energy / energy)); };
    const auto found = std::ranges::min_element(bins, {}, off);
    return found == bins.end() ? nullptr : &*found;
  }
  /// [1/s] Collisions in the decade around an energy.
  double rate(double energy) const {
    double sum = 0;
    for (const CaptureBin& b : bins)
      if (std::abs(std::log10(b.energy / energy)) < 0.5) sum += b.rate;
    return sum;
  }
};

/// The points that the table selects, by descending value of `against`.
std::vector<Strength> strengths(const PaperTable& table, const RunCampaign& run) {
  std::vector<Strength> found;
  const std::vector<ClaimLine> lines = lines_along(run.numbers, table.at, table.against, "");
  if (lines.empty()) return found;
  for (const LinePoint& s : lines.front().points) {
    const auto index = static_cast<std::size_t>(s.point - run.numbers.points.data());
    Strength one{s.text, &run.outcomes[index], capture_bins(run.outcomes[index])};
    std::erase_if(one.bins, [&](const CaptureBin& b) {
      return b.one != table.one || b.other != table.other;
    });
    found.push_back(std::move(one));
  }
  std::ranges::reverse(found);
  return found;
}

/// Counted bins, and those outside the bounds.
struct BinCount {
  std::size_t all = 0, outside = 0;
};

void count_bins(const cases::Case& c, const std::vector<CaptureBin>& bins, BinCount& count) {
  constexpr double rounding = 1e-12;
  for (const CaptureBin& b : bins) {
    const std::optional<CaptureBounds> bounds = capture_bounds(c, b.one, b.other, b.energy);
    if (!bounds) continue;
    ++count.all;
    const bool inside =
        b.grains >= bounds->low * (1 - rounding) && b.grains <= bounds->high * (1 + rounding);
    count.outside += inside ? 0 : 1;
  }
}

/// A row for the decade around an energy; empty without collisions of this pair.
std::vector<double> row_at(const std::vector<Strength>& points, const PaperTable& table,
                           double energy) {
  const Strength& middle = points[points.size() / 2];
  const CaptureBin* bin = middle.nearest(energy);
  if (bin == nullptr) return {};
  const auto bounds =
      capture_bounds(middle.outcome->mill_case, table.one, table.other, bin->energy);
  if (!bounds) return {};
  std::vector<double> row{bin->energy, middle.rate(energy), bounds->low};
  for (const Strength& point : points) {
    const CaptureBin* nearest = point.nearest(energy);
    row.push_back(nearest == nullptr ? NAN : nearest->grains);
  }
  row.insert(row.end(), {bounds->high, bin->energy_per_grain, bin->specific_energy});
  return row;
}

std::string rounded(double value) {
  return std::isfinite(value) ? fmt::format("{:.0f}", value) : "-";
}

std::vector<std::string> cells_of(const std::vector<double>& row) {
  std::vector<std::string> cells{readable(row[0], NAN, "J").text(), fmt::format("{:.3g}", row[1])};
  for (std::size_t i = 2; i + 2 < row.size(); ++i) cells.push_back(rounded(row[i]));
  cells.push_back(readable(row[row.size() - 2], NAN, "J").text());
  cells.push_back(readable(1e-3 * row.back(), NAN, "J/g").text());
  return cells;
}

}  // namespace

bool has_capture_bounds(const cases::Case& c) {
  if (!c.capture || powder::name_of(*c.capture->model) != "barrios") return false;
  return std::visit(
      [](const auto& shape) {
        return std::is_same_v<std::decay_t<decltype(shape)>, geometry::Cylinder>;
      },
      *c.jar.shape);
}

std::optional<CaptureBounds> capture_bounds(const cases::Case& c, std::string_view one,
                                            std::string_view other, double energy) {
  constexpr double greatest = 0.362;  // D/h for an endless specific energy (cap.8)
  const std::optional<std::size_t> set = ball_set(c, one), second = ball_set(c, other);
  if (!set || !c.powder || !c.powder->size) return std::nullopt;
  const double radius = pair_radius(c, 0.5 * c.balls[*set].diameter, other);
  if (!std::isfinite(radius)) return std::nullopt;
  const double soft = compliance(c.balls[*set].elastic) +
                      compliance(second ? c.balls[*second].elastic : c.jar.elastic);
  const double size = *c.powder->size;
  const double touch = std::pow(15 * energy * soft / 8, 0.2) * std::pow(radius, 0.4);
  const auto grains = [&](double deformation) {
    const double depth = size * deformation;
    const double spot = touch + std::sqrt(depth * (2 * radius - depth));
    return spot < 0.5 * size ? 1 : 0.25 + 0.75 * std::pow(2 * spot / size, 2);
  };
  return CaptureBounds{grains(0), grains(greatest)};
}

MadeTable captured_table(const PaperTable& table, const RunCampaign& run) {
  MadeTable made{.table = &table, .heads = {}, .rows = {}, .csv = {}, .note = {}};
  const std::vector<Strength> points = strengths(table, run);
  if (points.empty()) return made;
  const std::string& middle = points[points.size() / 2].text;
  made.heads = {"energy of a hit", "hits/s in its decade", "lower bound of N"};
  std::vector<std::string> names{"energy_J", "rate_per_s", "lower_bound"};
  BinCount count;
  for (const Strength& point : points) {
    made.heads.push_back("N at " + point.text);
    names.push_back(results::csv_cell(std::string_view("grains at " + point.text)));
    count_bins(point.outcome->mill_case, point.bins, count);
  }
  made.heads.insert(made.heads.end(),
                    {"upper bound of N", "energy per grain at " + middle, "per mass"});
  names.insert(names.end(), {"upper_bound", "energy_per_grain_J", "specific_energy_J_per_kg"});
  made.csv = results::csv_line(names);
  for (const double energy : table.energies) {
    const std::vector<double> row = row_at(points, table, energy);
    if (row.empty()) continue;
    made.rows.push_back(cells_of(row));
    std::vector<std::string> cells;
    for (const double value : row) cells.push_back(results::csv_cell(value));
    made.csv += results::csv_line(cells);
  }
  made.note = fmt::format(
      "N is the number of captured grains, {} with {}. {} of {} bins of energy "
      "lie outside the bounds.",
      table.one, table.other, count.outside, count.all);
  return made;
}

Verdict judge_capture_bounds(const Claim& claim, const RunCampaign& run) {
  BinCount count;
  std::size_t points = 0;
  for (const ClaimLine& line : lines_along(run.numbers, claim.at, "", ""))
    for (const LinePoint& s : line.points) {
      const results::Outcome& outcome =
          run.outcomes[static_cast<std::size_t>(s.point - run.numbers.points.data())];
      count_bins(outcome.mill_case, capture_bins(outcome), count);
      ++points;
    }
  if (count.all == 0) return {"no collision captured grains"};
  return {
      fmt::format("{} of {} bins of energy lie outside the bounds, over {} points and all pairs",
                  count.outside, count.all, points),
      count.outside == 0          ? Holds::yes
      : count.outside < count.all ? Holds::partly
                                  : Holds::no};
}

}  // namespace mahlwerk::report
