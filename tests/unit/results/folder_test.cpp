// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/folder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <iterator>
#include <optional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/files/file_lock.hpp"
#include "mahlwerk/results/files/hdf5.hpp"
#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/files/result_file.hpp"
#include "unit/results/fake.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::results::folder_test {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view our_summary =
    "{\n  \"_about\": {\n    \"mahlwerk\": \"0.1.0\"\n  }\n}\n";

constexpr std::string_view our_picture =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 720 400\" role=\"img\" "
    "aria-label=\"power\"></svg>";

/// Code and text of the error from creating the folder, or an empty string.
std::string refusal(const fs::path& place, bool force) {
  try {
    const Folder folder(place, force);
  } catch (const InputError& e) {
    return e.faults().front().code + ": " + e.what();
  }
  return "";
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

class FolderTest : public ScratchTest {};

TEST_F(FolderTest, appears_only_when_complete) {
  const fs::path place = scratch() / "deep" / "result";
  Folder folder(place, false);
  folder.write("summary.json", our_summary);
  folder.write("point-1/spectrum.csv", "a,b\n");
  EXPECT_FALSE(fs::exists(place));
  folder.commit();
  EXPECT_EQ(read(place / "summary.json"), our_summary);
  EXPECT_EQ(read(place / "point-1" / "spectrum.csv"), "a,b\n");
  EXPECT_EQ(entries(place.parent_path()), 2U) << "the result and its lock, while it is ours";
}

TEST_F(FolderTest, leaves_nothing_behind_when_given_up) {
  {
    Folder folder(scratch() / "result", false);
    folder.write("summary.json", our_summary);
    EXPECT_EQ(entries(scratch()), 2U) << "the unfinished folder and its lock";
  }
  EXPECT_EQ(entries(scratch()), 0U);
}

TEST_F(FolderTest, an_empty_folder_is_filled) {
  fs::create_directory(scratch() / "result");
  Folder folder(scratch() / "result", false);
  folder.write("summary.json", our_summary);
  folder.commit();
  EXPECT_TRUE(fs::exists(scratch() / "result" / "summary.json"));
}

TEST_F(FolderTest, refuses_an_existing_result_unless_forced) {
  const fs::path place = scratch() / "result";
  write_text_of(place / "summary.json", our_summary);
  write_text_of(place / "angles.csv", "old");
  EXPECT_NE(refusal(place, false).find("result-exists"), std::string::npos);
  EXPECT_NE(refusal(place, false).find("--force"), std::string::npos);
  {
    Folder folder(place, true);
    folder.write("summary.json", std::string(our_summary) + "\n");
    EXPECT_TRUE(fs::exists(place / "angles.csv"));  // the old one stays until the new one is there
    folder.commit();
  }
  EXPECT_FALSE(fs::exists(place / "angles.csv"));
  EXPECT_EQ(read(place / "summary.json"), std::string(our_summary) + "\n");
  EXPECT_EQ(entries(scratch()), 1U);
}

TEST_F(FolderTest, never_touches_what_is_not_ours) {
  const fs::path place = scratch() / "thesis";
  write_text_of(place / "chapter1.tex", "years of work");
  EXPECT_NE(refusal(place, true).find("result-exists"), std::string::npos);
  write_text_of(place / "summary.json", "{\"other\": \"program\"}");
  EXPECT_NE(refusal(place, true).find("result-exists"), std::string::npos);
  write_text_of(place / "summary.json", our_summary);
  EXPECT_NE(refusal(place, true).find("chapter1.tex"), std::string::npos);
  fs::remove(place / "chapter1.tex");
  write_text_of(place / "figures" / "a.png", "a plot of the user's");
  EXPECT_NE(refusal(place, true).find("figures/a.png"), std::string::npos);
  EXPECT_EQ(read(place / "figures" / "a.png"), "a plot of the user's");
}

TEST_F(FolderTest, a_campaigns_points_may_be_replaced) {
  const fs::path place = scratch() / "campaign";
  write_text_of(place / "campaign.csv", "point,mill.speed_rpm,collision_rate_per_s\n");
  write_text_of(place / "point-001" / "summary.json", our_summary);
  write_text_of(place / "figures" / "collision_rate.svg", our_picture);
  EXPECT_EQ(refusal(place, true), "");
  write_text_of(place / "point-001" / "notes.txt", "mine");
  EXPECT_NE(refusal(place, true).find("point-001/notes.txt"), std::string::npos);
}

TEST_F(FolderTest, what_is_listed_may_be_replaced_and_nothing_else) {
  const fs::path place = scratch() / "result";
  {
    Folder folder(place, false);
    folder.write("summary.json", our_summary);
    folder.write("figures/mine.svg", our_picture);
    folder.write("any/name.at.all", "ours");
    folder.file("frames-1/of a run that was stopped before the first");
    folder.commit();
  }
  EXPECT_EQ(listed_files(place)->count("any/name.at.all"), 1U);
  EXPECT_EQ(refusal(place, true), "");
  for (const char* name : {"angles.csv", "figures/theirs.svg", "any/other", "slurm-12.out",
                           "campaign.shard-1-of-2.sqlite", "runs/notes.txt", "deep/down/summary"}) {
    write_text_of(place / name, our_picture);
    EXPECT_NE(refusal(place, true).find("did not write"), std::string::npos) << name;
    EXPECT_EQ(read(place / name), our_picture);
    fs::remove(place / name);
    for (const char* folder : {"deep/down", "deep", "runs"}) fs::remove(place / folder);
  }
  fs::create_directory(place / "empty");
  EXPECT_NE(refusal(place, true).find("empty/"), std::string::npos) << "made by someone else";
  fs::remove(place / "empty");
  Folder folder(place, true);
  folder.write("summary.json", our_summary);
  folder.commit();
  EXPECT_FALSE(fs::exists(place / "figures"));
}

TEST_F(FolderTest, a_campaigns_runs_are_theirs_by_name) {
  const fs::path place = scratch() / "campaign";
  fs::create_directory(place);
  list_files(place, {"campaign.lock", "campaign.sqlite"});
  write_text_of(place / "campaign.lock", "");
  write_text_of(place / "campaign.sqlite", "SQLite format 3");
  write_text_of(place / "campaign.sqlite-wal", "");
  write_text_of(place / "runs/0012-0123abcd.checkpoint", "");
  write_text_of(place / "runs/0012-0123abcd.checkpoint.part", "");
  write_text_of(place / "runs/.0012-0123abcd.partial-77/summary.json", "");
  write_text_of(place / "runs/0013-0123abcd/summary.json", our_summary);
  EXPECT_EQ(refusal(place, true), "");
  for (const char* name : {"runs/mine.checkpoint", "runs/0012-0123abcX.checkpoint",
                           "runs/0013-0123abcd/notes.txt", "runs/.mine.part"}) {
    write_text_of(place / name, "mine");
    EXPECT_NE(refusal(place, true).find(name), std::string::npos) << name;
    fs::remove(place / name);
  }
}

TEST_F(FolderTest, of_an_earlier_versions_campaign_names_are_taken_strictly) {
  const fs::path place = scratch() / "campaign";
  write_text_of(place / "campaign.csv", "point,mill.speed_rpm,collision_rate_per_s\n");
  write_text_of(place / "campaign.slurm", "#!/bin/bash\n");
  for (const char* name : {"campaign.shard-2-of-8.sqlite", "campaign.shard-2-of-8.lock",
                           "slurm-17_2.out", "slurm-18.out"})
    write_text_of(place / name, "");
  write_text_of(place / "figures" / "power.svg", our_picture);
  EXPECT_EQ(refusal(place, true), "");
  for (const char* name : {"campaign.shard-notes.txt", "campaign.shard-2-of-8.pdf",
                           "slurm-mine.out", "figures/drawn.svg"}) {
    write_text_of(place / name, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"3\"/>");
    EXPECT_NE(refusal(place, true).find(name), std::string::npos) << name;
    fs::remove(place / name);
  }
  fs::remove(place / "campaign.slurm");
  EXPECT_NE(refusal(place, true).find("slurm-17_2.out"), std::string::npos)
      << "of a job that is not ours";
}

TEST_F(FolderTest, two_into_one_place_are_refused) {
  const fs::path place = scratch() / "result";
  {
    const Folder first(place, false);
    EXPECT_NE(refusal(place, false).find("result-at-work"), std::string::npos);
    EXPECT_NE(refusal(place, true).find("another process"), std::string::npos);
    EXPECT_EQ(refusal(scratch() / "other", false), "");
  }
  EXPECT_EQ(refusal(place, false), "");
  EXPECT_EQ(entries(scratch()), 0U) << "no lock stays";
  write_text_of(place / "campaign.lock", "");
  const FileLock campaign(place / "campaign.lock", FileLock::Mode::shared);
  EXPECT_NE(refusal(place, true).find("result-at-work"), std::string::npos);
}

/// The number of a process that has ended.
::pid_t a_dead_process() {
  const ::pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  int status = 0;
  ::waitpid(child, &status, 0);
  return child;
}

TEST_F(FolderTest, what_a_killed_start_left_goes_and_what_a_living_one_has_stays) {
  const std::string dead = std::to_string(a_dead_process()), alive = std::to_string(::getppid());
  const fs::path left = scratch() / (".result.partial-" + dead),
                 living = scratch() / (".result.partial-" + alive),
                 other = scratch() / (".results.partial-" + dead),
                 whole = scratch() / (".result.partial-" + dead + "-");
  for (const fs::path& one : {left, living, other, whole})
    write_text_of(one / "summary.json", our_summary);
  list_all_files(whole);
  write_text_of(scratch() / ".result.lock", "");
  {
    const Folder folder(scratch() / "result", false);
    EXPECT_FALSE(fs::exists(left));
    for (const fs::path& one : {living, other, whole}) EXPECT_TRUE(fs::exists(one)) << one;
  }
  EXPECT_FALSE(fs::exists(scratch() / ".result.lock"));
}

TEST_F(FolderTest, a_comparison_and_numbered_files_may_be_replaced) {
  const fs::path place = scratch() / "compared";
  write_text_of(place / "compare.csv", "quantity,unit,event,event_ci95,soft,soft_ci95\n");
  write_text_of(place / "compare.html", "<html>");
  write_text_of(place / "soft" / "summary.json", our_summary);
  write_text_of(place / "soft" / "frames-12.xyz", "0\n\n");
  write_text_of(place / "soft" / "frames-12.pvd", "<?xml");
  write_text_of(place / "soft" / "frames-12" / "balls-00000.vtp", "<?xml");
  write_text_of(place / "soft" / "frames-12" / "jar-100000.vtp", "<?xml");
  write_text_of(place / "soft" / "stopped-1.csv", "ball\n");
  EXPECT_EQ(refusal(place, true), "");
  for (const char* name : {"frames-.xyz", "frames-best.xyz", "stopped-1.csv.txt",
                           "frames-12/mine.vtp", "frames-best/jar-00000.vtp"}) {
    write_text_of(place / "soft" / name, "mine");
    EXPECT_NE(refusal(place, true).find(name), std::string::npos) << name;
    fs::remove(place / "soft" / name);
  }
}

TEST_F(FolderTest, what_comes_in_during_the_run_is_not_overwritten) {
  const fs::path place = scratch() / "result";
  std::optional<Folder> folder;
  folder.emplace(place, false);
  folder->write("summary.json", "ours");
  write_text_of(place / "summary.json", our_summary);  // another run was faster
  std::string said;
  try {
    folder->commit();
  } catch (const InputError& e) {
    said = e.what();
  }
  EXPECT_EQ(read(place / "summary.json"), our_summary);
  const std::size_t at = said.find(".result.complete-");
  ASSERT_NE(at, std::string::npos) << said;  // the result is kept, and the message says where
  const std::string kept = said.substr(at, said.find(';', at) - at);
  EXPECT_EQ(read(scratch() / kept / "summary.json"), "ours");
  folder.reset();
  EXPECT_EQ(refusal(place, true), "");
  EXPECT_TRUE(fs::exists(scratch() / kept)) << "the next start keeps it";
}

TEST_F(FolderTest, a_place_that_cannot_be_written_is_an_error_before_the_run) {
  write_text_of(scratch() / "file", "text");
  EXPECT_NE(refusal(scratch() / "file", true).find("is a file"), std::string::npos);
  EXPECT_NE(refusal(scratch() / "file" / "result", false).find("cannot-write"), std::string::npos);
  EXPECT_NE(refusal("/proc/result", false).find("cannot-write"), std::string::npos);
  EXPECT_NE(refusal("", false).find("cannot-write"), std::string::npos);
  EXPECT_EQ(read(scratch() / "file"), "text");
}

TEST_F(FolderTest, a_full_disk_is_an_error) {
  try {
    write_text("/dev/full", "text");
    FAIL() << "a full disk took the text";
  } catch (const InputError& e) {
    EXPECT_EQ(e.faults().front().where, "/dev/full");
    EXPECT_NE(std::string(e.what()).find("No space left"), std::string::npos);
  }
}

/// During its lifetime no file of this process can grow beyond a size, as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(FolderTest, a_file_that_cannot_grow_leaves_nothing_half_written) {
  {
    Folder folder(scratch() / "result", false);
    const SmallDisk disk(4096);
    EXPECT_THROW(folder.write("spectrum.csv", std::string(10000, 'x')), InputError);
  }
  EXPECT_EQ(entries(scratch()), 0U);
}

TEST_F(FolderTest, collisions_that_do_not_fit_are_an_error) {
  Folder folder(scratch() / "result", false);
  const SmallDisk disk(16384);
  const auto fill = [&] {
    CollisionFile file(folder.file("collisions.h5"), "", "");
    std::vector<scene::Collision> records = fake_collisions(50000);
    for (std::size_t i = 0; i < records.size(); ++i)  // compresses badly
      records[i].slip = std::sin(1e6 * static_cast<double>(i));
    CollisionLog(file, 0).collisions(records);
    file.close();
  };
  EXPECT_THROW(fill(), InputError);
}

TEST_F(FolderTest, a_result_file_that_does_not_fit_is_an_error) {
  Table noise{{{"a", "1", "does not pack well"}}, {}};
  for (int i = 0; i < 10000; ++i) noise.rows.push_back({std::sin(1e6 * i)});
  const auto write = [&] {
    write_result_file(scratch() / "result.h5", {{"noise", "", noise}}, {}, {}, "", "");
  };
  EXPECT_NO_THROW(write());
  const SmallDisk disk(16384);
  EXPECT_THROW(write(), InputError);
}

}  // namespace
}  // namespace mahlwerk::results::folder_test
