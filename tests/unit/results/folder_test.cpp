// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/folder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <iterator>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/hdf5.hpp"
#include "mahlwerk/results/result_file.hpp"
#include "unit/results/fake.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::results {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view our_summary =
    "{\n  \"_about\": {\n    \"mahlwerk\": \"0.1.0\"\n  }\n}\n";

/// The code and text of the error that making the folder gives, or nothing.
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

TEST_F(FolderTest, AppearsOnlyWhenComplete) {
  const fs::path place = scratch() / "deep" / "result";
  Folder folder(place, false);
  folder.write("summary.json", our_summary);
  folder.write("point-1/spectrum.csv", "a,b\n");
  EXPECT_FALSE(fs::exists(place));
  folder.commit();
  EXPECT_EQ(read(place / "summary.json"), our_summary);
  EXPECT_EQ(read(place / "point-1" / "spectrum.csv"), "a,b\n");
  EXPECT_EQ(entries(place.parent_path()), 1U);  // nothing is left beside it
}

TEST_F(FolderTest, LeavesNothingBehindWhenGivenUp) {
  {
    Folder folder(scratch() / "result", false);
    folder.write("summary.json", our_summary);
    EXPECT_EQ(entries(scratch()), 1U);
  }
  EXPECT_EQ(entries(scratch()), 0U);
}

TEST_F(FolderTest, AnEmptyFolderIsFilled) {
  fs::create_directory(scratch() / "result");
  Folder folder(scratch() / "result", false);
  folder.write("summary.json", our_summary);
  folder.commit();
  EXPECT_TRUE(fs::exists(scratch() / "result" / "summary.json"));
}

TEST_F(FolderTest, RefusesAnExistingResultUnlessForced) {
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

TEST_F(FolderTest, NeverTouchesWhatIsNotOurs) {
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

TEST_F(FolderTest, ACampaignsPointsMayBeReplaced) {
  const fs::path place = scratch() / "campaign";
  write_text_of(place / "campaign.csv", "point,mill.speed_rpm,collision_rate_per_s\n");
  write_text_of(place / "point-001" / "summary.json", our_summary);
  write_text_of(place / "figures" / "collision_rate.svg", "<svg/>");
  EXPECT_EQ(refusal(place, true), "");
  write_text_of(place / "point-001" / "notes.txt", "mine");
  EXPECT_NE(refusal(place, true).find("point-001/notes.txt"), std::string::npos);
}

TEST_F(FolderTest, AComparisonAndNumberedFilesMayBeReplaced) {
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

TEST_F(FolderTest, WhatComesInDuringTheRunIsNotOverwritten) {
  const fs::path place = scratch() / "result";
  Folder folder(place, false);
  folder.write("summary.json", "ours");
  write_text_of(place / "summary.json", our_summary);  // another run was faster
  std::string said;
  try {
    folder.commit();
  } catch (const InputError& e) {
    said = e.what();
  }
  EXPECT_EQ(read(place / "summary.json"), our_summary);
  const std::size_t at = said.find(".result.partial-");
  ASSERT_NE(at, std::string::npos) << said;  // the hours of work are kept, and it says where
  EXPECT_EQ(entries(scratch()), 2U);
}

TEST_F(FolderTest, APlaceThatCannotBeWrittenIsAnErrorBeforeTheRun) {
  write_text_of(scratch() / "file", "text");
  EXPECT_NE(refusal(scratch() / "file", true).find("is a file"), std::string::npos);
  EXPECT_NE(refusal(scratch() / "file" / "result", false).find("cannot-write"), std::string::npos);
  EXPECT_NE(refusal("/proc/result", false).find("cannot-write"), std::string::npos);
  EXPECT_NE(refusal("", false).find("cannot-write"), std::string::npos);
  EXPECT_EQ(read(scratch() / "file"), "text");
}

TEST_F(FolderTest, AFullDiskIsAnError) {
  try {
    write_text("/dev/full", "text");
    FAIL() << "a full disk took the text";
  } catch (const InputError& e) {
    EXPECT_EQ(e.faults().front().where, "/dev/full");
    EXPECT_NE(std::string(e.what()).find("No space left"), std::string::npos);
  }
}

/// While it lives, no file of this process may grow beyond a size: as on a full disk.
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

TEST_F(FolderTest, AFileThatCannotGrowLeavesNothingHalfWritten) {
  {
    Folder folder(scratch() / "result", false);
    const SmallDisk disk(4096);
    EXPECT_THROW(folder.write("spectrum.csv", std::string(10000, 'x')), InputError);
  }
  EXPECT_EQ(entries(scratch()), 0U);
}

TEST_F(FolderTest, CollisionsThatDoNotFitAreAnError) {
  Folder folder(scratch() / "result", false);
  const SmallDisk disk(16384);
  const auto fill = [&] {
    CollisionFile file(folder.file("collisions.h5"), "", "");
    std::vector<scene::Collision> records = fake_collisions(50000);
    for (std::size_t i = 0; i < records.size(); ++i)  // does not pack well
      records[i].slip = std::sin(1e6 * static_cast<double>(i));
    CollisionLog(file, 0).collisions(records);
    file.close();
  };
  EXPECT_THROW(fill(), InputError);
}

TEST_F(FolderTest, AResultFileThatDoesNotFitIsAnError) {
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
}  // namespace mahlwerk::results
