// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/fields.hpp"

namespace mahlwerk::cases {

const std::vector<std::string>& contact_laws() {
  static const std::vector<std::string> words{"hertz-mindlin", "hertz-tsuji",  "linear-spring",
                                              "adams-impact",  "walton-braun", "jkr"};
  return words;
}

const std::vector<std::string>& engines() {
  static const std::vector<std::string> words{"event", "soft", "auto"};
  return words;
}

const std::vector<std::string>& lasting_words() {
  static const std::vector<std::string> words{"roll", "tc", "none"};
  return words;
}

std::string axis_word(const Vec3& axis) {
  if (axis == kinematics::upright) return "vertical";
  return axis == kinematics::lying ? "horizontal" : "";
}

}  // namespace mahlwerk::cases
