// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// `run --engine lammps` as a user gives it: folders, refusals, and results where LAMMPS is
// installed.
#include <sys/resource.h>

#include <cmath>

#include "lammps_cases.hpp"
#include "mahlwerk/lammps/program.hpp"
#include "program.hpp"

namespace mahlwerk::tests::lammps_test {
namespace {

namespace fs = std::filesystem;

class LammpsRun : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write_case(lammps_case_text("tumbling", "cylinder", 20));
  }
  void write_case(const std::string& text) const { std::ofstream(here_ / "drum.toml") << text; }
  void replace(const std::string& what, const std::string& by) const {
    std::string all = text("drum.toml");
    all.replace(all.find(what), what.size(), by);
    write_case(all);
  }
  void refuses(const std::string& words, const std::string& because) const {
    const ProgramResult r = mahlwerk("run drum.toml --out out " + words);
    EXPECT_EQ(r.code, 2) << words << "\n" << r.output;
    EXPECT_NE(r.output.find(because), std::string::npos) << words << "\n" << r.output;
    EXPECT_FALSE(fs::exists(here_ / "out")) << words;
    EXPECT_FALSE(fs::exists(here_ / "out.lammps")) << words;
  }
  /// A number of summary.json by the text before it.
  double number(const std::string& summary, const std::string& before) const {
    const std::string all = text(summary);
    const std::size_t at = all.find(before);
    return at == std::string::npos ? NAN : std::stod(all.substr(at + before.size()));
  }
  /// [s] of all programs that this one has started and that have ended.
  static double cpu_of_children() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  }
  static bool has_lammps() { return lammps::installed(1).faults.empty(); }
};

TEST_F(LammpsRun, a_folder_for_another_machine_is_complete_and_starts_nothing) {
  const ProgramResult r = mahlwerk(
      "run drum.toml --out out --ranks 64 --slurm --slurm-option time=10:00:00 --set "
      "run.replicates=2");
  ASSERT_EQ(r.code, 0) << r.output;
  for (const char* file : {"in.lammps", "balls.data", "case.toml", "README.md", "job.slurm"})
    for (const char* replicate : {"replicate-1", "replicate-2"})
      EXPECT_TRUE(fs::exists(here_ / "out.lammps" / replicate / file)) << file;
  const std::string job = text("out.lammps/replicate-1/job.slurm");
  for (const char* line : {"#SBATCH --ntasks=64\n", "#SBATCH --time=10:00:00\n"})
    EXPECT_NE(job.find(line), std::string::npos) << job;
  EXPECT_NE(text("out.lammps/replicate-1/README.md").find("mpirun -np 64 lmp -in in.lammps"),
            std::string::npos);
  EXPECT_NE(text("out.lammps/replicate-1/balls.data"), text("out.lammps/replicate-2/balls.data"));
  EXPECT_FALSE(fs::exists(here_ / "out"));
}

TEST_F(LammpsRun, what_lammps_cannot_compute_is_refused_with_what_it_can) {
  const std::string can = "write engine = \"soft\"";
  replace("law = \"hertz-mindlin\"", "law = \"jkr\"\nsurface_energy = \"1 J/m2\"");
  refuses("", "LAMMPS cannot compute law = \"jkr\"");
  refuses("", "hertz-mindlin");
  write_case(lammps_case_text("planetary", "capsule"));
  refuses("", "a jar of kind \"capsule\" that turns");
  write_case(lammps_case_text("tumbling", "cylinder"));
  replace("time = \"0.2 s\"", "time = \"until 5 %\"");
  refuses("", "its runs have a given length");
  write_case(lammps_case_text("tumbling", "cylinder"));
  replace("restitution = 0.8",
          "restitution = 0.8\nrestitution_law = \"viscoelastic\"\nrestitution_speed = \"1 m/s\"");
  refuses("", "one restitution for all");
  refuses("--write-only", "one restitution for all");
}

