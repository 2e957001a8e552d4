// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/scene/energy_balance.hpp"
#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "mahlwerk/soft/kernel/stored_energy.hpp"
#include "mahlwerk/soft/settings.hpp"
#include "mahlwerk/soft/species_pairs.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// Parameters of a ball of species `a` and one of species `b`, or a wall if `b` is null; the same
/// in all eight lanes.
PairParameters pair_parameters(const SpeciesPair& pair, const Species& a, const Species* b,
                               const Settings& settings);

/// Those of all pairs, in the order of SpeciesPairs::all().
std::vector<PairParameters> all_pair_parameters(const SpeciesPairs& pairs, int faces,
                                                const Settings& settings);

/// Replaces what of a lane's parameters depends on the R* of the contact, `effective.radius`.
void apply_effective_radius(PairParameters& parameters, std::size_t lane,
                            const contact::EffectivePair& effective, const SpeciesPair& pair,
                            const contact::ContactModel& model);
/// Replaces the coefficients of a lane by those with R* from both principal curvatures of the face
/// (dem.4), for a ball at `position` [m].
void apply_wall_curvature(PairParameters& parameters, std::size_t lane, const MovingWall& jar,
                          int face, const Vec3& position, double t, const SpeciesPair& pair,
                          const contact::ContactModel& model);

/// The onset data of a contact that begins at `step`.
ContactOnset contact_onset(std::int64_t step, const OnsetSpeeds& speeds, std::size_t lane);
/// Sets the law's history variables of a contact that begins; `approach` in m/s.
void begin_law_history(Lanes (&law_history)[contact::law_history_size],
                       const PairParameters& parameters, std::size_t lane, double approach,
                       const contact::AnyLaw& law);

/// What the springs of a contact store, at most as much as friction can hold.
StoredEnergy stored_energy(const PairParameters& parameters, std::size_t lane, double overlap,
                           const double* law_history, const Vec3& spring, double twist,
                           const contact::ContactModel& model);
/// Energy [J] of a contact of lane 0 that the starting positions press to `overlap` [m]. A law with
/// plastic deformation dissipates its part of it in the first step.
double energy_at_start(const PairParameters& parameters, double overlap,
                       const contact::AnyLaw& law);
/// Elastic energy [J] that a contact loses as it breaks at its pull-off distance; 0 without
/// adhesion.
double separation_energy(const PairParameters& parameters, std::size_t lane,
                         const contact::AnyLaw& law);

/// Adds the work of a lane to the energy balance.
void add_work(scene::EnergyBalance& energy_balance, const ContactWork& work, std::size_t lane);

/// Whether a contact is a sustained one: its `duration` [s] exceeds five times the duration of a
/// collision.
bool is_sustained(double duration, const ContactOnset& onset, const SpeciesPair& pair,
                  const contact::AnyLaw& law);

/// The constants of all packets and steps. The caller sets the jar velocity at each step.
StepConstants step_constants(const Settings& settings, const Vec3& periods);

/// Adds `more` to `sum`; `more` may be empty.
inline void add_loads(std::span<scene::WallLoad> sum, std::span<const scene::WallLoad> more) {
  for (std::size_t k = 0; k < more.size(); ++k) {
    sum[k].impulse += more[k].impulse;
    sum[k].angular_impulse += more[k].angular_impulse;
    sum[k].work += more[k].work;
    sum[k].about_mill_axis += more[k].about_mill_axis;
  }
}

}  // namespace mahlwerk::soft
