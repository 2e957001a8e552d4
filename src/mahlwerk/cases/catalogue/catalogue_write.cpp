// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/catalogue/catalogue_write.hpp"

#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"

namespace mahlwerk::cases {
namespace {

std::string line(std::string_view key, std::string_view text) {
  return fmt::format("{} = {}\n", key, in_quotes(text));
}

std::string list(std::string_view key, const std::vector<std::string>& texts) {
  if (texts.empty()) return "";
  std::string items;
  for (const std::string& text : texts) items += fmt::format("  {},\n", in_quotes(text));
  return fmt::format("{} = [\n{}]\n", key, items);
}

std::string part_table(const CataloguePart& part) {
  std::string text = "\n[[parts]]\n";
  for (const auto& [key, value] : part.keys) text += fmt::format("{} = {}\n", key, value);
  text += line("source", part.source);
  if (part.unverified || part.assumed)
    text += line("confidence", part.assumed ? "assumed" : "unverified");
  return text;
}

std::string value_table(const std::string& key, const CatalogueValue& value) {
  std::string text = fmt::format("\n[{}]\n", key) + line("value", value.text);
  const bool ranged = !value.range[0].empty();
  if (ranged) text += line("from", value.range[0]) + line("to", value.range[1]);
  text += line("source", value.source);
  if (value.unverified) text += line("confidence", "unverified");
  if (value.assumed || ranged) text += line("confidence", value.assumed ? "assumed" : "measured");
  return text;
}

}  // namespace

std::string entry_text(const CatalogueEntry& entry) {
  std::string text = line("title", entry.title) + list("names", entry.names);
  if (!entry.kind.empty()) text += line("kind", entry.kind);
  text += line("about", entry.about) + list("jars", entry.jars);
  for (const auto& [key, value] : entry.values) text += value_table(key, value);
  for (const CataloguePart& part : entry.parts) text += part_table(part);
  for (const CatalogueCheck& check : entry.checks)
    text += "\n[[check]]\n" + line("quantity", check.quantity) +
            fmt::format("equals = {}\n", shortest(check.expected)) +
            line("within", shortest(100 * check.tolerance) + " %") + line("source", check.source);
  return text;
}

}  // namespace mahlwerk::cases
