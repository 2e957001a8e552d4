// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

// The bibliography: every publication that a model of the program follows, once.
namespace mahlwerk::report {

/// A publication, or another source. Texts are UTF-8; empty if not known or without meaning.
struct Reference {
  enum class Kind { article, book, chapter, other };
  std::string key;  ///< "lubachevsky1991": of BibTeX and of the tables of models
  Kind kind = Kind::article;
  std::string authors;  ///< as in BibTeX: "Luding, S. and McNamara, S."
  std::string title;
  std::string published;  ///< journal, publisher, title of the book of a chapter; or what it is
  int year = 0;           ///< 0: not known
  std::string volume = {}, pages = {};  ///< "255-283"
  std::string doi = {};                 ///< "10.1016/...", only where it was confirmed
  std::string note = {};                ///< one sentence without a full stop
};

/// The publications, sorted by key.
const std::vector<Reference>& references();

/// The reference of a key. Throws std::out_of_range for a key that the bibliography lacks.
const Reference& reference(std::string_view key);

/// The program itself, as CITATION.cff of the sources says.
Reference program_reference(std::string_view version);

}  // namespace mahlwerk::report
