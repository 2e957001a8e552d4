// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/sample.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/powder/models.hpp"

namespace mahlwerk::powder {
namespace {

constexpr int steps_per_octave = 8;  // of the energies of kinds of collisions
constexpr int damage_steps = 512;

/// [1] A standard normal random number (Box-Muller), for a grain's strength.
double normal(SplitMix64& draw) {
  const double radius = std::sqrt(-2 * math::log(draw()));
  return radius * math::cos(2 * std::numbers::pi * draw());
}

}  // namespace

Sample::Sample(Process process, std::vector<Nip> nips, SizeGrid grid, const Feed& feed, int grains,
               std::uint64_t start)
    : process_(std::move(process)),
      nips_(std::move(nips)),
      grid_(grid),
      groups_(static_cast<std::size_t>(2 * (grid.classes() - 1) / grid.per_octave() + 1)),
      draw_(start),
      grains_(grains) {
  static_assert(only_strength_model<Tavares>);
  const auto* tavares = std::get_if<Tavares>(&*process_.breakage);
  if (tavares != nullptr)  // equidistant in the power of the load to which small damage is linear
    for (int i = 0; i <= damage_steps; ++i)
      damage_.push_back(
          tavares->damage(math::pow(static_cast<double>(i) / damage_steps, 2.5 / tavares->gamma)));
  for (int i = 0; i < grains; ++i) {
    // Stratified sampling: one grain from each equal share of the feed.
    const double size = feed.quantile((i + draw_()) / grains);
    const double strength =
        tavares == nullptr ? 0 : tavares->median(size) * tavares->relative_strength(normal(draw_));
    const int at = grid_.class_of(size);
    groups_[static_cast<std::size_t>(group_of(at))].push_back(
        {size, static_cast<float>(strength), at});
    ++count_[static_cast<std::size_t>(group_of(at))];
    if (at + 1 == grid_.classes()) ++finest_;
  }
  mean_size_ = mean_size(grid_, shares());
}

int Sample::kind(int nip, double energy) {
  const int step = static_cast<int>(std::lround(math::log2(energy) * steps_per_octave));
  const auto [at, is_new] = known_.try_emplace({nip, step}, static_cast<int>(kinds_.size()));
  if (is_new) {
    CollisionKind made;
    made.nip = nip;
    made.energy = math::exp2(static_cast<double>(step) / steps_per_octave);
    compute_class_hits(made);
    kinds_.push_back(std::move(made));
  }
  return at->second;
}

void Sample::compute_class_hits(CollisionKind& kind) const {
  const auto capture_from_bed = [&](double bed) {
    return process_.capture_per_hit(nips_[static_cast<std::size_t>(kind.nip)], kind.energy, bed);
  };
  const bool mixed = process_.bed == Bed::mixed;
  Capture c = mixed ? capture_from_bed(mean_size_) : Capture{};
  kind.class_hits.clear();
  kind.most.fill(0);
  kind.no_effect = true;
  for (int i = 0; i < grid_.classes(); ++i) {
    const double size = grid_.middle(i);
    if (!mixed) c = capture_from_bed(size);
    const double mass = c.grains * process_.grain(mixed ? mean_size_ : size).mass();
    const double reached = size <= process_.sticking_size ? 1 - process_.sticking : 1;
    kind.class_hits.push_back({static_cast<float>(reached * c.probability * mass / process_.mass),
                               static_cast<float>(process_.energy_share / mass)});
    const double given = kind.energy * process_.energy_share / mass;
    const bool welds = process_.welding > 0 && given >= process_.welding_energy;
    const bool breaks = std::visit(
        [&](const auto& model) {
          return std::decay_t<decltype(model)>::tracks_strength ||
                 model.breakage_probability(size, given) > 0;
        },
        *process_.breakage);
    if (welds || breaks) kind.no_effect = false;
    double& most = kind.most[static_cast<std::size_t>(group_of(i))];
    most = std::max<double>(most, kind.class_hits.back().share);
  }
}

// Rejection sampling: candidates are drawn at the largest hit share of their group, spread evenly
// over the groups, and accepted with the hit share of their class over that largest share.
void Sample::hit(int of_kind, double energy, double times) {
  const CollisionKind& k = kinds_[static_cast<std::size_t>(of_kind)];
  if (k.no_effect) return;
  double due = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) due += count_[g] * k.most[g];
  const auto candidates = static_cast<std::int64_t>(times * due + draw_());
  if (candidates == 0) return;
  const double apart = due / static_cast<double>(candidates);
  std::visit(
      [&](const auto& model) {
        // Counts change as grains move. Candidates are spread over the groups from fine to coarse,
        // so that a fragment is not hit again in a finer group by the same collision.
        std::size_t g = groups_.size() - 1;
        double below = 0, here = count_[g] * k.most[g];
        for (std::int64_t i = 0; i < candidates; ++i) {
          const double place = apart * (static_cast<double>(i) + draw_());
          while (place >= below + here && g > 0) {
            below += here;
            --g;
            here = count_[g] * k.most[g];
          }
          const auto which = static_cast<std::size_t>((place - below) / k.most[g]);
          if (which >= groups_[g].size()) continue;  // the grain has moved to another group
          const ClassHit class_hit =
              k.class_hits[static_cast<std::size_t>(groups_[g][which].size_class)];
          if (draw_() * k.most[g] < class_hit.share)
            hit_grain(model, static_cast<int>(g), which, energy * class_hit.per_energy);
        }
      },
      *process_.breakage);
  if (process_.bed == Bed::mixed && grain_hits_ - hits_at_update_ > grains_ / 8) update_mixed_bed();
}

