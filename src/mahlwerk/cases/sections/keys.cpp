// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/keys.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <utility>

#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/sections/key_list.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::array first_sections{
    SectionSpec{"", "", "keys at the top of the file, before the first section"},
    SectionSpec{"mill", "kind", "the mill and its motion"},
    SectionSpec{"jar", "kind", "the jar: inner shape, sizes and material of the wall"},
    SectionSpec{"parts", "kind",
                "a part of the mill in the jar, at rest or moving; one section for each part",
                false, true},
    SectionSpec{"balls", "", "a ball set: size, number and material; one section for each set",
                false, true},
    SectionSpec{"powder", "", "the powder: amount, sizes and material"},
    SectionSpec{"contact", "law", "rules and parameters of all contacts"},
    SectionSpec{"contact.pairs", "",
                "an exception from [contact] for certain pairs; one section for each", false, true},
    SectionSpec{"liquid", "kind", "liquid in the jar: films on the bodies, or a jar full of it"},
    SectionSpec{"run", "", "engine, times, replicates and the start of a run"},
    SectionSpec{"observe", "", "statistics and records of a run"},
    SectionSpec{"milling", "",
                "how long the mill runs, its sense of rotation, and a dose to reach"}};

constexpr std::array sections_of_many_runs{
    SectionSpec{"sweep", "", "a campaign: keys of the case that vary", true},
    SectionSpec{"optimise", "", "search for the settings of a largest or smallest quantity", true},
    SectionSpec{"match", "", "search for settings that treat powder as another mill does", true},
    SectionSpec{"fit", "", "parameters that are determined from measurements", true},
    SectionSpec{"uncertainty", "", "keys that vary from replicate to replicate", true}};

std::vector<SectionSpec> all_sections() {
  std::vector<SectionSpec> all(first_sections.begin(), first_sections.end());
  for (const Part* part : parts())
    for (const PartSection& one : part->sections) all.push_back(one.spec);
  all.insert(all.end(), sections_of_many_runs.begin(), sections_of_many_runs.end());
  return all;
}

/// A case with every section.
Case full_case() {
  Case c;
  c.machine_parts.emplace_back();
  c.balls.resize(2);
  c.balls.back().grains = true;
  c.powder.emplace().grain_size = 1e-3;
  c.contact.rule.friction = 0.3;  // so that the default of `bounce` holds
  c.contact.pairs.emplace_back();
  c.liquid.emplace();
  c.milling.emplace();
  for (const Part* part : parts())
    for (const PartSection& one : part->sections)
      if (one.add != nullptr) one.add(c);
  return c;
}

/// Whether two descriptions of a key differ in their default only.
bool same_value(const KeyInfo& a, const KeyInfo& b) {
  const auto ends = [](const Range& r) {
    return std::tuple(r.least, r.most, r.without_least, r.without_most);
  };
  const auto values = [](const KeyInfo& k) {
    return std::tie(k.key, k.type, k.unit, k.words, k.meanings, k.about, k.required, k.instead_of,
                    k.under, k.engines);
  };
  return values(a) == values(b) && ends(a.range) == ends(b.range);
}

/// The keys of a section under all combinations of words that lead to new keys. Words may be fixed.
/// A key whose meaning or range depends on a word is found once for each.
class KeySearch {
 public:
  KeySearch(const SectionSpec& section, ChosenWords fixed)
      : section_(section), todo_{std::move(fixed)} {}

  std::vector<KeyInfo> keys() {
    while (!todo_.empty()) {
      const ChosenWords chosen = std::exchange(todo_.front(), {});
      todo_.pop_front();
      Case c = full_case();
      visit(chosen, c);
    }
    for (std::size_t i = 0; i < keys_.size(); ++i) found_under_.push_back(conditions(keys_[i]));
    for (std::size_t i = 0; i < keys_.size(); ++i) keys_[i].under = std::move(found_under_[i]);
    if (section_.name == "run") add_until();
    return std::move(keys_);
  }

 private:
  /// The keys of time = "until 2 %".
  void add_until() {
    Case c = full_case();
    c.run.until.emplace();
    KeyList list(section_.name, {});
    describe(list, c);
    auto after = std::ranges::find(keys_, "run.time", &KeyInfo::key);
    for (const KeyInfo& info : list.keys())
      if (std::ranges::find(keys_, info.key, &KeyInfo::key) == keys_.end())
        after = keys_.insert(after + 1, info);
  }
  void visit(const ChosenWords& chosen, Case& c) {
    KeyList list(section_.name, chosen);
    if (section_.many_runs)
      describe_many_runs(list);
    else
      describe(list, c);
    auto after = keys_.begin();  // new keys follow the one that is visited before them
    for (const KeyInfo& info : list.keys()) {
      auto known =
          std::ranges::find_if(keys_, [&](const KeyInfo& key) { return same_value(key, info); });
      if (known == keys_.end()) {
        const auto same = std::ranges::find(keys_.rbegin(), keys_.rend(), info.key, &KeyInfo::key);
        known = keys_.insert(same == keys_.rend() ? after : same.base(), info);
      }
      after = known + 1;
    }
    for (const auto& [key, choice] : list.choices())
      for (std::size_t i = 0; i < choice.words.size(); ++i) {
        if (!tried_.emplace(key, i).second || i == choice.word_index || chosen.contains(key))
          continue;
        ChosenWords other = chosen;
        other[key] = i;
        todo_.push_back(std::move(other));
      }
    visits_.push_back(std::move(list));
  }

