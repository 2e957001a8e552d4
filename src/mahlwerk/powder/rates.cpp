// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/powder/process.hpp"

namespace mahlwerk::powder {
namespace {

/// Bins of t10. Breakage rates are interpolated between them, so that fragments are computed once
/// per bin.
constexpr int t10_bins = 33;

/// Breakage rates [1/s] of one class by t10 bin. Models without t10 use only the first bin.
using BreakageRates = std::array<double, t10_bins>;

void add(BreakageRates& broken, double rate, double t10) {
  const double place = std::clamp(t10, 0.0, 1.0) * (t10_bins - 1);
  const int low = std::min(static_cast<int>(place), t10_bins - 2);
  const double high_share = place - low;
  broken[static_cast<std::size_t>(low)] += rate * (1 - high_share);
  broken[static_cast<std::size_t>(low) + 1] += rate * high_share;
}

/// One stress on one size class.
struct Hit {
  double rate = 0;    ///< [1/s] hits on a grain of the class
  double energy = 0;  ///< [J/kg] specific energy of the hit grain
};

/// Fills the columns of the matrix, class by class.
class RateMatrixBuilder {
 public:
  RateMatrixBuilder(const Process& process, const StressSpectrum& stresses, const SizeGrid& grid,
                    const StrengthLevels& levels, const CaptureTable& table)
      : process_(process),
        stresses_(stresses),
        grid_(grid),
        levels_(levels),
        table_(table),
        rates_(grid.classes() * levels.count(),
               process.welding > 0 ? grid.classes() * levels.count() : levels.count()) {}

  RateMatrix build() {
    for (int i = 0; i < grid_.classes(); ++i)
      std::visit([&](const auto& model) { fill(i, model); }, *process_.breakage);
    return std::move(rates_);
  }

 private:
  Hit hit(std::size_t n, std::size_t bed) const {
    const Stress& s = stresses_.stresses[n];
    const Capture& c = table_.captures[bed * stresses_.stresses.size() + n];
    const double mass = c.grains * Grain{table_.size[bed], process_.density, 0}.mass();
    return {s.rate * c.probability * mass / process_.mass, process_.energy_share * s.energy / mass};
  }

  template <class Model>
  void fill(int i, const Model& model) {
    const double size = grid_.middle(i);
    const double reached = size <= process_.sticking_size ? 1 - process_.sticking : 1;
    std::vector<BreakageRates> broken(static_cast<std::size_t>(levels_.count()), BreakageRates{});
    for (std::size_t n = 0; n < stresses_.stresses.size(); ++n) {
      Hit h = hit(n, process_.bed == Bed::mixed ? 0 : static_cast<std::size_t>(i));
      h.rate *= reached;
      if (!(h.rate > 0)) continue;
      if constexpr (Model::tracks_strength)
        for (int level = 0; level < levels_.count(); ++level) apply_hit(i, level, h, model, broken);
      else
        apply_hit(i, h, model, broken[0]);
    }
    for (int level = 0; level < levels_.count(); ++level)
      distribute_fragments(i, level, broken[static_cast<std::size_t>(level)]);
  }

  /// Hits on grains of a model without individual strengths.
  template <class Model>
  void apply_hit(int i, const Hit& h, const Model& model, BreakageRates& broken) {
    const double size = grid_.middle(i), chance = model.breakage_probability(size, h.energy);
    if constexpr (Model::predicts_t10)
      add(broken, h.rate * chance, model.t10(size, h.energy));
    else
      broken[0] += h.rate * chance;
    weld(i, 0, h, 1 - chance);
  }

  /// Hits on grains of one strength level.
  template <class Model>
  void apply_hit(int i, int level, const Hit& h, const Model& model,
                 std::vector<BreakageRates>& broken) {
    const double size = grid_.middle(i),
                 strength = levels_.strength[static_cast<std::size_t>(level)];
    const double load = h.energy / (strength * model.median(size));
    if (load >= 1) {
      add(broken[static_cast<std::size_t>(level)], h.rate, model.t10(size, h.energy));
      return;
    }
    const double welded = weld(i, level, h, 1);
    weaken(i, level, h.rate * (1 - welded), strength * (1 - model.damage(load)));
  }

