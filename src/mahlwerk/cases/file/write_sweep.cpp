// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "mahlwerk/cases/file/writer.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sweep_words.hpp"

namespace mahlwerk::cases {
namespace {

std::string list_of(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + in_quotes(word);
  return "[" + list + "]";
}

std::string values_text(const SweptKey& key) {
  if (!key.range) return list_of(key.values);
  return fmt::format("{{ from = {}, to = {}{}{} }}", in_quotes(key.values[0]),
                     in_quotes(key.values[1]),
                     key.steps > 0 ? fmt::format(", steps = {}", key.steps) : "",
                     key.logarithmic ? ", spacing = \"logarithmic\"" : "");
}

template <class Looks>
void write_search(Writer& out, const Looks& looks) {
  out.plain(fmt::format("settings = {}\nreplicates = {}\n", looks.settings, looks.replicates));
  std::string over;
  for (const SweptKey& key : looks.over)
    over +=
        fmt::format("{}{} = {}", over.empty() ? "" : ", ", in_quotes(key.key), values_text(key));
  out.plain(fmt::format("over = {{ {} }}\n", over));
}

void write_optimise(Writer& out, const Optimise& wanted) {
  out.section("optimise");
  out.plain(fmt::format("{} = {}\n", wanted.maximise ? "maximise" : "minimise",
                        in_quotes(wanted.quantity)));
  std::string limits;
  for (const Limit& limit : wanted.limits)
    limits += fmt::format("{}{} = {}", limits.empty() ? "" : ", ", in_quotes(limit.quantity),
                          in_quotes((limit.below ? "below " : "above ") + limit.bound));
  if (!limits.empty()) out.plain(fmt::format("limits = {{ {} }}\n", limits));
  write_search(out, wanted);
}

}  // namespace

void write_sweep(Writer& out, const Case& c) {
  if (!c.sweep.empty()) {
    out.section("sweep");
    out.plain(fmt::format("design = {}\n",
                          in_quotes(design_words()[static_cast<std::size_t>(c.sweep.design)])));
    if (c.sweep.samples > 0) out.plain(fmt::format("samples = {}\n", c.sweep.samples));
    std::string groups;
    for (const auto& group : c.sweep.together)
      groups += (groups.empty() ? "" : ", ") + list_of(group);
    if (!groups.empty()) out.plain(fmt::format("together = [{}]\n", groups));
    for (const SweptKey& key : c.sweep.keys)
      out.plain(fmt::format("{} = {}\n", in_quotes(key.key), values_text(key)));
    for (const auto& [key, formula] : c.sweep.derived)
      out.plain(fmt::format("{} = {}\n", in_quotes(key), in_quotes("=" + formula)));
  }
  if (c.optimise) write_optimise(out, *c.optimise);
  if (c.match) {
    out.section("match");
    write_search(out, *c.match);
  }
  if (!c.fit.empty()) out.section("fit");
  for (const auto& [key, ends] : c.fit)
    out.plain(
        fmt::format("{} = [{}, {}]\n", in_quotes(key), in_quotes(ends[0]), in_quotes(ends[1])));
}

}  // namespace mahlwerk::cases
