// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [run] device = "gpu" by the program, with the pretended card of tests/card.
#include <csignal>

#include "mahlwerk/results/files/json_value.hpp"
#include "program.hpp"

namespace mahlwerk::tests::card_test {
namespace {

using results::Json;

const std::string a_drum = R"(
[mill]
kind = "tumbling"
speed = "60 rpm"
[jar]
kind = "cylinder"
diameter = "60 mm"
height = "30 mm"
material = "steel-304"
[[balls]]
material = "steel-304"
diameter = "4 mm"
count = 300
[contact]
softening = 0.001
[run]
engine = "soft"
device = "gpu"
time = "0.4 s"
settle = "0 s"
replicates = 2
sensitivity = "off"
)";

class CardRuns : public ProgramTest {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(MAHLWERK_DEVICE_CODE "/common.ptx"))
      GTEST_SKIP() << "no device code: it needs clang";
    ProgramTest::SetUp();
    std::ofstream(here_ / "case.toml") << a_drum;
    setenv("MAHLWERK_CUDA_DRIVER", MAHLWERK_CARD, 1);
  }
  void TearDown() override {
    for (const char* name : {"MAHLWERK_CUDA_DRIVER", "MAHLWERK_CARD_FAILS", "MAHLWERK_CARD_MEMORY",
                             "MAHLWERK_CARDS", "MAHLWERK_CARD_VERSION"})
      unsetenv(name);
    ProgramTest::TearDown();
  }
  double power(const std::string& folder) const {
    const Json all = Json::parse(text(folder + "/summary.json"));
    return std::get<double>(all.find("dissipated_power")->find("value")->value());
  }
};

TEST_F(CardRuns, have_the_power_of_the_processor_and_name_the_card) {
  const ProgramResult card = mahlwerk("run case.toml --out card"),
                      again = mahlwerk("run case.toml --out again --threads 1 --quiet"),
                      cpu = mahlwerk("run case.toml --out cpu --quiet --set run.device=cpu");
  ASSERT_EQ(card.code + again.code + cpu.code, 0) << card.output << cpu.output;
  EXPECT_NE(card.output.find("Computed by the graphics card Pretended Card"), std::string::npos);
  EXPECT_EQ(power("card"), power("again")) << "to the bit";
  // Chaos parts the two runs; the power of two replicates of 300 balls varies by some per cent.
  EXPECT_NEAR(power("card"), power("cpu"), 0.15 * power("cpu"));
}

TEST_F(CardRuns, turn_the_mill_as_its_speed_over_time_says) {
  const std::string rows = "'[[\"0 s\", 1], [\"0.1 s\", 1], [\"0.2 s\", -1], [\"0.4 s\", -1]]'",
                    set = " --quiet --set mill.speed_over_time=" + rows;
  const ProgramResult card = mahlwerk("run case.toml --out card" + set),
                      cpu = mahlwerk("run case.toml --out cpu --set run.device=cpu" + set);
  ASSERT_EQ(card.code + cpu.code, 0) << card.output << cpu.output;
  EXPECT_NEAR(power("card"), power("cpu"), 0.15 * power("cpu")) << "as above";
}

TEST_F(CardRuns, go_on_where_another_device_left_them) {
  for (const std::string first : {"gpu", "cpu"}) {
    const std::string second = first == "gpu" ? "cpu" : "gpu", out = "--out " + first;
    const ProgramResult part = mahlwerk_until(
        first + ".checkpoint", SIGINT,
        "run case.toml --checkpoint 0.01 --set run.time=3s --set run.device=" + first + " " + out);
    ASSERT_NE(part.output.find("--resume continues"), std::string::npos) << part.output;
    const ProgramResult rest =
        mahlwerk("run case.toml --resume --set run.time=3s --set run.device=" + second + " " + out);
    EXPECT_EQ(rest.code, 0) << rest.output;
    EXPECT_EQ(rest.output.find("interrupted"), std::string::npos) << rest.output;
    EXPECT_NEAR(std::get<double>(Json::parse(text(first + "/summary.json"))
                                     .find("simulated_time")
                                     ->find("value")
                                     ->value()),
                3, 1e-4);
  }
}

