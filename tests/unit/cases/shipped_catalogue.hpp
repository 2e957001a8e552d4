// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "mahlwerk/cases/catalogue.hpp"

// The catalogue that the program comes with.
namespace mahlwerk::cases::sample {

inline const Catalogue& shipped() {
  static const Catalogue catalogue(std::filesystem::path(MAHLWERK_HOME) / "catalogue");
  return catalogue;
}

template <class Visit>
void for_each_entry(Visit visit) {
  for (const std::string_view category : Catalogue::categories) {
    for (const std::string& name : shipped().names(category)) {
      SCOPED_TRACE(std::string(category) + "/" + name);
      CatalogueEntry entry;
      ASSERT_NO_THROW(entry = shipped().find(category, name));
      visit(entry);
    }
  }
}

}  // namespace mahlwerk::cases::sample
