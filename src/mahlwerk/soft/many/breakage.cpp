// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Grains that break (docs/theory/bed-breakage.md): the energy that contacts put into each grain.
namespace mahlwerk::soft {
namespace {

using scene::GrainState;

/// [1] Elastic energy over elastic force times overlap, a constant of a law without adhesion and
/// history (bed.1): 2/5 for Hertz, 1/2 for a linear spring.
double stored_share(const SpeciesPair& pair, const contact::AnyLaw& law) {
  return std::visit(
      [&](const auto& l) {
        double history[contact::law_history_size] = {};
        const double overlap = 1e-3 * pair.effective.radius;
        const double force = l.evaluate(pair.coefficients.data(), history, overlap, 0.0).force;
        return l.elastic_energy(pair.coefficients, history, overlap) / (force * overlap);
      },
      law);
}

}  // namespace

/// Sets the states of the grains; those that are outside wait to become fragments.
void ManyBodySolver::start_breakage(const std::vector<scene::Ball>& balls) {
  const scene::GrainBreakage& rule = *settings_.breakage;
  BreakageState& b = breakage_;
  b.active = settings_.breakage_from_start ? 1 : 0;
  b.grains.resize(balls.size());
  const auto is_grain = [&](const scene::Ball& ball) {
    return ball.kind == rule.kind() && !ball.outside;
  };
  std::int64_t number = 0;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (!is_grain(balls[k])) continue;
    b.grains[k] = rule.at_start(number++, 2 * balls[k].radius);
    b.powder += balls[k].mass();
  }
  b.fines.assign(static_cast<std::size_t>(rule.classes()), 0);
  b.stressed.assign(scene::GrainBreakage::energy_bins, 0);
  b.is_new.assign(balls.size(), 0);
  Random random(rule.seed() ^ fragment_stream, 0);
  for (const double diameter : rule.diameters()) {
    b.species.push_back(species_of_grain(0.5 * diameter));
    b.due.push_back(random.uniform() * pairs_.species(b.species.back()).mass);
  }
  for (std::size_t n = 0; n < pairs_.all().size(); ++n) {
    const auto row = static_cast<std::int32_t>(n / pairs_.row_length());
    const SpeciesPair& own = pairs_[pairs_.ball_pair_index(row, row)];
    b.energy_share.push_back(pairs_.all()[n].effective.pair.modulus /
                             (2 * own.effective.pair.modulus));
  }
  stored_share_ = stored_share(pairs_[0], *settings_.model.law);
}

std::int32_t ManyBodySolver::species_of_grain(double radius) const {
  const auto all = pairs_.all_species();
  const auto found = std::ranges::min_element(all, {}, [&](const Species& s) {
    return s.kind == settings_.breakage->kind() ? std::abs(s.radius - radius) : geometry::never;
  });
  return static_cast<std::int32_t>(found - all.begin());
}

/// Follows the stressing of the grains, and replaces those that broke, at steps that do not depend
/// on how advance() divides a run.
void ManyBodySolver::break_grains(scene::Observer& observer) {
  if (step_ % stressing_interval != 0 || breakage_.active == 0) return;
  std::vector<scene::SizeChange> changes;
  follow_stressing(changes);
  if (step_ - breakage_.replaced_at >= replacement_interval) replace_broken(changes);
  if (step_ % replacement_interval == 0) grind_fines(changes);
  if (!changes.empty()) observer.size_changes(changes);
}

/// [J] Energy that the contacts of a chunk put into each of its balls (bed.2), into `load_`.
void ManyBodySolver::sum_loads(Chunk& chunk) {
  std::fill(load_.begin() + chunk.first, load_.begin() + chunk.last, 0.0);
  for (ContactPackets* list : {&chunk.own, &chunk.halo, &chunk.wall})
    for (std::size_t n = 0; n < list->packets.size(); ++n) {
      const ContactPacket& g = list->packets[n];
      StressHistory& stress = list->stresses[n];
      for (std::size_t l = 0; l < lanes; ++l) {
        if (!g.touches(l)) continue;
        const double energy = stress.energy[l];
        const double share = breakage_.energy_share[static_cast<std::size_t>(g.species_pair[l])];
        load_[static_cast<std::size_t>(g.i[l])] += share * energy;
        if (list == &chunk.own) load_[static_cast<std::size_t>(g.j[l])] += (1 - share) * energy;
      }
      stress.energy = {};
    }
}

