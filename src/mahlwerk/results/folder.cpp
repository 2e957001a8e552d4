// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <system_error>
#include <vector>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::results {
namespace {

namespace fs = std::filesystem;

/// Every file that a result or a campaign may hold: --force removes these and nothing else.
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
                               std::string_view("fields.csv"),
                               std::string_view("wear.csv"),
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
                               std::string_view("compare.csv"),
                               std::string_view("compare.html"),
                               std::string_view("fit.json"),
                               std::string_view("fit.csv"),
                               std::string_view("fit.html"),
                               std::string_view("fitted.toml"),
                               std::string_view("paper.html"),
                               std::string_view("claims.csv"),
                               std::string_view("claims.md"),
                               std::string_view("jar.stl"),
                               std::string_view("motion.csv")};

/// A name with a number in it, by what stands before and behind that.
bool is_numbered(std::string_view name, std::string_view before, std::string_view behind) {
  if (name.size() <= before.size() + behind.size()) return false;
  const std::string_view number =
      name.substr(before.size(), name.size() - before.size() - behind.size());
  return name.starts_with(before) && name.ends_with(behind) &&
         number.find_first_not_of("0123456789") == std::string_view::npos;
}

/// "campaign.shard-2-of-8.sqlite", and its journal and lock; "slurm-17_2.out".
bool is_of_shard(std::string_view name) {
  return name.starts_with("campaign.shard-") ||
         (name.starts_with("slurm-") && name.ends_with(".out"));
}

/// Of some files there is one for a replicate.
bool is_our_name(std::string_view name) {
  return std::find(our_files.begin(), our_files.end(), name) != our_files.end() ||
         is_numbered(name, "frames-", ".xyz") || is_numbered(name, "frames-", ".pvd") ||
         is_numbered(name, "stopped-", ".csv") || is_of_shard(name);
}

/// What a folder inside a result may hold besides: pictures, or frames.
bool is_our_inner_name(std::string_view folder, const fs::directory_entry& entry) {
  if (!entry.is_regular_file() || entry.is_symlink()) return false;
  const std::string name = entry.path().filename().string();
  if (folder == "figures") return entry.path().extension() == ".svg";
  return is_numbered(folder, "frames-", "") &&
         (is_numbered(name, "balls-", ".vtp") || is_numbered(name, "jar-", ".vtp"));
}

InputError cannot_write(const fs::path& place, const std::string& why) {
  return InputError(
      Fault{place.string(), "cannot be written: " + why,
            "free some space or mend the permissions, or choose another folder with --out",
            "cannot-write"});
}

