// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/cases/read.hpp"

// Small cases for LAMMPS.
namespace mahlwerk::tests {

/// The text of a case with balls of 10 mm in a jar of 60 mm; `more` are further lines of [contact].
inline std::string lammps_case_text(const std::string& mill, const std::string& jar, int balls = 2,
                                    const std::string& more = "restitution = 0.8\nfriction = 0.3") {
  const std::map<std::string, std::string> mills{
      {"still", ""},
      {"vibration", "frequency = \"20 Hz\"\namplitude = \"10 mm\"\ntilt = \"30 deg\"\n"},
      {"planetary", "orbit_radius = \"70 mm\"\nspeed = \"300 rpm\"\nratio = \"1:-2.2\"\n"},
      {"tumbling", "speed = \"90 rpm\"\n"},
      {"circular", "speed = \"600 rpm\"\nradius = \"15 mm\"\n"}};
  const std::map<std::string, std::string> jars{
      {"cylinder", "diameter = \"60 mm\"\nheight = \"50 mm\"\n"},
      {"capsule", "diameter = \"40 mm\"\nheight = \"30 mm\"\n"},
      {"sphere", "diameter = \"60 mm\"\n"},
      {"box", "width = \"60 mm\"\ndepth = \"50 mm\"\nheight = \"40 mm\"\n"}};
  return fmt::format(
      "title = \"For LAMMPS\"\nseed = 3\n[mill]\nkind = \"{}\"\n{}[jar]\nkind = \"{}\"\n{}"
      "youngs_modulus = \"5 GPa\"\npoisson_ratio = 0.3\n[[balls]]\ncount = {}\n"
      "diameter = \"10 mm\"\ndensity = \"7850 kg/m3\"\nyoungs_modulus = \"5 GPa\"\n"
      "poisson_ratio = 0.3\n[contact]\nlaw = \"hertz-mindlin\"\nrolling = \"none\"\n"
      "curved_walls = true\nsoftening = 1\n{}\n[run]\nengine = \"lammps\"\ntime = \"0.2 s\"\n"
      "time_step = \"1 us\"\nreplicates = 1\n[observe]\nthreshold = \"0.1 m/s\"\n",
      mill, mills.at(mill), jar, jars.at(jar), balls, more);
}

inline cases::Case case_of_text(const std::string& text,
                                const std::vector<cases::Override>& set = {}) {
  static const cases::Catalogue catalogue(std::string(MAHLWERK_HOME) + "/catalogue");
  return cases::read_text(text, "case.toml", catalogue, set);
}

inline cases::Case lammps_case(const std::string& mill, const std::string& jar, int balls = 2,
                               const std::vector<cases::Override>& set = {}) {
  return case_of_text(lammps_case_text(mill, jar, balls), set);
}

}  // namespace mahlwerk::tests
