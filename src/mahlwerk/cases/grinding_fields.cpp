// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/grinding_fields.hpp"

namespace mahlwerk::cases {

const std::vector<std::string>& feed_words() {
  static const std::vector<std::string> words{"equal", "sieves", "lognormal", "rosin-rammler"};
  return words;
}

const std::vector<std::string>& capture_energies() {
  static const std::vector<std::string> words{"normal", "contact-point", "lost"};
  return words;
}

const std::vector<std::string>& grinding_methods() {
  static const std::vector<std::string> words{"balance", "statistical", "both"};
  return words;
}

const std::vector<std::string>& bed_words() {
  static const std::vector<std::string> words{"by-size", "mixed"};
  return words;
}

const std::vector<std::string>& dose_words() {
  static const std::vector<std::string> words{"dissipated", "captured"};
  return words;
}

const std::vector<std::string>& kinetics_laws() {
  static const std::vector<std::string> words{"first-order", "avrami"};
  return words;
}

}  // namespace mahlwerk::cases
