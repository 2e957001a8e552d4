// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What the results say of parts in the jar, against the balance of energy and of forces.
#include <cmath>
#include <numbers>

#include "mahlwerk/results/files/json_value.hpp"
#include "program.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::machine_parts_test {
namespace {

using results::Json;

class PartResults : public ProgramTest {
 protected:
  Json run(const std::string& words) const {
    const ProgramResult told = mahlwerk("run " + words + " --out r");
    EXPECT_EQ(told.code, 0) << told.output;
    return Json::parse(text("r/summary.json"));
  }
  static std::string example(const char* file) {
    return std::string(MAHLWERK_HOME) + "/examples/13-parts/" + file;
  }
};

double value(const Json& of, const std::string& quantity) {
  return std::get<double>(of.find(quantity)->find("value")->value());
}

const Json::Array& parts(const Json& summary) {
  return std::get<Json::Array>(summary.find("_parts")->value());
}

/// All parts are on one shaft: the sum of their torques times its speed is the power that they put
/// in, and with a jar that stands still this is all that the books of the energy have.
TEST_F(PartResults, torque_of_the_shaft_times_its_speed_is_the_power_in_the_books) {
  const Json summary = run("'" + example("case.toml") +
                           "' --set run.time='30 ms' --set run.settle='20 ms' --set "
                           "run.replicates=1");
  constexpr double speed = 1000 * 2 * std::numbers::pi / 60;
  double torque = 0;
  for (const Json& part : parts(summary)) torque += value(part, "torque");
  const double drawn = value(summary, "drawn_power");
  EXPECT_GT(drawn, 0.5) << "[W] the shaft works";
  states("torque times speed [W]", torque * speed, drawn, 1e-9 * drawn, "energy balance");
  states("power of the parts [W]", value(summary, "parts_power"), drawn, 1e-9 * drawn,
         "energy balance");
}

/// Without friction the wall bears nothing along the die: the floor bears the weight of the beads
/// and the force of the piston, but for the change of the momentum of the beads.
TEST_F(PartResults, the_floor_under_a_piston_bears_the_weight_and_the_force_of_the_piston) {
  std::string text_of_case;
  {
    std::ifstream in(example("piston.toml"));
    std::ostringstream all;
    all << in.rdbuf();
    text_of_case = all.str();
  }
  const std::string floor =  // so high that the piston reaches the denser bed without friction
      "[[parts]]\nname = \"floor\"\nkind = \"plane\"\n"
      "position = [\"0 mm\", \"0 mm\", \"-28 mm\"]\n\n";
  text_of_case.insert(text_of_case.find("[[balls]]"), floor);
  std::ofstream(here_ / "die.toml") << text_of_case;
  const Json summary =
      run("die.toml --set contact.friction=0 --set run.settle='0.2 s' --set run.time='40 ms'");
  const double piston = value(parts(summary)[0], "force_z"),
               found = value(parts(summary)[1], "force_z");
  const double mass = 1e-3 * value(summary, "balls_mass");  // g
  EXPECT_LT(piston, -0.5) << "[N] the piston presses";
  // The beads are no faster on average than the piston at the beginning of the 40 ms.
  const double fastest = 0.006 * 4 * std::numbers::pi * std::sin(4 * std::numbers::pi * 0.2);
  states("force of the floor [N]", found, mass * 9.81 - piston,
         mass * std::abs(fastest) / 0.04 + 1e-3 * mass * 9.81, "balance of forces");
}

}  // namespace
}  // namespace mahlwerk::tests::machine_parts_test