TEST_F(LammpsRun, what_is_missing_is_said_with_how_to_install_it) {
  const auto without = [&](const std::string& set) {
    FILE* pipe = popen(("cd '" + here_.string() + "' && " + set + " '" + MAHLWERK_PROGRAM +
                        "' run drum.toml --out out 2>&1")
                           .c_str(),
                       "r");
    std::string said;
    char part[4096];
    while (const std::size_t n = fread(part, 1, sizeof part, pipe)) said.append(part, n);
    EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 2) << said;
    EXPECT_FALSE(fs::exists(here_ / "out")) << said;
    return said;
  };
  fs::create_directory(here_ / "bin");
  const std::string here = "PATH='" + (here_ / "bin").string() + "'";
  EXPECT_NE(without(here).find("apt install lammps"), std::string::npos);
  EXPECT_NE(without("MAHLWERK_LAMMPS=/nowhere/lmp").find("/nowhere/lmp, which is no program"),
            std::string::npos);
  const auto program = [&](const std::string& help) {
    std::ofstream(here_ / "bin" / "lmp") << "#!/bin/sh\ncat <<'END'\n" << help << "\nEND\n";
    fs::permissions(here_ / "bin" / "lmp", fs::perms::owner_all);
    return "MAHLWERK_LAMMPS='" + (here_ / "bin" / "lmp").string() + "'";
  };
  const std::string head = "Large-scale Atomic/Molecular Massively Parallel Simulator - ";
  EXPECT_NE(without(program(head + "3 Mar 2020\ngranular wall/gran/region tracker pair/tracker"))
                .find("is LAMMPS of 3 Mar 2020, older than 29 Sep 2021"),
            std::string::npos);
  EXPECT_NE(without(program(head + "29 Sep 2021 - Update 2\ntracker pair/tracker"))
                .find("lacks the style granular of its package GRANULAR"),
            std::string::npos);
  EXPECT_NE(without(program("what?")).find("an unknown date"), std::string::npos);
}

TEST_F(LammpsRun, options_without_lammps_are_refused) {
  for (const char* words : {"--ranks 2", "--write-only", "--slurm"})
    refuses(std::string("--engine soft ") + words, "another engine than \"lammps\"");
  refuses("--write-only --slurm-option x=1", "--slurm");
  refuses("--slurm --slurm-option 'x\ny'", "line end");
  refuses("--ranks 100000", "would wait for each other");
  refuses("--ranks 0", "--ranks");
}

TEST_F(LammpsRun, results_are_those_of_a_run_and_can_start_another) {
  if (!has_lammps()) GTEST_SKIP() << "LAMMPS is not installed";
  const std::string quick = " --set run.time='0.05 s' --set run.time_step='4 us' --quiet ";
  ProgramResult r =
      mahlwerk("run drum.toml --out there" + quick + "--set observe.final_state=true");
  ASSERT_EQ(r.code, 0) << r.output;
  for (const char* file : {"summary.json", "report.html", "spectrum.csv", "final-1.csv"})
    EXPECT_TRUE(fs::exists(here_ / "there" / file)) << file;
  EXPECT_NE(text("there/summary.json").find("Computed by LAMMPS"), std::string::npos);
  r = mahlwerk("run drum.toml --out here --engine soft --set run.start_from=there" + quick +
               "--set observe.final_state=true");
  EXPECT_EQ(r.code, 0) << r.output;
  r = mahlwerk("run drum.toml --out back --set run.start_from=here" + quick);
  EXPECT_EQ(r.code, 0) << r.output;
  // The same again is refused, replaced, or read.
  r = mahlwerk("run drum.toml --out back --set run.start_from=here" + quick);
  EXPECT_EQ(r.code, 2) << r.output;
  fs::remove_all(here_ / "back");
  r = mahlwerk("run drum.toml --out back --set run.start_from=here" + quick);
  EXPECT_NE(r.output.find("--resume to go on with it or read its results"), std::string::npos)
      << r.output;
  r = mahlwerk("run drum.toml --out back --resume --set run.start_from=here" + quick);
  EXPECT_EQ(r.code, 0) << r.output;
  r = mahlwerk("run drum.toml --out back --resume --set contact.friction=0.1" + quick);
  EXPECT_NE(r.output.find("is that of another case"), std::string::npos) << r.output;
  r = mahlwerk("run drum.toml --out back --force --set run.start_from=here" + quick);
  EXPECT_EQ(r.code, 0) << r.output;
}