std::string beginning(const fs::path& file) {
  std::string text(4096, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

/// Ours is a folder with a summary, or a table of a campaign, a comparison, a fit or a paper's
/// claims, that begins as we write it.
bool is_result(const fs::path& folder) {
  return beginning(folder / "summary.json").find("\"mahlwerk\"") != std::string::npos ||
         beginning(folder / "campaign.csv").find("collision_rate_per_s") != std::string::npos ||
         beginning(folder / "campaign.sqlite").starts_with("SQLite format 3") ||
         fs::exists(folder / "campaign.lock") ||  // a campaign that was killed as it began
         beginning(folder / "optimise.json").find("\"mahlwerk\"") != std::string::npos ||
         beginning(folder / "match.json").find("\"mahlwerk\"") != std::string::npos ||
         beginning(folder / "compare.csv").starts_with("quantity,unit,event,event_ci95,soft") ||
         beginning(folder / "fit.csv").starts_with("line,condition,what,unit,time_s,size_m") ||
         beginning(folder / "claims.csv").starts_with("figure,the_paper_says,we_find,holds,why");
}

/// Names inside a folder that no result of ours has.
std::vector<std::string> foreign(const fs::path& folder);

/// The state of a campaign's run that goes on, beside its folder.
bool is_of_run(const fs::directory_entry& entry) {
  const fs::path kind = entry.path().extension();
  return entry.is_regular_file() && (kind == ".checkpoint" || kind == ".part");
}

/// The same of a folder inside a result: a point of a campaign, its pictures, or frames.
std::vector<std::string> foreign_inside(const fs::directory_entry& inner) {
  if (is_result(inner.path())) return foreign(inner.path());
  std::vector<std::string> names;
  if (inner.path().filename() == campaign_runs) {
    for (const fs::directory_entry& run : fs::directory_iterator(inner))
      if (is_of_run(run))
        continue;
      else if (!run.is_directory())
        names.push_back(run.path().filename().string());
      else
        for (const std::string& name : foreign(run.path()))
          names.push_back(run.path().filename().string() + "/" + name);
    return names;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(inner))
    if (!is_our_inner_name(inner.path().filename().string(), entry))
      names.push_back(entry.path().filename().string());
  return names;
}

std::vector<std::string> foreign(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_symlink()) {
      names.push_back(name);
    } else if (entry.is_directory()) {
      for (const std::string& inner : foreign_inside(entry)) names.push_back(name + "/" + inner);
    } else if (!is_our_name(name)) {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

void check_replaceable(const fs::path& wanted, bool force) {
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    throw InputError(Fault{wanted.string(), what, remedy, "result-exists"});
  };
  if (!fs::exists(fs::symlink_status(wanted))) return;
  if (!fs::is_directory(wanted))
    refuse("is a file, not a folder", "choose another folder with --out");
  if (fs::is_empty(wanted)) return;
  if (!is_result(wanted))
    refuse("is not empty, and what it holds is not a result of Mahlwerk, so it is left alone",
           "choose another folder with --out");
  if (!force)
    refuse("holds a result already",
           fs::exists(wanted.string() + ".checkpoint")
               ? "go on with the run that left it by --resume, replace it with --force, or choose "
                 "another folder with --out"
               : "choose another folder with --out, or replace it with --force");
  const std::vector<std::string> others = foreign(wanted);
  if (!others.empty())
    refuse(fmt::format(
               "holds, besides a result, what Mahlwerk did not write ({}{}), so it is left alone",
               others.front(), others.size() > 1 ? " and more" : ""),
           "move that away, or choose another folder with --out");
}

/// The folder as an absolute path without "..", links followed as far as the path exists.
fs::path resolved(const fs::path& wanted) {
  if (wanted.empty())
    throw InputError(
        Fault{"--out", "the name of the result folder is empty", "give a folder", "cannot-write"});
  fs::path path = fs::weakly_canonical(fs::absolute(wanted));
  if (!path.has_filename()) path = path.parent_path();
  return path;
}

fs::path beside(const fs::path& wanted, std::string_view what) {
  return wanted.parent_path() /
         fmt::format(".{}.{}-{}", wanted.filename().string(), what, ::getpid());
}

/// 0, or the number of the error that kept a byte from being written.
int written(const fs::path& file, std::string_view text) {
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (out == nullptr) return errno;
  int failed = 0;
  if (std::fwrite(text.data(), 1, text.size(), out) != text.size()) failed = errno;
  if (failed == 0 && std::fflush(out) != 0) failed = errno;
  if (std::fclose(out) != 0 && failed == 0) failed = errno;
  return failed;
}

}  // namespace

Folder::Folder(const fs::path& wanted, bool force) : force_(force) {
  try {
    wanted_ = resolved(wanted);
    check_replaceable(wanted_, force);
    fs::create_directories(wanted_.parent_path());
    aside_ = beside(wanted_, "partial");
    fs::remove_all(aside_);  // of a process of the same number that was killed
    fs::create_directory(aside_);
  } catch (const fs::filesystem_error& e) {
    throw cannot_write(wanted, e.code().message());
  }
}

Folder::~Folder() {
  std::error_code ignored;
  if (!done_) fs::remove_all(aside_, ignored);
}

fs::path Folder::file(std::string_view name) const {
  const fs::path path = aside_ / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw cannot_write(wanted_ / name, error.message());
  return path;
}

void Folder::write(std::string_view name, std::string_view text) const {
  if (const int failed = written(file(name), text); failed != 0)
    throw cannot_write(wanted_ / name, std::strerror(failed));
}

void Folder::commit() {
  done_ = true;  // from here on the result is kept, come what may: it may have taken hours
  try {
    put_in_place();
  } catch (const std::exception& e) {
    throw InputError(Fault{
        wanted_.string(), std::string("the result cannot be put in place: ") + e.what(),
        "it is complete in " + aside_.string() + "; move it where you want it", "cannot-write"});
  }
}

void Folder::put_in_place() const {
  check_replaceable(wanted_, force_);  // again: much may have happened during the run
  if (!fs::exists(wanted_) || fs::is_empty(wanted_)) return fs::rename(aside_, wanted_);
  const fs::path old = beside(wanted_, "replaced");
  std::error_code ignored;
  fs::rename(wanted_, old);
  try {
    fs::rename(aside_, wanted_);
  } catch (const fs::filesystem_error&) {
    fs::rename(old, wanted_, ignored);
    throw;
  }
  fs::remove_all(old, ignored);
}

void write_text(const fs::path& file, std::string_view text) {
  if (const int failed = written(file, text); failed != 0)
    throw cannot_write(file, std::strerror(failed));
}

}  // namespace mahlwerk::results
