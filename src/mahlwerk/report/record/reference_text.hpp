// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/report/record/references.hpp"

// A reference as a line of a list and as an entry of BibTeX.
namespace mahlwerk::report {

/// "S. Luding and S. McNamara": first names before family names.
std::string names_text(std::string_view authors);

/// One line of a reference list, without its number, with a full stop:
/// "B. D. Lubachevsky. How to ... Journal of Computational Physics 94 (1991) 255-283. doi:...".
std::string reference_text(const Reference& reference);

/// An entry of BibTeX with a new line at its end. Characters that LaTeX reads as commands are
/// escaped; braces of texts become parentheses.
std::string bibtex(const Reference& reference);

}  // namespace mahlwerk::report