  /// Moves grains to a strength between two levels, split so that the mean logarithm is conserved.
  void weaken(int i, int level, double rate, double strength) {
    const std::vector<double>& all = levels_.strength;
    int below = level;
    while (below + 1 < levels_.count() && all[static_cast<std::size_t>(below)] > strength) ++below;
    if (below == level) return;
    const double high = all[static_cast<std::size_t>(below) - 1],
                 low = all[static_cast<std::size_t>(below)];
    const double share = std::min(1.0, math::log(high / strength) / math::log(high / low));
    rates_.at(state(i, below), state(i, level)) += rate * share;
    if (below - 1 != level) rates_.at(state(i, below - 1), state(i, level)) += rate * (1 - share);
  }

  /// Welds two like grains to one of twice the volume (pbm.6). Returns the share that welds.
  double weld(int i, int level, const Hit& h, double survivors) {
    const int to = i - grid_.per_octave() / 3;
    if (!(process_.welding > 0) || h.energy < process_.welding_energy || to < 0) return 0;
    rates_.at(state(to, level), state(i, level)) += h.rate * survivors * process_.welding;
    return process_.welding;
  }

  /// Distributes fragments over the classes. Fragments in the parent's own state stay there.
  void distribute_fragments(int i, int level, const BreakageRates& broken) {
    const int last = grid_.classes() - 1;
    if (i == last) return;
    const double size = grid_.middle(i);
    for (std::size_t n = 0; n < broken.size(); ++n) {
      if (!(broken[n] > 0)) continue;
      const double t10 = static_cast<double>(n) / (t10_bins - 1);
      const auto finer = [&](double x) {
        return x >= size
                   ? 1
                   : std::visit(
                         [&](const auto& f) { return f.breakage_function(x / size, size, t10); },
                         *process_.fragments);
      };
      double above = 1;
      for (int j = i; j <= last; ++j) {
        const double below = j < last ? finer(grid_.lower(j)) : 0;
        for (int fresh = 0; fresh < levels_.count(); ++fresh)
          if (state(j, fresh) != state(i, level))
            rates_.at(state(j, fresh), state(i, level)) +=
                broken[n] * (above - below) * levels_.fresh[static_cast<std::size_t>(fresh)];
        above = below;
      }
    }
  }

  int state(int i, int level) const { return i * levels_.count() + level; }

  const Process& process_;
  const StressSpectrum& stresses_;
  const SizeGrid& grid_;
  const StrengthLevels& levels_;
  const CaptureTable& table_;
  RateMatrix rates_;
};

}  // namespace

StrengthLevels strength_levels(const AnyBreakage& breakage, int count) {
  static_assert(only_strength_model<Tavares>);
  const auto* model = std::get_if<Tavares>(&breakage);
  if (model == nullptr) return {};
  // Equidistant in the logarithm, from the strength that a thousandth of fresh grains exceed to a
  // sixth of that which a thousandth fall short of. Weaker grains break at almost every hit.
  constexpr double deviations = 3, weakest = 6;
  const double high = math::log(model->relative_strength(deviations));
  const double low = math::log(model->relative_strength(-deviations) / weakest);
  const double apart = (high - low) / (count - 1);
  const auto finer = [&](double log_strength) {
    return 0.5 * math::erfc(-model->deviations(math::exp(log_strength)) / std::numbers::sqrt2);
  };
  StrengthLevels made{{}, {}};
  double above = 1;
  for (int k = 0; k < count; ++k) {
    const double at = high - k * apart;
    const double below = k + 1 < count ? finer(at - 0.5 * apart) : 0;
    made.strength.push_back(math::exp(at));
    made.fresh.push_back(above - below);
    above = below;
  }
  return made;
}

CaptureTable capture_table(const Process& process, const StressSpectrum& stresses,
                           const SizeGrid& grid, double mean_size) {
  CaptureTable made;
  if (process.bed == Bed::mixed)
    made.size = {mean_size};
  else
    for (int i = 0; i < grid.classes(); ++i) made.size.push_back(grid.middle(i));
  for (const double size : made.size)
    for (const Stress& s : stresses.stresses)
      made.captures.push_back(
          process.capture_per_hit(stresses.nips[static_cast<std::size_t>(s.nip)], s.energy, size));
  return made;
}

RateMatrix rate_matrix(const Process& process, const StressSpectrum& stresses, const SizeGrid& grid,
                       const StrengthLevels& levels, const CaptureTable& table) {
  return RateMatrixBuilder(process, stresses, grid, levels, table).build();
}

}  // namespace mahlwerk::powder