TEST_F(LammpsRun, quantities_that_lammps_does_not_know_are_absent) {
  if (!has_lammps()) GTEST_SKIP() << "LAMMPS is not installed";
  const std::string quick = "run drum.toml --set run.time='0.05 s' --set run.time_step='4 us' ";
  const ProgramResult there = mahlwerk(quick + "--out there"),
                      here = mahlwerk(quick + "--out here --engine soft");
  ASSERT_EQ(there.code, 0) << there.output;
  ASSERT_EQ(here.code, 0) << here.output;
  for (const char* name :
       {"energy_lost_mean", "energy_lost_mean_above_threshold", "dissipated_power_of_collisions",
        "dissipated_power_of_lasting_contacts", "energy_residual", "energy_balance"}) {
    const std::string entry = std::string("\"") + name + "\"";
    EXPECT_EQ(text("there/summary.json").find(entry), std::string::npos) << name;
    EXPECT_NE(text("here/summary.json").find(entry), std::string::npos) << name;
  }
  EXPECT_NE(text("there/summary.json").find("\"dissipated_power\""), std::string::npos);
  EXPECT_NE(there.output.find("\nNumerical accuracy\n"), std::string::npos) << there.output;
  // A residual that closes by definition is not printed as one, and none is missed.
  EXPECT_EQ(there.output.find("residual  "), std::string::npos) << there.output;
  EXPECT_EQ(there.output.find("does not close"), std::string::npos) << there.output;
}

TEST_F(LammpsRun, each_frame_of_the_replay_is_later_than_the_one_before) {
  if (!has_lammps()) GTEST_SKIP() << "LAMMPS is not installed";
  // A film of three periods of 20 ms asks for 360 frames; LAMMPS writes 120 rows in that time.
  write_case(lammps_case_text("vibration", "cylinder", 20));
  replace("frequency = \"20 Hz\"", "frequency = \"50 Hz\"");
  const ProgramResult r =
      mahlwerk("run drum.toml --out out --quiet --set run.time='0.2 s' --set run.time_step='4 us'");
  ASSERT_EQ(r.code, 0) << r.output;
  const std::string page = text("out/report.html"), before = "\"times\":[";
  const std::size_t at = page.find(before);
  ASSERT_NE(at, std::string::npos) << "the report has no replay";
  std::istringstream list(page.substr(at + before.size(), page.find(']', at) - at - before.size()));
  std::vector<double> times;
  for (std::string word; std::getline(list, word, ',');) times.push_back(std::stod(word));
  EXPECT_GT(times.size(), 15U);
  for (std::size_t i = 1; i < times.size(); ++i)
    EXPECT_GT(times[i], times[i - 1]) << "frame " << i << " of " << times.size();
}

TEST_F(LammpsRun, a_damaged_folder_is_not_taken_for_results) {
  if (!has_lammps()) GTEST_SKIP() << "LAMMPS is not installed";
  const std::string words =
      "run drum.toml --out out/ --quiet --set run.time='0.05 s' --set run.time_step='4 us'";
  ProgramResult r = mahlwerk(words);
  ASSERT_EQ(r.code, 0) << r.output;
  const fs::path folder = here_ / "out.lammps/replicate-1";
  const std::string whole = text("out.lammps/replicate-1/contacts.0.txt");
  const auto read_again = [&](int code, const std::string& because) {
    const ProgramResult again = mahlwerk(words + " --resume");
    EXPECT_EQ(again.code, code) << because << "\n" << again.output;
    EXPECT_NE(again.output.find(because), std::string::npos) << because << "\n" << again.output;
  };
  read_again(0, "");
  const std::size_t hole = whole.find("ITEM: TIMESTEP", whole.size() / 2),
                    end = whole.find("ITEM: TIMESTEP", hole + 1);
  std::ofstream(folder / "contacts.0.txt") << whole.substr(0, hole) + whole.substr(end);
  read_again(3, "the files contacts.*.txt");
  std::ofstream(folder / "contacts.0.txt") << whole.substr(0, whole.size() / 2) << "nonsense\n"
                                           << whole.substr(whole.size() / 2);
  read_again(3, "contacts.0.txt holds a line that is not LAMMPS's");
  std::ofstream(folder / "contacts.0.txt") << whole;
  // A disk that was full ends the balance early, though LAMMPS wrote its last file: the restart
  // files are behind the hole.
  std::string balance = text("out.lammps/replicate-1/balance.0.txt");
  std::ofstream(folder / "balance.0.txt") << balance.substr(0, balance.size() / 2);
  read_again(3, "the files balance.*.txt");
  fs::remove(folder / "case.toml");
  read_again(2, "is that of another case");
}

