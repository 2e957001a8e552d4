// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/ownership.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <string_view>

#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/manifest.hpp"

namespace mahlwerk::results {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// Every file that a result or a campaign of an earlier version may hold.
constexpr std::array our_files{std::string_view("summary.json"),
                               std::string_view("result.h5"),
                               std::string_view("case.resolved.toml"),
                               std::string_view("spectrum.csv"),
                               std::string_view("collisions_by_pair.csv"),
                               std::string_view("spectra_by_pair.csv"),
                               std::string_view("normal_tangential.csv"),
                               std::string_view("durations.csv"),
                               std::string_view("flashes.csv"),
                               std::string_view("wall_map.csv"),
                               std::string_view("part_map.csv"),
                               std::string_view("fields.csv"),
                               std::string_view("bed.csv"),
                               std::string_view("wear.csv"),
                               std::string_view("wear_evolution.csv"),
                               std::string_view("wear_evolution.html"),
                               std::string_view("wear_evolution.json"),
                               std::string_view("wear_evolution.state"),
                               std::string_view("wear_profile.csv"),
                               std::string_view("wear_ball_sizes.csv"),
                               std::string_view("wear_spectra.csv"),
                               std::string_view("temperature.csv"),
                               std::string_view("capture.csv"),
                               std::string_view("captured_grains.csv"),
                               std::string_view("grinding.csv"),
                               std::string_view("size_distribution.csv"),
                               std::string_view("conversion.csv"),
                               std::string_view("sizes.csv"),
                               std::string_view("speeds.csv"),
                               std::string_view("angles.csv"),
                               std::string_view("timeseries.csv"),
                               std::string_view("replicates.csv"),
                               std::string_view("collisions.h5"),
                               std::string_view("report.html"),
                               std::string_view("campaign.csv"),
                               std::string_view("campaign.json"),
                               std::string_view("campaign.html"),
                               std::string_view("campaign.sqlite"),
                               std::string_view("campaign.sqlite-wal"),
                               std::string_view("campaign.sqlite-shm"),
                               std::string_view("campaign.sqlite-journal"),
                               std::string_view("campaign.lock"),
                               std::string_view("campaign.slurm"),
                               std::string_view("optimise.json"),
                               std::string_view("optimise.html"),
                               std::string_view("match.json"),
                               std::string_view("match.html"),
                               std::string_view("settings.csv"),
                               std::string_view("best.toml"),
                               std::string_view("compare.json"),
                               std::string_view("compare.csv"),
                               std::string_view("compare.html"),
                               std::string_view("fit.json"),
                               std::string_view("fit.csv"),
                               std::string_view("fit.html"),
                               std::string_view("fitted.toml"),
                               std::string_view("paper.html"),
                               std::string_view("paper.json"),
                               std::string_view("claims.csv"),
                               std::string_view("claims.md"),
                               std::string_view("ro-crate-metadata.json"),
                               std::string_view("jar.stl"),
                               std::string_view("motion.csv")};

constexpr std::string_view digits = "0123456789", hex_digits = "0123456789abcdef";

/// The part of the name between `before` and `behind`; empty if the name lacks one of them.
std::string_view between(std::string_view name, std::string_view before, std::string_view behind) {
  if (name.size() <= before.size() + behind.size() || !name.starts_with(before) ||
      !name.ends_with(behind))
    return "";
  return name.substr(before.size(), name.size() - before.size() - behind.size());
}

bool is_of(std::string_view letters, std::string_view text) {
  return !text.empty() && text.find_first_not_of(letters) == std::string_view::npos;
}

/// Whether the name is `before`, a number and `behind`.
bool is_numbered(std::string_view name, std::string_view before, std::string_view behind) {
  return is_of(digits, between(name, before, behind));
}

/// Whether the text is two numbers with `mark` between them: "2-of-8", "17_2".
bool are_numbers(std::string_view text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  return at != std::string_view::npos && is_of(digits, text.substr(0, at)) &&
         is_of(digits, text.substr(at + mark.size()));
}

/// Whether the name is that of a file of a part in the jar: "part-stirrer.stl".
bool is_of_part(std::string_view name) {
  return !between(name, "part-", ".stl").empty() || !between(name, "part-", ".csv").empty();
}

/// Whether the name is that of a shard, as "campaign.shard-2-of-8.sqlite", its journal or lock.
bool is_of_shard(std::string_view name) {
  constexpr std::array endings{".sqlite", ".sqlite-journal", ".lock"};
  return std::ranges::any_of(endings, [&](std::string_view ending) {
    return are_numbers(between(name, "campaign.shard-", ending), "-of-");
  });
}

/// Whether the name is that of a job's output, as "slurm-17_2.out", beside a script of Mahlwerk.
bool is_of_slurm(const fs::path& folder, std::string_view name) {
  return (are_numbers(between(name, "slurm-", ".out"), "_") ||
          is_numbered(name, "slurm-", ".out")) &&
         fs::exists(folder / "campaign.slurm");
}

bool is_our_name(const fs::path& folder, std::string_view name) {
  return std::ranges::find(our_files, name) != our_files.end() ||
         is_numbered(name, "frames-", ".xyz") || is_numbered(name, "frames-", ".pvd") ||
         is_numbered(name, "stopped-", ".csv") || is_numbered(name, "final-", ".csv") ||
         is_of_part(name) || is_of_shard(name) || is_of_slurm(folder, name);
}

std::string beginning(const fs::path& file) {
  std::string text(4096, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

/// Whether the file begins as pictures of Mahlwerk do.
bool is_our_picture(const fs::path& file) {
  if (file.extension() != ".svg") return false;
  const std::string text = beginning(file);
  return text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ") &&
         text.find("\" role=\"img\" aria-label=\"") < 100;
}

/// Whether a folder inside a result may hold the entry: a picture or a frame.
bool is_our_inner_name(std::string_view folder, const fs::directory_entry& entry) {
  if (!entry.is_regular_file() || entry.is_symlink()) return false;
  const std::string name = entry.path().filename().string();
  if (folder == "figures") return is_our_picture(entry.path());
  return is_numbered(folder, "frames-", "") &&
         (is_numbered(name, "balls-", ".vtp") || is_numbered(name, "jar-", ".vtp"));
}

/// Whether the name is that of a campaign's run, as "0012-0123abcd".
bool is_run(std::string_view name) {
  constexpr std::size_t of_hash = 8;
  if (name.size() < of_hash + 2) return false;
  const std::size_t mark = name.size() - of_hash - 1;
  return name[mark] == '-' && is_of(digits, name.substr(0, mark)) &&
         is_of(hex_digits, name.substr(mark + 1));
}

/// Whether the name is of a file beside the folder of an unfinished run: its checkpoint, its lock
/// or its partial result.
bool is_beside_run(std::string_view name) {
  if (!name.starts_with('.')) return is_run(name.substr(0, name.find(".checkpoint")));
  return is_run(name.substr(1, name.find('.', 1) - 1));
}

/// Foreign files in the folder of a campaign's runs.
Names foreign_runs(const fs::path& runs) {
  Names names;
  for (const fs::directory_entry& entry : fs::directory_iterator(runs)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_symlink() || !(is_run(name) ? entry.is_directory() : is_beside_run(name)))
      names.push_back(name);
    else if (is_run(name))
      for (const std::string& inner : foreign_files(entry.path()))
        names.push_back(name + "/" + inner);
  }
  return names;
}

/// Foreign files in a folder without a list inside a result: a campaign's point, pictures, frames.
Names foreign_inside(const fs::path& inner) {
  const std::string folder = inner.filename().string();
  if (folder == campaign_runs) return foreign_runs(inner);
  if (is_result(inner)) return foreign_files(inner);
  Names names;
  for (const fs::directory_entry& entry : fs::directory_iterator(inner))
    if (!is_our_inner_name(folder, entry)) names.push_back(entry.path().filename().string());
  return names;
}

Names foreign_by_name(const fs::path& folder) {
  Names names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_symlink())
      names.push_back(name);
    else if (entry.is_directory())
      for (const std::string& inner : foreign_inside(entry.path()))
        names.push_back(name + "/" + inner);
    else if (!is_our_name(folder, name))
      names.push_back(name);
  }
  return names;
}