void ManyBodySolver::follow_stressing(std::vector<scene::SizeChange>& changes) {
  load_.resize(rows_.size());
  std::vector<Stressing> of_chunk(chunks_.size());
  const double share = cushioned_share();
  team_.run_items(share_, [&](int, std::int32_t c, std::int32_t) {
    Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
    sum_loads(chunk);
    for (std::int32_t row = chunk.first; row < chunk.last; ++row) {
      const auto k = static_cast<std::size_t>(row);
      if (pairs_.species(species_[k]).kind == settings_.breakage->kind())
        stress(k, share, of_chunk[static_cast<std::size_t>(c)]);
    }
  });
  for (const Stressing& one : of_chunk) {
    changes.insert(changes.end(), one.changes.begin(), one.changes.end());
    for (std::size_t n = 0; n < one.fines.size(); ++n) breakage_.stressed[n] += one.fines[n];
    energy_balance_.broken_grains += one.broken;
  }
}

/// [1] Share of the energy of a stressing that a grain receives, the rest going to the fines around
/// it, by their masses (bed.7).
double ManyBodySolver::cushioned_share() const {
  const double fines = std::accumulate(breakage_.fines.begin(), breakage_.fines.end(), 0.0);
  return 1 - fines / breakage_.powder;
}

/// Follows the stressing of a grain: it breaks at the largest energy so far, and is weakened once
/// half of that is gone (bed.3). The next stressing begins when the load rises again. How fine it
/// becomes is decided once its load falls, or by the end of the stressing where spheres stay
/// (bed.10).
void ManyBodySolver::stress(std::size_t row, double share, Stressing& out) {
  using Phase = GrainState::Phase;
  GrainState& grain = breakage_.grains[static_cast<std::size_t>(id_[row])];
  if (grain.phase == Phase::replaced) return;
  const double mass = pairs_.species(species_[row]).mass, now = share * load_[row];
  const bool rises = now > grain.peak, stays = breakage_.species.empty();
  if (rises && grain.phase == Phase::rests) grain.phase = Phase::whole;
  const bool rests = grain.phase == Phase::rests, ends = !rests && now < 0.5 * grain.peak;
  if (rises || rests) grain.peak = now;
  if (rises && grain.phase == Phase::whole && settings_.breakage->breaks(grain, now / mass))
    grain.phase = Phase::breaks, grain.broke_at = step_;
  const bool leaves = grain.phase == Phase::breaks && !stays &&
                      (!rises || step_ - grain.broke_at >= longest_breakage);
  if (leaves || ends) stress_fines(grain.peak / mass, mass, share, out);
  if (leaves) {
    grain.broken = grain.peak / mass;
    grain.phase = Phase::replaced;
  } else if (ends) {
    if (grain.phase == Phase::whole) settings_.breakage->weaken(grain, grain.peak / mass);
    if (grain.phase == Phase::breaks) become_finer(grain, mass, out);
    grain.phase = Phase::rests;
    grain.peak = now;
  }
}

/// Counts what a stressing of a grain by `energy` [J/kg] does to the fines around it (bed.7).
void ManyBodySolver::stress_fines(double energy, double mass, double share, Stressing& out) {
  if (!(share < 1) || !(energy > 0)) return;
  out.fines.resize(scene::GrainBreakage::energy_bins);
  out.fines[static_cast<std::size_t>(scene::GrainBreakage::bin_of(energy))] +=
      mass * (1 - share) / share;
}

/// The sphere of a grain that broke stays, and stands for particles of one size of the fragments,
/// drawn by mass (bed.4).
void ManyBodySolver::become_finer(GrainState& grain, double mass, Stressing& out) const {
  const scene::GrainBreakage& rule = *settings_.breakage;
  grain.broken = grain.peak / mass;
  const double size = rule.fragment_size(grain);
  const GrainState was = grain;
  grain = rule.particle(std::min(size, grain.size), grain.draw + 2);
  grain.peak = was.peak, grain.broken = was.broken;
  ++out.broken;
  out.changes.push_back({time_of(step_), -mass, rule.class_of(was.size), 1});
  out.changes.push_back({time_of(step_), mass, rule.class_of(grain.size), 0});
}

}  // namespace mahlwerk::soft
