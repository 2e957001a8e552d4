// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/base/indirect.hpp"

// Models of capture, breakage and fragments chosen at run time, for those who do not look into
// them; powder/models.hpp lists what they can be.
namespace mahlwerk::powder {

struct AnyCapture;
struct AnyBreakage;
struct AnyFragments;

std::string_view name_of(const AnyCapture& capture);      ///< "barrios"
std::string_view name_of(const AnyBreakage& breakage);    ///< "tavares"
std::string_view name_of(const AnyFragments& fragments);  ///< "austin"
std::string_view about(const AnyCapture& capture);        ///< what it is, in a few words
/// Whether it knows the strength of grains that [capture] leaves to it.
bool has_median_strength(const AnyBreakage& breakage);
/// Whether it keeps a strength for each grain.
bool tracks_strength(const AnyBreakage& breakage);

/// What a bed is made of.
enum class Bed {
  by_size,  ///< each hit meets grains of one size, which it meets as often as there is mass of them
  mixed     ///< each hit meets the powder as it is, in a bed as high as its mean size
};

}  // namespace mahlwerk::powder
