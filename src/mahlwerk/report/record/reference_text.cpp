// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/reference_text.hpp"

#include <fmt/format.h>

#include <vector>

namespace mahlwerk::report {
namespace {

using Kind = Reference::Kind;

std::vector<std::string_view> people(std::string_view authors) {
  constexpr std::string_view between = " and ";
  std::vector<std::string_view> list;
  for (std::size_t at = authors.find(between); at != std::string_view::npos;
       at = authors.find(between)) {
    list.push_back(authors.substr(0, at));
    authors.remove_prefix(at + between.size());
  }
  list.push_back(authors);
  return list;
}

/// "Luding, S." as "S. Luding"; "{The Mahlwerk authors}" without braces.
std::string one_name(std::string_view name) {
  if (name.starts_with('{')) return std::string(name.substr(1, name.size() - 2));
  const std::size_t comma = name.find(", ");
  if (comma == std::string_view::npos) return std::string(name);
  return fmt::format("{} {}", name.substr(comma + 2), name.substr(0, comma));
}

/// " 94", or nothing.
std::string spaced(std::string_view text) {
  return text.empty() ? "" : " " + std::string(text);
}

std::string escaped_for_latex(std::string_view text) {
  std::string made;
  for (const char c : text) {
    if (std::string_view("&%#_$").find(c) != std::string_view::npos) made += '\\';
    if (c == '~' || c == '^' || c == '\\')
      made += c == '~' ? "\\textasciitilde{}" : c == '^' ? "\\textasciicircum{}" : "/";
    else
      made += c == '{' ? '(' : c == '}' ? ')' : c;
  }
  return made;
}

std::string field(std::string_view name, std::string_view value) {
  return value.empty() ? "" : fmt::format(",\n  {} = {{{}}}", name, value);
}

/// "255--283".
std::string page_range(std::string_view pages) {
  const std::size_t dash = pages.find('-');
  if (dash == std::string_view::npos) return std::string(pages);
  return fmt::format("{}--{}", pages.substr(0, dash), pages.substr(dash + 1));
}

struct Form {
  std::string_view entry, published;  ///< "article" and "journal"
};
Form form_of(Kind kind) {
  switch (kind) {
    case Kind::article:
      return {"article", "journal"};
    case Kind::book:
      return {"book", "publisher"};
    case Kind::chapter:
      return {"incollection", "booktitle"};
    case Kind::other:
      break;
  }
  return {"misc", "howpublished"};
}

}  // namespace

std::string names_text(std::string_view authors) {
  const std::vector<std::string_view> list = people(authors);
  if (list.back() == "others") return one_name(list.front()) + " et al.";
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += i + 1 < list.size() ? ", " : " and ";
    text += one_name(list[i]);
  }
  return text;
}

std::string reference_text(const Reference& r) {
  std::string names = names_text(r.authors);
  if (!names.empty() && !names.ends_with('.')) names += '.';
  std::string text = names.empty() ? "" : names + " ";
  text += r.title + ". ";
  if (r.kind == Kind::chapter) text += "In: ";
  text += r.published + spaced(r.volume);
  if (r.year > 0) text += fmt::format(" ({})", r.year);
  text += spaced(r.pages) + ".";
  if (!r.note.empty()) text += fmt::format(" {}.", r.note);
  if (!r.doi.empty()) text += fmt::format(" https://doi.org/{}", r.doi);
  return text;
}

std::string bibtex(const Reference& r) {
  const Form form = form_of(r.kind);
  std::string text = fmt::format("@{}{{{}", form.entry, r.key);
  text += field("author", r.authors);
  text += field("title", fmt::format("{{{}}}", escaped_for_latex(r.title)));
  text += field(form.published, escaped_for_latex(r.published));
  text += field("year", r.year > 0 ? fmt::format("{}", r.year) : "");
  text += field("volume", r.volume) + field("pages", page_range(r.pages)) + field("doi", r.doi);
  return text + field("note", escaped_for_latex(r.note)) + "\n}\n";
}

}  // namespace mahlwerk::report
