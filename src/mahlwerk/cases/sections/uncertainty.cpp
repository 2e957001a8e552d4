// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [uncertainty]: draws of keys of [contact] and [mill].
#include "mahlwerk/cases/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/key_reader.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/sections/writer.hpp"
#include "mahlwerk/cases/write.hpp"

namespace mahlwerk::cases {
namespace {

const TextSpec source_key{.key = "source", .about = "where the draws come from, in words"};

class DrawReader {
 public:
  explicit DrawReader(Findings& findings) : findings_(findings) {}

  std::vector<UncertainKey> read(const Node& table) {
    read_table(table, "");
    std::ranges::sort(keys_, {}, &UncertainKey::key);
    const auto other = std::ranges::find_if(keys_, [&](const UncertainKey& one) {
      return one.values.size() != keys_.front().values.size();
    });
    if (other != keys_.end())
      fault(table,
            fmt::format("\"{}\" has {} values, \"{}\" has {}", keys_.front().key,
                        keys_.front().values.size(), other->key, other->values.size()),
            "give each key as many values: those of a draw belong together");
    if (keys_.empty() && sound_)
      fault(
          table, "[uncertainty] has no key",
          "write for instance \"contact.restitution\" = [\"0.5\", \"0.6\"], or remove the section");
    return std::move(keys_);
  }

 private:
  void fault(const Node& at, std::string what, std::string remedy) {
    sound_ = false;
    findings_.faults.push_back({at.where, std::move(what), std::move(remedy), "bad-draws"});
  }
  void read_table(const Node& table, const std::string& prefix) {
    for (const auto& [key, node] : table.members) {
      if (prefix.empty() && key == source_key.key) continue;
      if (node.kind == Node::Kind::table)
        read_table(node, prefix + key + ".");
      else
        read_values(prefix + key, node);
    }
  }
  void read_values(const std::string& key, const Node& node) {
    if (!is_key_of_draw(key))
      return fault(node, fmt::format("\"{}\" cannot vary from replicate to replicate", key),
                   "[uncertainty] takes keys of [contact] and [mill]");
    UncertainKey made{.key = key, .values = {}};
    bool sound = node.kind == Node::Kind::list && node.items.size() >= 2;
    for (const Node& item : node.items) {
      sound = sound && (item.kind == Node::Kind::text || item.kind == Node::Kind::number);
      made.values.push_back(item.text);
    }
    if (!sound)
      return fault(node, fmt::format("\"{}\" must be a list of at least two values", key),
                   fmt::format("write \"{}\" = [\"...\", \"...\"], texts or numbers", key));
    findings_.origins.push_back({.key = "uncertainty." + key,
                                 .value = fmt::format("{} values", made.values.size()),
                                 .source = node.where});
    keys_.push_back(std::move(made));
  }

  Findings& findings_;
  std::vector<UncertainKey> keys_;
  bool sound_ = true;
};

}  // namespace

Uncertainty read_uncertainty(const Node* table, Findings& findings) {
  Uncertainty made;
  SectionReader in(table, "uncertainty", findings);
  if (const auto source = in.text(source_key.key)) made.source = *source;
  made.keys = DrawReader(findings).read(*table);
  return made;
}

void list_uncertainty_keys(KeyVisitor& v) {
  std::string source;
  v.text(source_key, source);
  v.custom({.key = any_key,
            .about = "the dotted name of a key of [contact] or [mill], with its values: the first "
                     "of each key are one draw, and so on",
            .required = true},
           [] { return std::string(); });
}

void write(Writer& out, const Uncertainty& uncertainty) {
  out.section("uncertainty");
  if (!uncertainty.source.empty()) out.plain(source_key.key, in_quotes(uncertainty.source));
  for (const UncertainKey& one : uncertainty.keys)
    out.plain(in_quotes(one.key), list_text(one.values));
}

}  // namespace mahlwerk::cases