TEST_F(CardRuns, say_what_is_missing) {
  const auto refused = [&](const std::string& set, const std::string& words) {
    const ProgramResult run = mahlwerk("run case.toml --out none " + set);
    EXPECT_EQ(run.code, 2) << set;
    EXPECT_NE(run.output.find(words), std::string::npos) << run.output;
    EXPECT_FALSE(std::filesystem::exists(here_ / "none"));
  };
  refused("--set run.engine=event", "engine = \"event\" does not compute on a graphics card");
  refused("--set run.engine=auto", "engine = \"auto\" does not compute on a graphics card");
  refused("--set contact.curved_walls=true", "does not compute the curvature of walls");
  refused("--set drive.inertia='1 kg m2' --set drive.torque='1 N m'",
          "does not compute a mill that a motor turns");
  setenv("MAHLWERK_CARD_MEMORY", "500000", 1);
  refused("", "about 1.2e+02 fit");
  EXPECT_NE(mahlwerk("check case.toml").output.find("need about 1.2 MB"), std::string::npos);
  unsetenv("MAHLWERK_CARD_MEMORY");
  EXPECT_NE(mahlwerk("check case.toml").output.find("card_memory"), std::string::npos);
  setenv("MAHLWERK_CARD_VERSION", "7", 1);
  refused("", "compute capability 7.0");
  setenv("MAHLWERK_CARDS", "0", 1);
  refused("", "the driver finds none");
  setenv("MAHLWERK_CUDA_DRIVER", "/nowhere.so", 1);
  refused("", "there is no driver library /nowhere.so");
}

TEST_F(CardRuns, that_fail_keep_what_was_computed) {
  // Once, or from then on, as a card does whose memory a kernel has broken.
  for (const std::string call :
       {"cuCtxSynchronize 1000", "cuCtxSynchronize 1001+", "cuMemcpyDtoH_v2 1500+",
        "cuLaunchKernel 9000+", "cuMemAlloc_v2 60", "cuMemAlloc_v2 50", "cuMemcpyHtoD_v2 500+"}) {
    SCOPED_TRACE(call);
    setenv("MAHLWERK_CARD_FAILS", call.c_str(), 1);
    const ProgramResult run = mahlwerk("run case.toml --out part --set run.replicates=1");
    EXPECT_EQ(run.code, 3) << run.output;
    EXPECT_NE(run.output.find("the graphics card Pretended Card"), std::string::npos) << run.output;
    EXPECT_TRUE(std::filesystem::exists(here_ / "part/summary.json"));
    std::filesystem::remove_all(here_ / "part");
  }
}

TEST_F(CardRuns, are_refused_without_the_code_for_cards_of_this_version) {
  // A copy of the program finds its data beside itself.
  std::filesystem::create_directories(here_ / "bin");
  std::filesystem::create_directories(here_ / "share/mahlwerk/device");
  std::filesystem::copy(MAHLWERK_PROGRAM, here_ / "bin/mahlwerk");
  setenv("MAHLWERK_CATALOGUE", MAHLWERK_HOME "/catalogue", 1);
  const auto refused = [&](const std::string& words) {
    const int code = std::system(
        ("cd '" + here_.string() + "' && bin/mahlwerk check case.toml > said 2>&1").c_str());
    EXPECT_EQ(WEXITSTATUS(code), 2);
    EXPECT_NE(text("said").find(words), std::string::npos) << text("said");
    EXPECT_NE(text("said").find("./mahlwerk device"), std::string::npos) << text("said");
  };
  refused("cannot be read");
  std::ofstream(here_ / "share/mahlwerk/device/common.ptx") << "mahlwerk_layout = 7;";
  refused("is damaged or that of another version");
  std::filesystem::remove_all(here_ / "share");
  refused("is not here");
  unsetenv("MAHLWERK_CATALOGUE");
}

}  // namespace
}  // namespace mahlwerk::tests::card_test