template <class Model>
void Sample::hit_grain(const Model& model, int group, std::size_t which, double energy) {
  GrainState& here = groups_[static_cast<std::size_t>(group)][which];
  GrainState grain = here;
  ++grain_hits_;
  bool breaks = false;
  if constexpr (Model::tracks_strength) {
    const double load = energy / grain.strength;
    breaks = load >= 1;
    if (!breaks) {
      const double place = math::pow(load, 0.4 * model.gamma) * damage_steps;
      const auto low = static_cast<std::size_t>(place);
      const double damage =
          std::lerp(damage_[low], damage_[std::min<std::size_t>(low + 1, damage_steps)],
                    place - static_cast<double>(low));
      here.strength = grain.strength *= static_cast<float>(1 - damage);
    }
  } else if constexpr (requires { model.breaks(1.0, 1.0, 0.5); }) {
    breaks = model.breaks(grain.size, energy, draw_());
  } else {
    breaks = draw_() < model.breakage_probability(grain.size, energy);
  }
  if (breaks) {
    if (grain.size_class + 1 == grid_.classes()) return;  // the finest class does not break
    double t10 = 0;
    if constexpr (Model::predicts_t10) t10 = model.t10(grain.size, energy);
    grain.size = std::visit([&](const auto& f) { return f.draw_fragment(grain.size, t10, draw_); },
                            *process_.fragments);
    grain.size =
        std::max(grain.size, grid_.middle(grid_.classes() - 1));  // as in the population balance
    if constexpr (Model::tracks_strength)
      grain.strength =
          static_cast<float>(model.median(grain.size) * model.relative_strength(normal(draw_)));
    return move(group, which, grain);
  }
  if (process_.welding > 0 && energy >= process_.welding_energy &&
      grain.size_class >= grid_.per_octave() / 3 && draw_() < process_.welding) {
    const double before = grain.size;
    grain.size *= math::cbrt(2.0);
    if constexpr (Model::tracks_strength)  // keeps its strength relative to the median
      grain.strength *= static_cast<float>(model.median(grain.size) / model.median(before));
    move(group, which, grain);
  }
}

void Sample::move(int group, std::size_t which, GrainState grain) {
  const auto finest = [&](const GrainState& one) {
    return one.size_class + 1 == grid_.classes() ? 1 : 0;
  };
  finest_ -= finest(grain);
  grain.size_class = grid_.class_of(grain.size);
  finest_ += finest(grain);
  const int to = group_of(grain.size_class);
  std::vector<GrainState>& old = groups_[static_cast<std::size_t>(group)];
  if (to == group) {
    old[which] = grain;
    return;
  }
  old[which] = old.back();
  old.pop_back();
  groups_[static_cast<std::size_t>(to)].push_back(grain);
  --count_[static_cast<std::size_t>(group)];
  ++count_[static_cast<std::size_t>(to)];
}

/// Recomputes captures of a mixed bed, whose height is the powder's mean size (pbm.5).
void Sample::update_mixed_bed() {
  constexpr double much = 0.02;
  hits_at_update_ = grain_hits_;
  const double now = mean_size(grid_, shares());
  if (std::abs(math::log(now / mean_size_)) < much) return;
  mean_size_ = now;
  for (CollisionKind& kind : kinds_) compute_class_hits(kind);
}

std::vector<double> Sample::shares() const {
  std::vector<double> found(static_cast<std::size_t>(grid_.classes()));
  for (const auto& some : groups_)
    for (const GrainState& grain : some)
      found[static_cast<std::size_t>(grain.size_class)] += 1 / static_cast<double>(grains_);
  return found;
}

std::vector<double> Sample::sizes() const {
  std::vector<double> found;
  for (const auto& some : groups_)
    for (const GrainState& grain : some) found.push_back(grain.size);
  return found;
}

}  // namespace mahlwerk::powder
