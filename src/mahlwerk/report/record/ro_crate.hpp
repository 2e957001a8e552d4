// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/report/record/citation.hpp"
#include "mahlwerk/results/files/json_value.hpp"

// A run as an RO-Crate 1.1 (https://w3id.org/ro/crate/1.1): a folder of data with a file of
// JSON-LD that describes it.
namespace mahlwerk::report {

/// Name of the file of JSON-LD, as the specification demands.
constexpr std::string_view crate_file = "ro-crate-metadata.json";

/// A file or folder of the crate, by its path relative to it.
struct CratePart {
  std::string path;          ///< of a folder "frames/"
  std::uintmax_t bytes = 0;  ///< size of a file
};

struct CrateAuthor {
  std::string name;
  std::string orcid;  ///< "0000-0002-1825-0097", or empty
};

/// What a crate describes.
struct CrateContent {
  const cases::Case& mill_case;  ///< with the origins of the run
  const results::Json& summary;  ///< of summary.json
  const Citation& cited;
  std::string methods;    ///< the methods paragraph
  std::string case_file;  ///< path of the case in the crate, one of `parts`
  std::vector<CratePart> parts;
  std::vector<CrateAuthor> authors;
  std::string license;  ///< identifier of SPDX or address; empty: none is given
  std::string date;     ///< of publication, "2026-11-28"
  std::string version;  ///< of the program that ran the case
  std::string failure;  ///< why the run is incomplete; empty if it is complete
};

/// The content of ro-crate-metadata.json.
results::Json ro_crate(const CrateContent& content);

}  // namespace mahlwerk::report
