// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/citation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "mahlwerk/report/record/reference_text.hpp"

namespace mahlwerk::report {
namespace {

/// The values of one entry of the catalogue that a case uses: source -> last parts of the keys.
using EntryValues = std::map<std::string, std::vector<std::string>>;

/// "mills/retsch-mm400" -> its values, from sources such as "catalogue mills/retsch-mm400: ...".
std::map<std::string, EntryValues> catalogue_values(const cases::Case& c) {
  constexpr std::string_view begin = "catalogue ";
  std::map<std::string, EntryValues> entries;
  for (const cases::Origin& origin : c.origins) {
    if (!origin.source.starts_with(begin)) continue;
    const std::string said = origin.source.substr(begin.size());
    const std::size_t colon = said.find(": ");
    if (colon == std::string::npos) continue;  // the name of the entry alone, without a value
    std::vector<std::string>& keys = entries[said.substr(0, colon)][said.substr(colon + 2)];
    const std::string key = origin.key.substr(origin.key.rfind('.') + 1);
    if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  }
  return entries;
}

/// An entry of the catalogue as a reference; its note holds the source of each value.
Reference catalogue_reference(const std::string& entry, const EntryValues& values) {
  std::string note, key = "mahlwerk-" + entry;
  std::ranges::replace(key, '/', '-');
  for (const auto& [source, keys] : values)
    note += fmt::format("{}{}: {}", note.empty() ? "" : "; ", fmt::join(keys, ", "), source);
  return {.key = key,
          .kind = Reference::Kind::other,
          .authors = "{The Mahlwerk authors}",
          .title = fmt::format("Entry {} of the catalogue of Mahlwerk", entry),
          .published = "Data with their sources",
          .note = note};
}

/// The references of a citation, each once, by number.
class Numbered {
 public:
  explicit Numbered(std::vector<Reference>& list) : list_(list) {}
  std::size_t add(const Reference& one) {
    const auto found = std::ranges::find(list_, one.key, &Reference::key);
    if (found != list_.end()) return static_cast<std::size_t>(found - list_.begin()) + 1;
    list_.push_back(one);
    return list_.size();
  }

 private:
  std::vector<Reference>& list_;
};

/// "[2, 3]".
std::string brackets(const std::vector<std::size_t>& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

/// " Models: contact law (hertz-mindlin) [2, 3]; ... Values of the catalogue: ... [4]."
std::string sources_text(const std::vector<CitedUse>& used,
                         const std::vector<std::string>& entries) {
  std::string models, values;
  for (const CitedUse& one : used)
    models += fmt::format("{}{} ({}) {}", models.empty() ? " Models: " : "; ", one.subject,
                          one.model, brackets(one.numbers));
  for (const std::string& entry : entries)
    values += (values.empty() ? " Values of the catalogue: " : "; ") + entry;
  return models + (models.empty() ? "" : ".") + values + (values.empty() ? "" : ".");
}

}  // namespace

Citation citation(const cases::Case& c, const RunState& run, const CountedRuns& counted,
                  std::string_view version) {
  Citation made;
  Numbered numbered(made.references);
  const std::string program =
      fmt::format("{} [{}]", version, numbered.add(program_reference(version)));
  for (const CitedModel* model : used_models(c, run)) {
    if (model->keys.empty()) continue;
    CitedUse use{std::string(model->subject), std::string(model->model), {}};
    for (const std::string_view key : model->keys)
      use.numbers.push_back(numbered.add(reference(key)));
    made.models.push_back(std::move(use));
  }
  std::vector<std::string> entries;
  for (const auto& [entry, values] : catalogue_values(c))
    entries.push_back(
        fmt::format("{} [{}]", entry, numbered.add(catalogue_reference(entry, values))));
  made.paragraph = methods(c, run.engine, counted, program) + sources_text(made.models, entries);
  return made;
}

std::string citation_text(const Citation& citation) {
  std::string text = citation.paragraph + "\n\n";
  for (std::size_t i = 0; i < citation.references.size(); ++i)
    text += fmt::format("[{}] {}\n", i + 1, reference_text(citation.references[i]));
  return text;
}

std::string citation_bibtex(const Citation& citation) {
  std::string text;
  for (const Reference& one : citation.references) text += (text.empty() ? "" : "\n") + bibtex(one);
  return text;
}

}  // namespace mahlwerk::report
