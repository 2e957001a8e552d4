// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/base/indirect.hpp"

// Models of capture, breakage, fragments and kinetics chosen at run time, as incomplete types;
// powder/models.hpp lists the models.
namespace mahlwerk::powder {

struct AnyCapture;
struct AnyBreakage;
struct AnyFragments;
struct AnyKinetics;
struct MillingConditions;
struct ReactionShares;

std::string_view name_of(const AnyCapture& capture);      ///< "barrios"
std::string_view name_of(const AnyBreakage& breakage);    ///< "tavares"
std::string_view name_of(const AnyFragments& fragments);  ///< "austin"
std::string_view name_of(const AnyKinetics& kinetics);    ///< "by-impact"
std::string_view about(const AnyCapture& capture);        ///< short description
/// Whether the model has a median strength, which [capture] may use.
bool has_median_strength(const AnyBreakage& breakage);
/// Whether the model keeps a strength for each grain.
bool tracks_strength(const AnyBreakage& breakage);

/// Shares of reactant and products after a milling `time` [s] >= 0.
ReactionShares reaction_shares(const AnyKinetics& kinetics, const MillingConditions& mill,
                               double time);
/// Whether the model takes the hits on the powder one energy after the other.
bool reads_hits(const AnyKinetics& kinetics);
/// Whether the model has two products.
bool has_second_product(const AnyKinetics& kinetics);
/// Whether the model reads the temperature of the powder.
bool reads_temperature(const AnyKinetics& kinetics);

/// Composition of a captured bed.
enum class Bed {
  by_size,  ///< each hit captures grains of one size, chosen in proportion to their mass
  mixed     ///< each hit captures the mixed powder, in a bed as high as its mean size
};

}  // namespace mahlwerk::powder
