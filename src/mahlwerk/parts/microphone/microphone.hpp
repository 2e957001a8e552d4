// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::parts::microphone {

/// Microphone or acoustic sensor that counts hits; the section [microphone]
/// (docs/theory/sensors.md).
struct Microphone {
  enum class Hears { jar, all };  ///< hits on the jar only, or also those between balls
  double threshold = 0;           ///< [J] least normal energy of a hit that is heard
  double definition_time = 1e-3;  ///< [s] hits with shorter intervals are heard as one
  Hears hears = Hears::jar;
  bool operator==(const Microphone&) const = default;
};

}  // namespace mahlwerk::parts::microphone
