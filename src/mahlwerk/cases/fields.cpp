// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/fields.hpp"

#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk::cases {

using contact::LawName;
using contact::Rolling;

bool has_meaning(std::string_view key, const contact::LawChoice& choice) {
  const LawName law = choice.law;
  if (key == "rolling_friction") return choice.rolling != Rolling::none;
  if (key == "rolling_damping") return choice.rolling == Rolling::epsd;
  if (key.starts_with("stiffness"))
    return law == LawName::linear_spring || law == LawName::walton_braun;
  if (key.starts_with("damping")) return law == LawName::adams_impact;
  if (key == "surface_energy") return law == LawName::jkr;
  if (key == "cohesion") return law == LawName::sjkr;
  return true;
}

std::string_view unit_of(std::string_view key, std::string_view unit,
                         const contact::LawChoice& choice) {
  return key == "rolling_friction" && choice.rolling == Rolling::viscous ? "s/m" : unit;
}

const std::vector<std::string>& contact_laws() {
  static const std::vector<std::string> words(contact::law_words.begin(), contact::law_words.end());
  return words;
}

const std::vector<std::string>& rolling_words() {
  static const std::vector<std::string> words(contact::rolling_words.begin(),
                                              contact::rolling_words.end());
  return words;
}

const std::vector<std::string>& damping_words() {
  static const std::vector<std::string> words{"exact", "published"};
  return words;
}

const std::vector<std::string>& until_words() {
  static const std::vector<std::string> words{"dissipated_power", "drawn_power", "collision_rate",
                                              "collision_rate_above_threshold",
                                              "energy_normal_mean"};
  return words;
}

const std::vector<std::string>& start_frames() {
  static const std::vector<std::string> words{"laboratory", "jar"};
  return words;
}

const std::vector<std::string>& frames_formats() {
  static const std::vector<std::string> words{"both", "xyz", "vtk"};
  return words;
}

const std::vector<std::string>& engines() {
  static const std::vector<std::string> words{"event", "soft", "auto"};
  return words;
}

std::string_view name_of(EngineName engine) {
  return engines()[static_cast<std::size_t>(engine)];
}

const std::vector<std::string>& wear_models() {
  static const std::vector<std::string> words{"archard", "finnie"};
  return words;
}

const std::vector<std::string>& powder_words() {
  static const std::vector<std::string> words{"mass", "grains"};
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

std::string places_text(const std::vector<Vec3>& positions) {
  std::string rows;
  for (const Vec3& p : positions)
    rows += fmt::format("{}[{}, {}, {}]", rows.empty() ? "" : ", ", in_quotes(show(p.x, "m")),
                        in_quotes(show(p.y, "m")), in_quotes(show(p.z, "m")));
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
