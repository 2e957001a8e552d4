// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/keys.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

using ChosenWords = std::map<std::string, std::size_t>;  ///< key -> index of its word

/// Search over all combinations of words that lead to new keys.
struct KeySearch {
  std::vector<KeyInfo> keys;                            ///< found so far
  std::set<std::pair<std::string, std::size_t>> tried;  ///< keys with the index of a word
  std::vector<ChosenWords> todo;                        ///< choices that reach untried words
};

/// Lists the keys under the chosen words, and adds the alternative words to `todo`.
class KeyList : public CaseVisitor {
 public:
  KeyList(KeySearch& found, ChosenWords chosen) : found_(found), chosen_(std::move(chosen)) {}

  void section(std::string_view name, std::size_t) override { prefix_ = std::string(name) + "."; }
  void number(const NumberSpec& spec, double&) override { alternative(spec); }
  void optional_number(const NumberSpec& spec, std::optional<double>&) override {
    alternative(spec);
  }
  void alternative(const NumberSpec& spec) override {
    add({prefix_ + std::string(spec.key),
         std::string(spec.unit),
         spec.range,
         {},
         std::string(spec.about)});
  }
  void integer(const IntegerSpec& spec, std::int64_t&) override {
    const Range range{.least = static_cast<double>(spec.least),
                      .most = static_cast<double>(spec.most)};
    add({prefix_ + std::string(spec.key), "", range, {}, std::string(spec.about)});
  }
  void flag(const Flag& flag, bool&) override {
    add({prefix_ + std::string(flag.key), "", {}, {"true", "false"}, ""});
  }
  void text(std::string_view key, std::string&) override {
    add({prefix_ + std::string(key), "", {}, {}, ""});
  }
  void custom(const CustomKey& key, const std::function<std::string()>&) override {
    add({prefix_ + std::string(key.key), "", {}, {}, std::string(key.about)});
  }
  bool choose(const Choice& choice, std::size_t& word_index) override {
    const std::string key = prefix_ + std::string(choice.key);
    add({key, "", {}, choice.words, ""});
    word_index = chosen(key, choice.words.size(), word_index);
    return true;
  }
  bool visits_all() override { return true; }

 private:
  void add(KeyInfo info) {
    auto& keys = found_.keys;
    if (std::ranges::find(keys, info.key, &KeyInfo::key) != keys.end()) return;
    const auto of_section = [&](const KeyInfo& k) {
      return k.key.substr(0, k.key.rfind('.') + 1) == prefix_;
    };
    const auto last = std::ranges::find_if(keys.rbegin(), keys.rend(), of_section);
    keys.insert(last == keys.rend() ? keys.end() : last.base(), std::move(info));
  }
  std::size_t chosen(const std::string& key, std::size_t count, std::size_t now) {
    if (const auto own = chosen_.find(key); own != chosen_.end()) return own->second;
    for (std::size_t word_index = 0; word_index < count; ++word_index) {
      if (!found_.tried.emplace(key, word_index).second || word_index == now) continue;
      ChosenWords other = chosen_;
      other[key] = word_index;
      found_.todo.push_back(std::move(other));
    }
    return now;
  }

  KeySearch& found_;
  ChosenWords chosen_;
  std::string prefix_;
};

/// A case with every section.
Case full_case() {
  Case c;
  c.balls.resize(2);
  c.balls.back().grains = true;
  c.powder.emplace().grain_size = 1e-3;
  c.contact.pairs.emplace_back();
  c.wear.emplace();
  c.heat.emplace();
  c.capture.emplace();
  c.grinding.emplace();
  c.kinetics.emplace();
  return c;
}

}  // namespace

const std::vector<KeyInfo>& all_keys() {
  static const std::vector<KeyInfo> keys = [] {
    KeySearch found{.keys = {}, .tried = {}, .todo = {{}}};
    while (!found.todo.empty()) {
      KeyList list(found, std::exchange(found.todo.back(), {}));
      found.todo.pop_back();
      Case c = full_case();
      describe(list, c);
    }
    KeyList list(found, {});
    Case c = full_case();
    c.run.until.emplace();
    describe(list, c);
    return std::move(found.keys);
  }();
  return keys;
}

}  // namespace mahlwerk::cases
