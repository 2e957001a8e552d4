// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/report/methods.hpp"
#include "mahlwerk/report/record/models.hpp"
#include "mahlwerk/report/record/references.hpp"

// What a publication cites that used a run.
namespace mahlwerk::report {

/// A model of the run with its references, by their numbers in Citation::references.
struct CitedUse {
  std::string subject, model;        ///< "contact law" and "hertz-mindlin"
  std::vector<std::size_t> numbers;  ///< from 1
};

struct Citation {
  /// The methods paragraph, followed by the models with the numbers of their references.
  std::string paragraph;
  std::vector<CitedUse> models;       ///< those that have references
  std::vector<Reference> references;  ///< the program, publications, entries of the catalogue
};

/// Cites the program, the models that the run uses, and the entries of the catalogue whose values
/// it has (by the origins of the case). `version` is that of the program that ran it.
Citation citation(const cases::Case& c, const RunState& run, const CountedRuns& counted,
                  std::string_view version);

/// The paragraph and the numbered references as text.
std::string citation_text(const Citation& citation);
/// The references as entries of BibTeX.
std::string citation_bibtex(const Citation& citation);

}  // namespace mahlwerk::report
