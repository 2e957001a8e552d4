// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/cases/catalogue/catalogue_read.hpp"

namespace mahlwerk::cases {
namespace {

namespace fs = std::filesystem;

/// Noun for one entry of a category, for messages.
std::string_view category_noun(std::string_view category) {
  if (category == "mills") return "mill";
  if (category == "jars") return "jar";
  return category == "media" ? "ball set" : "material";
}

/// "Fritsch P7" as {"fritsch", "p7"}.
std::vector<std::string> words_of(std::string_view word) {
  std::vector<std::string> parts;
  bool inside = false;
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0) {
      if (!inside) parts.emplace_back();
      parts.back() += static_cast<char>(std::tolower(byte));
    }
    inside = std::isalnum(byte) != 0;
  }
  return parts;
}

/// "Fritsch P-7" as "fritschp7", for comparisons.
std::string letters_and_digits(std::string_view word) {
  return joined(words_of(word), "");
}

/// Suggestions for an unknown name, likeliest first: the nearest by spelling, and names that
/// contain all its parts.
std::vector<std::string> similar_names(std::string_view word,
                                       const std::vector<std::string>& known) {
  constexpr std::size_t shortest = 3, most = 4;
  std::vector<std::string> near;
  if (const std::string best = nearest_word(word, known); !best.empty()) near.push_back(best);
  const std::vector<std::string> parts = words_of(word);
  for (const std::string& name : known) {
    const bool holds_all = word.size() >= shortest && !parts.empty() &&
                           std::ranges::all_of(parts, [&](const std::string& part) {
                             return name.find(part) != std::string::npos;
                           });
    if (holds_all && near.size() < most && std::ranges::find(near, name) == near.end())
      near.push_back(name);
  }
  return near;
}

/// Names that share the most parts with an unknown name that is near none: for "steel-440c" the
/// steels.
std::vector<std::string> related_names(std::string_view word,
                                       const std::vector<std::string>& known) {
  constexpr std::size_t shortest = 3, most = 6;
  const std::vector<std::string> parts = words_of(word);
  std::vector<std::string> related;
  std::ptrdiff_t shared = 1;
  for (const std::string& name : known) {
    const auto count = std::ranges::count_if(parts, [&](const std::string& part) {
      return part.size() >= shortest && name.find(part) != std::string::npos;
    });
    if (count > shared) related.clear();
    if (count >= shared) related.push_back(name);
    shared = std::max(shared, count);
  }
  if (related.size() > most) related.resize(most);
  return related;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream)
    throw InputError(Fault{file.string(), "the catalogue file cannot be read",
                           "check that it is a file and its permissions", "bad-catalogue-file"});
  return text;
}

}  // namespace

Catalogue::Catalogue(fs::path root) : root_(std::move(root)) {
  const auto is_there = [&](std::string_view category) {
    std::error_code ignored;
    return fs::is_directory(root_ / category, ignored);
  };
  if (std::ranges::none_of(categories, is_there))
    throw InputError(Fault{root_.string(), "there is no catalogue here",
                           "give the folder that holds mills, jars, materials and media",
                           "no-catalogue"});
}

std::vector<std::string> Catalogue::names(std::string_view category) const {
  if (std::ranges::find(categories, category) == std::end(categories))
    throw InputError(Fault{
        "", fmt::format("the catalogue has no category '{}'", category),
        fmt::format("one of: {}", joined({std::begin(categories), std::end(categories)}, ", ")),
        "unknown-name"});
  std::vector<std::string> found;
  std::error_code missing;  // an empty category may have no folder
  for (const fs::directory_entry& file : fs::directory_iterator(root_ / category, missing))
    if (file.path().extension() == ".toml" && file.is_regular_file())
      found.push_back(file.path().stem().string());
  std::ranges::sort(found);
  return found;
}

bool Catalogue::has(std::string_view category, std::string_view name) const {
  std::error_code missing;
  return name.find_first_of("/\\") == std::string_view::npos &&  // refuses "../x"
         fs::is_regular_file(root_ / category / (std::string(name) + ".toml"), missing);
}

std::vector<std::string> Catalogue::entries_called(std::string_view category,
                                                   std::string_view word) const {
  if (has(category, word)) return {std::string(word)};
  const std::string wanted = letters_and_digits(word);
  std::vector<std::string> found;
  const bool path = word.starts_with('.') || word.starts_with('/');
  if (wanted.empty() || path) return found;
  for (const std::string& name : names(category)) {
    const fs::path file = root_ / category / (name + ".toml");
    const CatalogueEntry entry = read_entry(contents(file), category, name, file.string());
    const auto same = [&](const std::string& other) { return letters_and_digits(other) == wanted; };
    if (same(name) || same(entry.title) || std::ranges::any_of(entry.names, same))
      found.push_back(name);
  }
  return found;
}

CatalogueEntry Catalogue::find(std::string_view category, std::string_view name,
                               std::string_view where) const {
  const std::vector<std::string> called = entries_called(category, name);
  if (called.size() > 1)
    throw InputError(Fault{std::string(where),
                           fmt::format("'{}' may be any of '{}'", name, joined(called, "', '")),
                           "write one of these names", "ambiguous-name"});
  if (called.empty()) {
    const std::vector<std::string> known = names(category);
    std::vector<std::string> near = similar_names(name, known);
    if (near.empty()) near = related_names(name, known);
    throw InputError(
        Fault{std::string(where),
              fmt::format("the catalogue has no {} called '{}'", category_noun(category), name),
              (near.empty() ? "" : fmt::format("did you mean '{}'? ", joined(near, "' or '"))) +
                  fmt::format("`mahlwerk list {}` shows them all", category),
              "unknown-name"});
  }
  const fs::path file = root_ / category / (called.front() + ".toml");
  return read_entry(contents(file), category, called.front(), file.string());
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string> near = similar_names(word, known);
  return near.empty() ? "" : near.front();
}

}  // namespace mahlwerk::cases
