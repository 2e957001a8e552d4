// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/case.hpp"

// Which publications the models of the program follow, and which models a run uses.
namespace mahlwerk::report {

/// A model of a register, or another method that a case chooses.
struct CitedModel {
  std::string_view subject;            ///< "contact law"
  std::string_view model;              ///< its name in the register: "hertz-mindlin"
  std::vector<std::string_view> keys;  ///< of references()
  std::string_view why_none = {};      ///< why it needs no reference, if it has none
};

/// All of them, in the order in which a text names them.
std::span<const CitedModel> cited_models();

/// What is known of a run besides its case.
struct RunState {
  cases::EngineName engine = cases::EngineName::event;  ///< never auto
  bool has_regime = false;  ///< whether its result names the regime of the charge
};

/// The models that a run uses, in the order of cited_models(). Throws std::logic_error if the table
/// lacks one of them.
std::vector<const CitedModel*> used_models(const cases::Case& c, const RunState& run);

}  // namespace mahlwerk::report
