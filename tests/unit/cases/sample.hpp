// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"

// A small catalogue with known contents in a temporary folder, and helpers to read cases with it.
namespace mahlwerk::cases::sample {

/// A temporary folder, removed by the destructor.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "mahlwerk-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for a test");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((path_ / file).parent_path());
    std::ofstream(path_ / file) << text;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The beginning of a case, which lacks [contact] and [run].
inline const std::string vial_with_two_balls = R"(
title = "vial"
[mill]
kind = "vibration"
frequency = "19 Hz"
amplitude = "25 mm"
[jar]
kind = "cylinder"
diameter = "20 mm"
height = "20 mm"
[[balls]]
count = 2
diameter = "5 mm"
density = "7850 kg/m3"
)";

inline std::string entry_value(const std::string& key, const std::string& value) {
  return "[" + key + "]\nvalue = \"" + value + "\"\nsource = \"test sheet\"\n";
}

inline const Catalogue& catalogue() {
  static const Folder folder;
  static const Catalogue made = [] {
    const auto entry = [](const std::string& file, const std::string& kind,
                          const std::vector<std::pair<std::string, std::string>>& values) {
      std::string text = "title = \"Test " + file + "\"\nabout = \"for tests\"\n";
      if (!kind.empty()) text += "kind = \"" + kind + "\"\n";
      for (const auto& [key, value] : values) text += entry_value(key, value);
      folder.write(file + ".toml", text);
    };
    entry("mills/p7", "planetary",
          {{"orbit_radius", "70 mm"},
           {"ratio", "1:-2"},
           {"speed_least", "100 rpm"},
           {"speed_most", "800 rpm"}});
    entry("mills/shaky", "vibration",
          {{"amplitude", "25 mm"}, {"frequency_least", "10 Hz"}, {"frequency_most", "25 Hz"}});
    entry(
        "jars/pot", "cylinder",
        {{"diameter", "42 mm"}, {"height", "32.5 mm"}, {"volume", "45 ml"}, {"material", "steel"}});
    entry("materials/steel", "",
          {{"density", "7700 kg/m3"}, {"youngs_modulus", "200 GPa"}, {"poisson_ratio", "0.265"}});
    entry("materials/tic", "", {{"density", "4930 kg/m3"}});
    entry("materials/oil", "", {{"density", "870 kg/m3"}, {"viscosity", "80 mPa s"}});
    entry("materials/mystery", "", {{"hardness", "5"}});
    entry("media/five", "", {{"diameter", "15 mm"}, {"count", "5"}, {"material", "steel"}});
    return Catalogue(folder.path());
  }();
  return made;
}

inline Case read_sample(const std::string& text, const std::vector<Override>& overrides = {}) {
  return read_text(text, "case.toml", catalogue(), overrides);
}

/// Faults found when reading `text`; empty if there are none.
inline std::vector<Fault> faults_of(const std::string& text,
                                    const std::vector<Override>& overrides = {}) {
  try {
    read_sample(text, overrides);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

/// The only fault found when reading, as "where|what|remedy|code"; all of them if there are
/// several.
inline std::string fault_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  std::string all;
  for (const Fault& f : faults_of(text, overrides))
    all += (all.empty() ? "" : "\n") + f.where + "|" + f.what + "|" + f.remedy + "|" + f.code;
  return all;
}

/// Exactly one fault: at `where`, with `what` in its cause or remedy, and with this `code`.
inline ::testing::AssertionResult only(const std::string& text, const std::string& where,
                                       const std::string& what, const std::string& code,
                                       const std::vector<Override>& overrides = {}) {
  const auto found = faults_of(text, overrides);
  if (found.size() == 1 && found[0].where == where && found[0].code == code &&
      (found[0].what + "\n" + found[0].remedy).find(what) != std::string::npos)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "got: " << fault_of(text, overrides);
}

/// The only fault as "what|remedy|code"; all of them if there are several.
inline std::string one_fault(const std::string& text, const std::vector<Override>& overrides = {}) {
  const std::vector<Fault> found = faults_of(text, overrides);
  return found.size() == 1 ? found[0].what + "|" + found[0].remedy + "|" + found[0].code
                           : fault_of(text, overrides);
}
inline void expect_says(const std::string& part, const std::string& text,
                        const std::vector<Override>& overrides = {}) {
  const std::string said = one_fault(text, overrides);
  EXPECT_NE(said.find(part), std::string::npos) << "expected: " << part << "\nsaid: " << said;
}

/// `text` with its first line that begins with `key` replaced by `line`.
inline std::string with(std::string text, std::string_view key, const std::string& line) {
  const auto at = text.find(std::string("\n").append(key));
  if (at == std::string::npos) throw std::runtime_error("no line " + std::string(key));
  const auto end = text.find('\n', at + 1);
  return text.replace(at + 1, end - at - 1, line);
}

inline std::string source_of(const Case& c, std::string_view key) {
  const auto at = std::ranges::find(c.origins, key, &Origin::key);
  return at == c.origins.end() ? "" : at->source;
}

/// The vial of Chen et al. 2016. Lines: frequency 5, amplitude 6, jar 8, volume 11, count 13, ball
/// 14, restitution 17.
inline const std::string vial = R"(title = "vial"
seed = 3
[mill]
kind = "vibration"
frequency = "10 Hz"
amplitude = "25 mm"
# the jar
[jar]
kind = "capsule"
diameter = "12 mm"
volume = "5 ml"
[[balls]]
count = 1
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.9
tangential_restitution = 0.9
[run]
engine = "event"
time = "60 s"
[observe]
threshold = "0.1 m/s"
)";

/// The vial with some powder, from line 24 on.
inline const std::string powdered = vial + R"([powder]
mass = "0.15 g"
density = "1280 kg/m3"
size = "1.3 mm"
)";

inline const std::string planetary = R"([mill]
model = "p7"
speed = "400 rpm"
[jar]
model = "pot"
[[balls]]
count = 5
diameter = "15 mm"
material = "steel"
[powder]
material = "tic"
ball_to_powder = "70:1"
size = "40 um"
[contact]
restitution = 0.35
friction = 0.5
[run]
engine = "soft"
time = "2 s"
settle = "0.5 s"
)";

inline const std::string drum = R"([mill]
kind = "tumbling"
speed = "75 %"
[jar]
kind = "cylinder"
diameter = "200 mm"
height = "60 mm"
[[balls]]
diameter = "10 mm"
density = "7850 kg/m3"
[[balls]]
diameter = "20 mm"
density = "7850 kg/m3"
[run]
time = "1 s"
)";

}  // namespace mahlwerk::cases::sample
