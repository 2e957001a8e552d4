// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Runs a case file and prints its collision rate.
#include <iostream>
#include <mahlwerk/base/data_folder.hpp>
#include <mahlwerk/campaign/run/run.hpp>

int main(int count, char** arguments) try {
  mahlwerk::set_data_folder(MAHLWERK_DATA_FOLDER);
  const mahlwerk::cases::Catalogue catalogue(mahlwerk::data_folder("catalogue"));
  const char* file = count > 1 ? arguments[1] : "case.toml";
  const auto mill_case = mahlwerk::cases::read(file, catalogue);
  const auto outcome = mahlwerk::campaign::run(mill_case);
  const auto& rate = mahlwerk::results::named(outcome.summary.quantities, "collision_rate");
  std::cout << rate.value << " +- " << rate.half_width() << " " << rate.unit << "\n";
} catch (const mahlwerk::InputError& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
