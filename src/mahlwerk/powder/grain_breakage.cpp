// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/grain_breakage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/powder/sample.hpp"

namespace mahlwerk::powder {
namespace {

class ModelledBreakage final : public scene::GrainBreakage {
 public:
  explicit ModelledBreakage(const BedBreakage& bed)
      : bed_(bed),
        grid_(bed.grid()),
        diameters_(bed.coarse ? std::vector<double>() : bed.diameters()) {}

  std::int32_t kind() const override { return bed_.kind; }
  std::uint64_t seed() const override { return bed_.seed; }
  int classes() const override { return grid_.classes(); }
  int class_of(double size) const override { return grid_.class_of(size); }
  const std::vector<double>& diameters() const override { return diameters_; }

  scene::GrainState at_start(std::int64_t number, double diameter) const override {
    // A sequence without a trend, so that sizes do not follow places.
    const double place = static_cast<double>(number) / std::numbers::phi + 0.5;
    const std::uint64_t draw = bed_.seed * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(number);
    return particle(bed_.coarse ? bed_.feed.quantile(place - std::floor(place)) : diameter, draw);
  }

  scene::GrainState particle(double size, std::uint64_t draw) const override {
    scene::GrainState grain;
    grain.size = std::max(size, finest());
    grain.draw = draw;
    draw_strength(grain);
    return grain;
  }

  bool breaks(const scene::GrainState& grain, double energy) const override {
    if (grid_.class_of(grain.size) + 1 == grid_.classes()) return false;
    return std::visit(
        [&]<class M>(const M& model) {
          if constexpr (M::tracks_strength)
            return energy >= grain.strength;
          else
            return model.breakage_probability(grain.size, energy) > grain.strength;
        },
        *bed_.breakage);
  }

  void weaken(scene::GrainState& grain, double energy) const override {
    constexpr double negligible = 1e-3;  // [1] load; its damage is 1e-6 and less (brk.6)
    std::visit(
        [&]<class M>(const M& model) {
          if constexpr (M::tracks_strength) {
            const double load = energy / grain.strength;
            if (load > negligible) grain.strength *= 1 - model.damage(load);
          } else {
            draw_strength(grain);
          }
        },
        *bed_.breakage);
  }

  double fragment_size(const scene::GrainState& grain) const override {
    SplitMix64 draw(grain.draw + 1);
    const double t10 = t10_of(grain.size, grain.broken);
    return std::visit([&](const auto& f) { return f.draw_fragment(grain.size, t10, draw); },
                      *bed_.fragments);
  }

  std::vector<double> fragment_shares(const scene::GrainState& grain) const override {
    return shares_of(grain.size, grain.broken);
  }

  void grind(std::vector<double>& mass, std::span<const double> stressed) const override {
    double all = 0;
    for (const double m : mass) all += m;
    if (!(all > 0)) return;
    for (std::size_t bin = 0; bin < stressed.size(); ++bin) {
      if (!(stressed[bin] > 0)) continue;
      const double energy = energy_of_bin(static_cast<int>(bin)), hits = stressed[bin] / all;
      const std::vector<double> before = mass;
      for (int k = 0; k + 1 < classes(); ++k) {
        const double size = grid_.middle(k), here = before[static_cast<std::size_t>(k)];
        const double probability = here > 0 ? probability_of(size, energy) : 0;
        if (!(probability > 0)) continue;
        const double broken = -here * math::expm1(-hits * probability);  // (bed.8)
        const std::vector<double> shares = shares_of(size, energy);
        mass[static_cast<std::size_t>(k)] -= broken;
        for (std::size_t j = 0; j < shares.size(); ++j) mass[j] += broken * shares[j];
      }
    }
  }

 private:
  double finest() const { return grid_.middle(grid_.classes() - 1); }

  void draw_strength(scene::GrainState& grain) const {
    SplitMix64 draw(grain.draw);
    std::visit(
        [&]<class M>(const M& model) {
          if constexpr (M::tracks_strength) {
            const double radius = std::sqrt(-2 * math::log(draw()));
            const double deviations = radius * math::cos(2 * std::numbers::pi * draw());
            grain.strength = model.median(grain.size) * model.relative_strength(deviations);
          } else {
            grain.strength = draw();
          }
        },
        *bed_.breakage);
    grain.draw += 0x632be59bd9b4e019U;
  }

  double probability_of(double size, double energy) const {
    return std::visit([&](const auto& model) { return model.breakage_probability(size, energy); },
                      *bed_.breakage);
  }

  double t10_of(double size, double energy) const {
    return std::visit(
        [&]<class M>(const M& model) {
          if constexpr (M::predicts_t10) return model.t10(size, energy);
          return 0.0;
        },
        *bed_.breakage);
  }

  /// Fragments of the grain's own class count as of the next one (bed.5).
  std::vector<double> shares_of(double size, double energy) const {
    std::vector<double> shares(static_cast<std::size_t>(classes()));
    const double t10 = t10_of(size, energy);
    const int first = std::min(grid_.class_of(size) + 1, classes() - 1);
    double above = 1;
    for (int k = first; k < classes(); ++k) {
      const double ratio = grid_.lower(k) / size;
      const double below =
          k + 1 == classes()
              ? 0
              : std::visit([&](const auto& f) { return f.breakage_function(ratio, size, t10); },
                           *bed_.fragments);
      shares[static_cast<std::size_t>(k)] = above - below;
      above = below;
    }
    return shares;
  }

  BedBreakage bed_;
  SizeGrid grid_;
  std::vector<double> diameters_;
};

}  // namespace

SizeGrid BedBreakage::grid() const {
  const double largest = coarse ? std::max(grain_size, feed.largest()) : grain_size;
  return {grain_size, largest, std::min(finest, 0.5 * grain_size), per_octave};
}

std::vector<double> BedBreakage::diameters() const {
  if (coarse) return {grain_size};
  const SizeGrid classes = grid();
  std::vector<double> found;
  constexpr double rounding = 1e-9;
  for (int k = 0; k < classes.classes(); ++k)
    if (const double size = k == 0 ? grain_size : classes.middle(k);
        k == 0 || size >= smallest_fragment * (1 - rounding))
      found.push_back(size);
  return found;
}

std::shared_ptr<const scene::GrainBreakage> grain_breakage(const BedBreakage& bed) {
  return std::make_shared<ModelledBreakage>(bed);
}

}  // namespace mahlwerk::powder