TEST_F(LammpsRun, nobody_writes_into_the_folder_of_a_run_at_work) {
  if (!has_lammps()) GTEST_SKIP() << "LAMMPS is not installed";
  const std::string words = "run drum.toml --out out --set run.time='20 s' ";
  const ProgramResult r =
      mahlwerk(words + "--quiet & first=$!; cd '" + here_.string() +
               "'; until [ -e out.lammps/replicate-1/from.0.txt ]; do sleep 0.05; done; '" +
               std::string(MAHLWERK_PROGRAM) + "' " + words +
               "--write-only --force; code=$?; kill $first; wait $first; exit $code");
  EXPECT_EQ(r.code, 2) << r.output;
  EXPECT_NE(r.output.find("is still at work in this folder"), std::string::npos) << r.output;
  EXPECT_TRUE(fs::exists(here_ / "out.lammps/replicate-1/balance.0.txt")) << r.output;
}

TEST_F(LammpsRun, a_start_with_deep_overlaps_is_refused_as_in_the_soft_engine) {
  std::ofstream(here_ / "start.csv")
      << "kind,radius_m,x_m,y_m,z_m,velocity_x_m_per_s,velocity_y_m_per_s,velocity_z_m_per_s,"
         "spin_x_rad_per_s,spin_y_rad_per_s,spin_z_rad_per_s\n"
         "1,0.005,0,0,0,0,0,0,0,0,0\n1,0.005,0.004,0,0,0,0,0,0,0,0\n";
  const std::string words = "--set balls.1.count=2 --set run.start_from=start.csv --quiet";
  const ProgramResult soft = mahlwerk("run drum.toml --out soft --engine soft " + words);
  const ProgramResult by_lammps = mahlwerk("run drum.toml --out out --write-only " + words);
  EXPECT_EQ(soft.code, 2) << soft.output;
  EXPECT_EQ(by_lammps.code, 2) << by_lammps.output;
  EXPECT_NE(by_lammps.output.find("ball 1 overlaps ball 2"), std::string::npos) << by_lammps.output;
}

TEST_F(LammpsRun, a_campaign_has_no_ranks_and_is_not_dropped) {
  std::ofstream(here_ / "sweep.toml")
      << text("drum.toml") << "[sweep]\n\"contact.friction\" = [0.1, 0.2]\n";
  for (const char* words : {"run sweep.toml --ranks 2", "run . --write-only", "run . --slurm"}) {
    const ProgramResult r = mahlwerk(words);
    EXPECT_EQ(r.code, 2) << r.output;
    EXPECT_NE(r.output.find("whose runs have one rank each"), std::string::npos) << r.output;
  }
}

TEST_F(LammpsRun, ctrl_c_ends_lammps_and_the_run_goes_on) {
  if (!has_lammps()) GTEST_SKIP() << "LAMMPS is not installed";
  const std::string words =
      "run drum.toml --out out --set run.time='2 s' --set run.time_step='4 us'";
  const double before = cpu_of_children();
  ProgramResult r = mahlwerk_until("out.lammps/replicate-1/restart.b", SIGINT, words);
  EXPECT_EQ(r.code, 130) << r.output;
  EXPECT_NE(r.output.find("--resume"), std::string::npos) << r.output;
  EXPECT_FALSE(fs::exists(here_ / "out.lammps/replicate-1/restart.end"));
  r = mahlwerk(words + " --resume");
  EXPECT_EQ(r.code, 0) << r.output;
  EXPECT_TRUE(fs::exists(here_ / "out.lammps/replicate-1/restart.end"));
  EXPECT_NE(text("out/summary.json").find("lammps-restarted"), std::string::npos);
  // The CPU time of both processes of LAMMPS counts. Starting, reading the case and the report do
  // not; they take less than half.
  const double all = cpu_of_children() - before,
               counted = number("out/summary.json", "\"cpu_seconds\": ");
  EXPECT_GT(counted, 0.5 * all) << "of " << all << " s";
  EXPECT_LT(counted, all);
}

TEST_F(LammpsRun, a_run_that_ended_while_its_first_restart_file_was_written_begins_again) {
  if (!has_lammps()) GTEST_SKIP() << "LAMMPS is not installed";
  const std::string words =
      "run drum.toml --out out --set run.time='0.5 s' --set run.time_step='4 us'";
  const fs::path folder = here_ / "out.lammps/replicate-1";
  mahlwerk_until("out.lammps/replicate-1/restart.a", SIGINT, words);
  fs::remove(folder / "restart.b");
  std::ofstream(folder / "restart.a") << "LammpS RestartT";
  const ProgramResult r = mahlwerk(words + " --resume");
  EXPECT_EQ(r.code, 0) << r.output;
  EXPECT_TRUE(fs::exists(folder / "restart.end"));
}

}  // namespace
}  // namespace mahlwerk::tests::lammps_test
