// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/cases/catalogue.hpp"

// A case from a few words: of the command line, or of a form.
namespace mahlwerk::commands {

/// The words of `mahlwerk estimate`; empty: not given.
struct EstimateWords {
  std::string mill;                     ///< of the catalogue
  std::string jar = {};                 ///< of the catalogue, or a volume: "25ml"
  std::string material = {};            ///< of balls and jar
  std::vector<std::string> balls = {};  ///< "2x10mm", "50g x 3mm", "30% x 5mm"; or of the catalogue
  std::string frequency = {}, speed = {};
  std::string powder = {};  ///< a mass, or the mass of the balls over it: "10:1"
  std::string time = {};    ///< of milling
};

/// The case as a TOML text. `counted` is run.time. Throws InputError.
std::string estimate_case(const EstimateWords& words, const cases::Catalogue& catalogue,
                          const std::string& counted);

}  // namespace mahlwerk::commands
