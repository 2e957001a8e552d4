// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mahlwerk::scene {

/// State of a grain of the powder. Its sphere is one particle, or represents many of one size.
struct GrainState {
  double size = 0;         ///< [m] of its particles
  double strength = 0;     ///< of its particles, in the terms of GrainBreakage
  double peak = 0;         ///< [J] largest energy of the present stressing (bed.3); least one since
  double broken = 0;       ///< [J/kg] largest energy of the stressing that broke it
  std::uint64_t draw = 0;  ///< state of its random numbers
  enum class Phase : std::int64_t {
    whole,
    breaks,   ///< in the present stressing, whose largest energy decides how fine
    rests,    ///< whole, since the last stressing: its load falls
    replaced  ///< soon, by its fragments
  };
  Phase phase = Phase::whole;
  std::int64_t broke_at = 0;  ///< step at which it broke
};

/// A change of the mass of powder in a size class.
struct SizeChange {
  double time = 0;              ///< [s] since the start of the run
  double mass = 0;              ///< [kg] gained, < 0 where lost
  std::int32_t size_class = 0;  ///< of GrainBreakage
  std::int32_t broken = 0;      ///< grains of this class that broke
};

/// How grains that an engine moves break (docs/theory/bed-breakage.md). Size classes are numbered
/// from the coarsest on.
class GrainBreakage {
 public:
  virtual ~GrainBreakage() = default;

  virtual std::int32_t kind() const = 0;  ///< ball set of the grains
  virtual std::uint64_t seed() const = 0;
  virtual int classes() const = 0;  ///< of sizes; the finest does not break
  virtual int class_of(double size) const = 0;
  /// [m] Diameters of the spheres, one for each of the first size classes. Finer fragments are not
  /// simulated. Empty: the spheres keep their diameter, and stand for finer particles.
  virtual const std::vector<double>& diameters() const = 0;

  /// The `number`-th grain at the start, a sphere of `diameter` [m].
  virtual GrainState at_start(std::int64_t number, double diameter) const = 0;
  /// A new particle; `draw` makes its random numbers.
  virtual GrainState particle(double size, std::uint64_t draw) const = 0;
  /// Whether a stressing by `energy` [J/kg] breaks the grain.
  virtual bool breaks(const GrainState& grain, double energy) const = 0;
  /// The effect of a stressing by `energy` [J/kg] that did not break the grain.
  virtual void weaken(GrainState& grain, double energy) const = 0;
  /// [m] Size of one fragment of a grain that broke, drawn by mass.
  virtual double fragment_size(const GrainState& grain) const = 0;
  /// [1] Mass shares of the fragments of a grain that broke, by size class; their sum is 1.
  virtual std::vector<double> fragment_shares(const GrainState& grain) const = 0;

  /// Energies of stressings of particles that are not simulated: their bins, two per octave.
  static constexpr int energy_bins = 96;
  static int bin_of(double energy);      ///< of `energy` [J/kg], clamped to the outermost bins
  static double energy_of_bin(int bin);  ///< [J/kg]
  /// Breaks the particles that are not simulated, `mass` [kg] by size class, once `stressed` [kg]
  /// of them have received the energy of each bin.
  virtual void grind(std::vector<double>& mass, std::span<const double> stressed) const = 0;
};

}  // namespace mahlwerk::scene
