// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/catalogue.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/catalogue_read.hpp"

namespace mahlwerk::cases {
namespace {

namespace fs = std::filesystem;

/// What one thing in a room is called in a message.
std::string_view thing(std::string_view room) {
  if (room == "mills") return "mill";
  if (room == "jars") return "jar";
  return room == "media" ? "ball set" : "material";
}

/// Letters to insert, drop, change or swap with their neighbour to get from `a` to `b`.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// The names near a word, best first: few edits away, or holding the word as a part.
std::vector<std::string> near_names(std::string_view word, const std::vector<std::string>& known) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  const std::size_t most = std::max<std::size_t>(1, word.size() / 3);
  for (const std::string& name : known) {
    const std::size_t n = edits(word, name);
    const bool part = word.size() >= 3 && name.find(word) != std::string::npos;
    if (n <= most) ranked.emplace_back(n, name);
    else if (part) ranked.emplace_back(most + n, name);
  }
  std::ranges::sort(ranked);
  std::vector<std::string> names;
  for (auto& [n, name] : ranked) names.push_back(std::move(name));
  return names;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream)
    throw InputError(Fault{file.string(), "the catalogue file cannot be read",
                           "check that it is a file and may be read", "bad-catalogue-file"});
  return text;
}

}  // namespace

Catalogue::Catalogue(fs::path root) : root_(std::move(root)) {
  const auto is_there = [&](std::string_view room) {
    std::error_code ignored;
    return fs::is_directory(root_ / room, ignored);
  };
  if (std::ranges::none_of(rooms, is_there))
    throw InputError(Fault{root_.string(), "there is no catalogue here",
                           "give the folder that holds mills, jars, materials and media",
                           "no-catalogue"});
}

std::vector<std::string> Catalogue::names(std::string_view room) const {
  if (std::ranges::find(rooms, room) == std::end(rooms))
    throw InputError(Fault{"", fmt::format("the catalogue has no room called '{}'", room),
                           fmt::format("one of: {}", fmt::join(rooms, ", ")), "unknown-name"});
  std::vector<std::string> found;
  std::error_code missing;  // an empty room may have no folder
  for (const fs::directory_entry& file : fs::directory_iterator(root_ / room, missing))
    if (file.path().extension() == ".toml" && file.is_regular_file()) found.push_back(file.path().stem().string());
  std::ranges::sort(found);
  return found;
}

CatalogueEntry Catalogue::find(std::string_view room, std::string_view name,
                               std::string_view where) const {
  const std::vector<std::string> known = names(room);
  if (!std::ranges::binary_search(known, name)) {  // so "../x" never reaches the file system
    std::vector<std::string> near = near_names(name, known);
    if (near.size() > 4) near.resize(4);
    throw InputError(
        Fault{std::string(where), fmt::format("the catalogue has no {} called '{}'", thing(room), name),
              (near.empty() ? "" : fmt::format("did you mean '{}'? ", fmt::join(near, "' or '"))) +
                  fmt::format("`mahlwerk list {}` shows them all", room),
              "unknown-name"});
  }
  const fs::path file = root_ / room / (std::string(name) + ".toml");
  return read_entry(contents(file), room, name, file.string());
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string> near = near_names(word, known);
  return near.empty() ? "" : near.front();
}

}  // namespace mahlwerk::cases