  static bool has(const KeyList& visit, const KeyInfo& key) {
    return std::ranges::any_of(visit.keys(),
                               [&](const KeyInfo& info) { return same_value(key, info); });
  }
  /// The only choice in which two visits differ; empty if they differ in none or several.
  static std::string difference(const KeyList& a, const KeyList& b) {
    std::string found;
    for (const auto& [key, choice] : a.choices()) {
      const auto other = b.choices().find(key);
      if (other == b.choices().end() || other->second.word_index == choice.word_index) continue;
      if (!found.empty()) return {};
      found = key;
    }
    return found;
  }
  /// The choices that decide whether the section has the key, with the words under which it has it.
  std::map<std::string, std::vector<std::string>> conditions(const KeyInfo& key) const {
    std::vector<const KeyList*> with, without;
    for (const KeyList& visit : visits_) (has(visit, key) ? with : without).push_back(&visit);
    std::set<std::string> deciding;
    for (const KeyList* a : with)
      for (const KeyList* b : without) deciding.insert(difference(*a, *b));
    deciding.erase("");
    std::map<std::string, std::vector<std::string>> found;
    for (const std::string& choice : deciding) {
      std::set<std::size_t> words;
      const KeyList::Chosen* chosen = nullptr;
      for (const KeyList* visit : with) {
        const auto at = visit->choices().find(choice);
        if (at == visit->choices().end()) continue;
        chosen = &at->second;
        words.insert(chosen->word_index);
      }
      for (const std::size_t word : words) found[choice].push_back(chosen->words[word]);
    }
    return found;
  }

  const SectionSpec& section_;
  std::deque<ChosenWords> todo_;                         ///< words that are not tried yet
  std::set<std::pair<std::string, std::size_t>> tried_;  ///< keys with the index of a word
  std::vector<KeyList> visits_;
  std::vector<KeyInfo> keys_;  ///< found so far
  std::vector<std::map<std::string, std::vector<std::string>>> found_under_;
};

/// The keys that all kinds have. A default that differs is replaced by a remark.
std::vector<KeyInfo> common_keys(const std::vector<KeySection>& kinds) {
  std::vector<KeyInfo> common;
  for (const KeyInfo& key : kinds.front().keys) {
    bool everywhere = true, equal = true;
    for (const KeySection& kind : kinds) {
      const auto other =
          std::ranges::find_if(kind.keys, [&](const KeyInfo& k) { return same_value(k, key); });
      everywhere = everywhere && other != kind.keys.end();
      equal = equal && everywhere && *other == key;
    }
    if (!everywhere) continue;
    common.push_back(key);
    if (equal) continue;
    common.back().default_value.clear();
    common.back().default_source = "depends on the kind";
  }
  return common;
}

void add_section(std::vector<KeySection>& all, const SectionSpec& spec) {
  const std::string name(spec.name), choice = name + "." + std::string(spec.choice);
  std::vector<KeyInfo> keys = KeySearch(spec, {}).keys();
  if (spec.choice.empty()) {
    all.push_back({name, "", "", std::string(spec.about), spec.several, std::move(keys)});
    return;
  }
  const KeyInfo chosen = *std::ranges::find(keys, choice, &KeyInfo::key);
  std::vector<KeySection> kinds;
  for (std::size_t i = 0; i < chosen.words.size(); ++i)
    kinds.push_back({name, chosen.words[i], choice, chosen.meanings[i], spec.several,
                     KeySearch(spec, {{choice, i}}).keys()});
  const std::vector<KeyInfo> common = common_keys(kinds);
  all.push_back({name, "", choice, std::string(spec.about), spec.several, common});
  for (KeySection& kind : kinds) {
    std::erase_if(kind.keys, [&](const KeyInfo& key) {
      return std::ranges::find(common, key) != common.end();
    });
    all.push_back(std::move(kind));
  }
}

}  // namespace

std::span<const SectionSpec> section_list() {
  static const std::vector<SectionSpec> all = all_sections();
  return all;
}

std::string_view KeyInfo::name() const {
  return std::string_view(key).substr(key.rfind('.') + 1);
}

bool KeyInfo::operator==(const KeyInfo& o) const {
  return same_value(*this, o) && default_value == o.default_value &&
         default_source == o.default_source;
}

const std::vector<KeyInfo>& all_keys() {
  static const std::vector<KeyInfo> keys = [] {
    std::vector<KeyInfo> found;
    for (const SectionSpec& spec : section_list())
      if (!spec.many_runs)
        for (KeyInfo& key : KeySearch(spec, {}).keys())
          if (std::ranges::find(found, key.key, &KeyInfo::key) == found.end())
            found.push_back(std::move(key));
    return found;
  }();
  return keys;
}

const KeyInfo* find_key(std::string_view dotted) {
  std::string key;  // without the numbers of sections
  for (std::size_t from = 0; from < dotted.size();) {
    const std::size_t to = std::min(dotted.find('.', from), dotted.size());
    const std::string_view part = dotted.substr(from, to - from);
    if (part.find_first_not_of("0123456789") != std::string_view::npos)
      key += (key.empty() ? "" : ".") + std::string(part);
    from = to + 1;
  }
  const auto at = std::ranges::find(all_keys(), key, &KeyInfo::key);
  return at == all_keys().end() ? nullptr : &*at;
}

const std::vector<KeySection>& key_sections() {
  static const std::vector<KeySection> all = [] {
    std::vector<KeySection> found;
    for (const SectionSpec& spec : section_list()) add_section(found, spec);
    return found;
  }();
  return all;
}

}  // namespace mahlwerk::cases
