// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/sample.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mahlwerk::powder {
namespace {

constexpr int steps_per_octave = 8;  // of energy, in rows
constexpr int damage_steps = 512;

/// [1] Standard deviations of a random grain's strength.
double normal(Draws& draw) {
  const double radius = std::sqrt(-2 * std::log(draw()));
  return radius * std::cos(2 * std::numbers::pi * draw());
}

}  // namespace

Sample::Sample(Process process, std::vector<Nip> nips, SizeGrid grid, const Feed& feed, int grains,
               std::uint64_t start)
    : process_(std::move(process)),
      nips_(std::move(nips)),
      grid_(grid),
      classes_(static_cast<std::size_t>(grid.classes())),
      rows_(nips_.size()),
      draw_(start),
      grains_(grains) {
  const auto* tavares = std::get_if<Tavares>(&process_.breakage);
  if (tavares != nullptr)  // small damage goes as this power of the load: smooth in it
    for (int i = 0; i <= damage_steps; ++i)
      damage_.push_back(
          tavares->damage(std::pow(static_cast<double>(i) / damage_steps, 2.5 / tavares->gamma)));
  for (int i = 0; i < grains; ++i) {
    // One from each equal share of the feed: it is met as closely as so many grains can.
    const double size = feed.quantile((i + draw_()) / grains);
    const double strength = tavares == nullptr ? 1 : tavares->relative_strength(normal(draw_));
    classes_[static_cast<std::size_t>(grid_.class_of(size))].push_back({size, strength});
  }
  mean_size_ = mean_size(grid_, shares());
}

const Sample::Row& Sample::row(int nip, std::int64_t energy_step) {
  const auto [at, is_new] = rows_[static_cast<std::size_t>(nip)].try_emplace(energy_step);
  Row& made = at->second;
  if (!is_new) return made;
  const double energy = std::exp2(static_cast<double>(energy_step) / steps_per_octave);
  for (int i = 0; i < grid_.classes(); ++i) {
    const double size = grid_.middle(i);
    const double bed = process_.bed == Bed::mixed ? mean_size_ : size;
    const Catch c = process_.caught(nips_[static_cast<std::size_t>(nip)], energy, bed);
    const double mass = c.grains * process_.grain(bed).mass();
    const double reached = size <= process_.sticking_size ? 1 - process_.sticking : 1;
    made.share.push_back(reached * c.chance * mass / process_.mass);
    made.per_energy.push_back(process_.energy_share / mass);
    const double given = energy * made.per_energy.back();
    const bool welds = process_.welding > 0 && given >= process_.welding_energy;
    const bool breaks = std::visit(
        [&](const auto& model) {
          return std::decay_t<decltype(model)>::remembers || model.chance(size, given) > 0;
        },
        process_.breakage);
    if (welds || breaks) made.idle = false;
  }
  return made;
}

bool Sample::matters(int nip, double energy) {
  const auto low = static_cast<std::int64_t>(std::floor(std::log2(energy) * steps_per_octave));
  return !row(nip, low).idle || !row(nip, low + 1).idle;
}

void Sample::hit(int nip, double energy, double times) {
  const double place = std::log2(energy) * steps_per_octave;
  const auto low = static_cast<std::int64_t>(std::floor(place));
  const Row &one = row(nip, low), &other = row(nip, low + 1);
  if (one.idle && other.idle) return;
  const double part = place - static_cast<double>(low);
  std::visit(
      [&](const auto& model) {
        // Hits are dealt out evenly: a class gets as many as it is due, or one more. Fine grains
        // first, so that a piece is not hit by what made it.
        double due = 0, next = draw_();
        for (int i = grid_.classes() - 1; i >= 0; --i) {
          const auto c = static_cast<std::size_t>(i);
          if (classes_[c].empty()) continue;
          due += times * static_cast<double>(classes_[c].size()) *
                 std::lerp(one.share[c], other.share[c], part);
          if (!(next < due)) continue;
          const double given = energy * std::lerp(one.per_energy[c], other.per_energy[c], part);
          for (; next < due && !classes_[c].empty(); next += 1) strike(model, i, given);
        }
      },
      process_.breakage);
  if (process_.bed == Bed::mixed && grain_hits_ - since_refresh_ > grains_ / 8) refresh();
}

template <class Model>
void Sample::strike(const Model& model, int at, double energy) {
  std::vector<One>& here = classes_[static_cast<std::size_t>(at)];
  ++grain_hits_;
  const auto which = static_cast<std::size_t>(draw_() * static_cast<double>(here.size()));
  One grain = here[which];
  bool breaks = false;
  double t10 = 0;
  if constexpr (Model::remembers) {
    const double load = energy / (grain.strength * model.median(grain.size));
    breaks = load >= 1;
    if (!breaks) {
      const double place = std::pow(load, 0.4 * model.gamma) * damage_steps;
      const auto low = static_cast<std::size_t>(place);
      const double damage =
          std::lerp(damage_[low], damage_[std::min<std::size_t>(low + 1, damage_steps)],
                    place - static_cast<double>(low));
      here[which].strength = grain.strength *= 1 - damage;
    }
  } else {
    const double chance = model.chance(grain.size, energy);
    breaks = chance >= 1 || (chance > 0 && draw_() < chance);
  }
  if (breaks && at + 1 == grid_.classes()) return;  // as fine as is told apart
  if (breaks) {
    if constexpr (Model::tells_fineness) t10 = model.t10(grain.size, energy);
    grain.size = std::visit([&](const auto& f) { return f.drawn(grain.size, t10, draw_); },
                            process_.fragments);
    if constexpr (Model::remembers) grain.strength = model.relative_strength(normal(draw_));
    return move(at, which, grain);
  }
  if (process_.welding > 0 && energy >= process_.welding_energy && at >= grid_.per_octave() / 3 &&
      draw_() < process_.welding) {
    grain.size *= std::cbrt(2.0);
    move(at, which, grain);
  }
}

void Sample::move(int from, std::size_t which, One grain) {
  const int to = grid_.class_of(grain.size);
  std::vector<One>& old = classes_[static_cast<std::size_t>(from)];
  if (to == from) {
    old[which] = grain;
    return;
  }
  old[which] = old.back();
  old.pop_back();
  classes_[static_cast<std::size_t>(to)].push_back(grain);
}

/// A mixed bed is as high as the powder's mean size, whose rows go with it (pbm.5).
void Sample::refresh() {
  constexpr double much = 0.02;
  since_refresh_ = grain_hits_;
  const double now = mean_size(grid_, shares());
  if (std::abs(std::log(now / mean_size_)) < much) return;
  mean_size_ = now;
  for (auto& rows : rows_) rows.clear();
}

std::vector<double> Sample::shares() const {
  std::vector<double> found;
  for (const auto& some : classes_)
    found.push_back(static_cast<double>(some.size()) / static_cast<double>(grains_));
  return found;
}

std::vector<double> Sample::sizes() const {
  std::vector<double> found;
  for (const auto& some : classes_)
    for (const One& grain : some) found.push_back(grain.size);
  return found;
}

}  // namespace mahlwerk::powder
