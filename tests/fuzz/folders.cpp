// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The folder of a result and of a run by LAMMPS. An input holds several files, each after a line
// "== NAME".
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/lammps/output_files.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/files/ownership.hpp"
#include "targets.hpp"

namespace mahlwerk::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::array names{
    "mahlwerk-files.txt", "summary.json",   "campaign.csv",
    "compare.csv",        "final-1.csv",    "final-2.csv",
    "from.0.txt",         "from.1.txt",     "balance.0.txt",
    "balance.1.txt",      "balls.0.txt",    "balls.1.txt",
    "contacts.0.txt",     "contacts.1.txt", "wall.0.txt",
    "claims.csv",         "figures/a.svg",  "runs/0001-0123abcd/summary.json"};

void unpack(const std::string& bytes, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder / "figures");
  fs::create_directories(folder / "runs/0001-0123abcd");
  std::istringstream stream(bytes);
  std::string name, text;
  const auto write = [&] {
    if (std::ranges::find(names, name) != names.end()) write_file(folder / name, text);
    text.clear();
  };
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("== ")) {
      write();
      name = line.substr(3);
    } else {
      text += line + '\n';
    }
  write();
}

void read_lammps(const fs::path& folder) {
  using lammps::OutputFile;
  const std::vector<lammps::Session> sessions = lammps::sessions(folder);
  struct File {
    const char* name;
    OutputFile::Kind kind;
    std::size_t columns;
  };
  for (const File& file :
       {File{"balance", OutputFile::Kind::table, lammps::balance_columns},
        File{"contacts", OutputFile::Kind::dump, 8}, File{"balls", OutputFile::Kind::dump, 10}}) {
    OutputFile output(folder, file.name, file.kind, file.columns);
    while (output.next(sessions) != nullptr) {
    }
  }
}

void read_folder(const std::string& bytes) {
  const fs::path folder = scratch() / "folder";
  unpack(bytes, folder);
  results::listed_files(folder);
  results::is_result(folder);
  results::foreign_files(folder);
  read_lammps(folder);
  if (fs::exists(folder / "final-1.csv"))
    cases::read_text(small_case("soft"), scratch() / "case.toml", catalogue(),
                     {{"run.start_from", "folder"}});
}

std::vector<std::string> folders() {
  const fs::path folder = scratch() / "seed";
  fs::create_directories(folder);
  write_file(folder / "summary.json", "{\"_about\": {\"mahlwerk\": \"0.1.0\"}}\n");
  results::list_all_files(folder);
  std::string state =
      "kind,radius_m,x_m,y_m,z_m,velocity_x_m_per_s,velocity_y_m_per_s,velocity_z_m_per_s,"
      "spin_x_rad_per_s,spin_y_rad_per_s,spin_z_rad_per_s\n";
  for (const double z : {-5e-3, 0.0, 5e-3})
    state += fmt::format("1,0.0025,0,0,{},0,0,0,0,0,0\n", z);
  const auto snapshot = [](int step, const char* row) {
    return fmt::format(
        "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 "
        "1\n"
        "ITEM: ATOMS id x y z\n{}\n",
        step, row);
  };
  const std::string balls = "1 0 0 0 0 0 0 0 0 0";
  return {"== summary.json\n" + contents(folder / "summary.json") + "== mahlwerk-files.txt\n" +
              contents(folder / "mahlwerk-files.txt"),
          "== final-1.csv\n" + state,
          "== from.0.txt\n0\n== balance.0.txt\n# step\n0 1 2 3 4 5 6 7 8 9 10\n"
          "100 1 2 3 4 5 6 7 8 9 10\n== balls.0.txt\n" +
              snapshot(0, balls.c_str()) + snapshot(100, balls.c_str()) +
              "== from.1.txt\n50\n== contacts.0.txt\n" + snapshot(100, "1 2 0.1 0.2 0.3 0 0 0"),
          "== runs/0001-0123abcd/summary.json\n{}\n== figures/a.svg\n<svg>\n"};
}

}  // namespace

Target folder_target() {
  return {"folder", read_folder, folders};
}

}  // namespace mahlwerk::fuzz
