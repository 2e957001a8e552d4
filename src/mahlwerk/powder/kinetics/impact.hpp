// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/powder/kinetics/milling_conditions.hpp"

namespace mahlwerk::powder {

/// How often the powder is processed, and by which hits.
struct ImpactRates {
  double first = 0, second = 0;  ///< [1/s] rates of both reactions (rea.3)
  double hits = 0;               ///< [1/s] hits that process powder
  double power = 0;              ///< [W] their energies per second
  double mass = 0;               ///< [kg/s] powder that they process
};

/// Conversion by impacts (Colacino et al. 2018 and earlier work of Delogu): each hit processes a
/// share of the powder that it captures, if its energy reaches a threshold.
struct ImpactKinetics {
  static constexpr std::string_view name = "by-impact";
  static constexpr std::string_view about =
      "each hit processes a share of the captured powder, above a threshold energy";
  enum class Scheme {
    simple,      ///< A -> B
    sequential,  ///< A -> B -> C, a hit each
    parallel     ///< A -> B and A -> C
  };
  double processed_share = 0;   ///< [1] kappa, > 0, at most 1
  double threshold_energy = 0;  ///< [J] E_0 >= 0
  double energy_exponent = 0;   ///< [1] q >= 0
  double reference_energy = 0;  ///< [J] E_r > 0 if q > 0, else without meaning
  double second_share = 0;      ///< [1] kappa of the second reaction
  double second_threshold = 0;  ///< [J] E_0 of the second reaction
  Scheme scheme = Scheme::simple;
  std::int64_t hits_needed = 1;  ///< 1 to `most_hits`; above 1 for a simple scheme only

  static constexpr std::int64_t most_hits = 1000;
  static constexpr auto fields() {
    using M = ImpactKinetics;
    constexpr Range shares{.least = 0, .most = 1, .without_least = true};
    return std::array{
        Field<M>{"processed_share", "", &M::processed_share, shares,
                 "kappa: share of the captured powder that a hit processes"},
        Field<M>{"threshold_energy", "J", &M::threshold_energy, not_negative,
                 "energy below which a hit processes nothing", 0.0, "every hit counts"},
        Field<M>{"energy_exponent", "", &M::energy_exponent, not_negative,
                 "exponent of the processed share's growth with the energy beyond the threshold",
                 0.0, "the same share at all energies"},
        Field<M>{"reference_energy", "J", &M::reference_energy, positive,
                 "energy beyond the threshold at which the share is processed_share"},
        Field<M>{"second_share", "", &M::second_share, shares,
                 "share of the captured powder that a hit processes by the second reaction"},
        Field<M>{"second_threshold", "J", &M::second_threshold, not_negative,
                 "threshold energy of the second reaction", 0.0, "every hit counts"}};
  }

  bool has_second() const { return scheme != Scheme::simple; }
  /// [1] Share of the captured powder that a hit of `energy` [J] processes by the first or the
  /// second reaction, 0 to 1 (rea.1).
  double share_of_hit(double energy, bool second = false) const;
  ImpactRates rates(const MillingConditions& mill) const;
  ReactionShares shares(const MillingConditions& mill, double time) const;
  bool operator==(const ImpactKinetics&) const = default;
};

/// [1] Share of the powder that was processed at least `needed` >= 1 times, where the mean number
/// is `mean` >= 0 (rea.4).
double share_processed(double mean, std::int64_t needed);

}  // namespace mahlwerk::powder