/// Whether the file is listed, or is a temporary file beside a listed one.
bool is_listed(const std::set<std::string>& listed, const std::string& name) {
  constexpr std::array endings{".part", "-wal", "-shm", "-journal"};
  return listed.contains(name) || std::ranges::any_of(endings, [&](std::string_view ending) {
           return name.ends_with(ending) &&
                  listed.contains(name.substr(0, name.size() - ending.size()));
         });
}

/// Adds the files that are not in the list. `below`: path of the folder relative to the list's
/// folder, with a slash at its end, or empty.
void add_unlisted(const fs::path& folder, const std::string& below,
                  const std::set<std::string>& listed, Names& names) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = below + entry.path().filename().string(), inside = name + "/";
    if (entry.is_symlink() || !entry.is_directory()) {
      if (entry.is_symlink() || !is_listed(listed, name)) names.push_back(name);
      continue;
    }
    const auto first = listed.lower_bound(inside);
    if (name == campaign_runs)
      for (const std::string& one : foreign_runs(entry.path())) names.push_back(inside + one);
    else if (first != listed.end() && first->starts_with(inside))
      add_unlisted(entry.path(), inside, listed, names);
    else
      names.push_back(inside);
  }
}

}  // namespace

bool is_result(const fs::path& folder) {
  const auto begins = [&](const char* file, std::string_view text) {
    return beginning(folder / file).starts_with(text);
  };
  const auto holds = [&](const char* file, std::string_view text) {
    return beginning(folder / file).find(text) != std::string::npos;
  };
  return listed_files(folder) || holds("summary.json", "\"mahlwerk\"") ||
         holds("campaign.csv", "collision_rate_per_s") ||
         begins("campaign.sqlite", "SQLite format 3") ||
         fs::exists(folder / "campaign.lock") ||  // a campaign that was killed as it began
         fs::exists(folder / "wear_evolution.state") || holds("optimise.json", "\"mahlwerk\"") ||
         holds("match.json", "\"mahlwerk\"") ||
         begins("compare.csv", "quantity,unit,event,event_ci95,soft") ||
         begins("fit.csv", "line,condition,what,unit,time_s,size_m") ||
         begins("claims.csv", "figure,the_paper_says,we_find,holds,why");
}

std::vector<std::string> foreign_files(const fs::path& folder) {
  Names names;
  if (const auto listed = listed_files(folder))
    add_unlisted(folder, "", *listed, names);
  else
    names = foreign_by_name(folder);
  std::ranges::sort(names);
  return names;
}

void list_campaign_files(const fs::path& folder) {
  if (listed_files(folder)) return;
  Names names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string();
        entry.is_regular_file() && is_our_name(folder, name))
      names.push_back(name);
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder / "figures", none))
    if (is_our_inner_name("figures", entry))
      names.push_back("figures/" + entry.path().filename().string());
  list_files(folder, names);
}

}  // namespace mahlwerk::results
