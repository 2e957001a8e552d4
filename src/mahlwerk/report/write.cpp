// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "mahlwerk/report/report.hpp"
#include "mahlwerk/results/files/writer.hpp"

namespace mahlwerk::report {

void write(const results::Folder& folder, const Outcome& outcome, std::string_view version,
           std::string_view below, bool film) {
  results::write(folder, outcome, version, below);
  folder.write(std::string(below) + "report.html", report_page(outcome, version, film));
}

}  // namespace mahlwerk::report
