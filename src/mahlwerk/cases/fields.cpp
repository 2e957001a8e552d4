// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/fields.hpp"

#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"

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

const std::vector<std::string>& restitution_laws() {
  static const std::vector<std::string> words{"constant", "viscoelastic", "tabulated"};
  return words;
}

std::string table_text(const contact::Restitution& tabulated) {
  std::string rows;
  for (const auto& [speed, value] : tabulated.points())
    rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", in_quotes(show(speed, "m/s")),
                        shortest(value));
  return "[" + rows + "]";
}

std::string between_text(const PairRule& pair) {
  return fmt::format("[{}, {}]", in_quotes(pair.between[0]), in_quotes(pair.between[1]));
}

// Control characters are escaped, so a text cannot leave its line.
std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\u{:04X}", byte);
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string axis_word(const Vec3& axis) {
  if (axis == kinematics::upright) return "vertical";
  return axis == kinematics::lying ? "horizontal" : "";
}

}  // namespace mahlwerk::cases
