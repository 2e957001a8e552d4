// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reference/case_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/commands/reference/key_pages.hpp"
#include "mahlwerk/commands/reference/start_values.hpp"

namespace mahlwerk::commands {
namespace {

using cases::CatalogueEntry;
using cases::KeyInfo;
using cases::KeySection;

constexpr std::string_view replace_it = "ASSUMED, not of your machine: replace it by yours";
constexpr std::string_view usual_material = "steel-1.4034";

/// The keys of a section that a kind has, in the order of the list.
std::vector<const KeyInfo*> keys_of(std::string_view section, std::string_view kind) {
  std::vector<const KeyInfo*> keys;
  const auto add = [&](const KeyInfo& key) {
    const auto same = [&](const KeyInfo* k) { return k->key == key.key; };
    if (std::ranges::none_of(keys, same)) keys.push_back(&key);
  };
  for (const bool own : {true, false})  // the kind's own keys come first: their defaults count
    for (const KeySection& s : cases::key_sections())
      if (s.section == section && (own ? !s.kind.empty() && s.kind == kind : s.kind.empty()))
        for (const KeyInfo& key : s.keys) add(key);
  return keys;
}

/// The value as written in a case: a number and true or false without quotes.
std::string toml_value(std::string_view value) {
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool plain = error == std::errc() && end == value.data() + value.size();
  return plain || value == "true" || value == "false" ? std::string(value)
                                                      : fmt::format("\"{}\"", value);
}

class TemplateText {
 public:
  explicit TemplateText(std::string begin) : text_(std::move(begin)) {}

  void section(const std::string& heading, std::string_view about) {
    text_ += fmt::format("\n[{}]", heading);
    text_ += fmt::format("{} # {}\n", std::string(heading.size() < 8 ? 8 - heading.size() : 0, ' '),
                         about);
  }
  void comment(const std::string& words) { text_ += "# " + wrapped_text(words, "# ") + '\n'; }
  /// `key = value`, with the description of the key and a remark above it.
  void value(const KeyInfo& key, std::string_view value, std::string_view remark) {
    describe_key(key, remark);
    text_ += fmt::format("{} = {}\n", key.name(), toml_value(value));
  }
  /// A key that is left out: with its default, or empty.
  void left_out(const KeyInfo& key, std::string_view value, std::string_view remark) {
    describe_key(key, remark);
    text_ += fmt::format("#{} = {}\n", key.name(), value.empty() ? "..." : toml_value(value));
  }
  void line(const std::string& words) { text_ += words + '\n'; }
  std::string text() { return std::move(text_); }

 private:
  void describe_key(const KeyInfo& key, std::string_view remark) {
    std::string words = key_meaning(key, true);
    const bool number = key.type == "number" || key.type == "integer";
    std::string range = number ? key_range(key) : "";
    if (!key.unit.empty()) range = range == "any" ? key.unit : key.unit + ", " + range;
    if (key.type == "word") range = fmt::format("{}", fmt::join(key.words, ", "));
    if (!range.empty() && range != "any") words += fmt::format(" [{}]", range);
    if (!remark.empty()) words += fmt::format("; {}", remark);
    comment(words);
  }

  std::string text_;
};

/// Properties of a material of the catalogue, which are the defaults of the sections that name it.
class MaterialValues {
 public:
  MaterialValues(const cases::Catalogue& catalogue, const std::string& name) {
    if (catalogue.has("materials", name)) entry_ = catalogue.find("materials", name);
  }
  /// Writes the key with the material's value; false if the material has none.
  bool put(TemplateText& out, const KeyInfo& key) const {
    if (!entry_ || !entry_->values.contains(std::string(key.name()))) return false;
    out.left_out(key, entry_->values.at(std::string(key.name())).text,
                 fmt::format("of the material {}", entry_->name));
    return true;
  }

 private:
  std::optional<CatalogueEntry> entry_;
};

/// Writes the keys of a mill or jar.
class PartWriter {
 public:
  PartWriter(TemplateText& out, std::string section, std::string kind,
             std::optional<CatalogueEntry> entry, const cases::Catalogue& catalogue)
      : out_(out),
        section_(std::move(section)),
        kind_(std::move(kind)),
        entry_(std::move(entry)),
        material_(catalogue, of_entry("material") ? of_entry("material")->text : "") {}

  void write(std::string_view file) {
    const auto keys = keys_of(section_, kind_);
    if (entry_) {
      out_.comment(fmt::format("{}: mahlwerk describe {} shows all values and sources",
                               entry_->title, entry_->name));
      out_.line(fmt::format("model = \"{}\"", entry_->name));
    } else {
      out_.line(fmt::format("kind = \"{}\"", kind_));
    }
    for (const bool required : {true, false})  // what must be given comes first
      for (const KeyInfo* key : keys) {
        const bool chosen = key->name() == "kind" || key->name() == "model";
        if (!chosen && (key->required || !key->start.empty()) == required) put(*key, file);
      }
  }

  /// Gives a key this value instead of its default.
  void set(std::string_view key, std::string_view value) {
    set_key_ = key;
    set_value_ = value;
  }

 private:
  const cases::CatalogueValue* of_entry(const std::string& name) const {
    if (!entry_) return nullptr;
    const auto found = entry_->values.find(name);
    return found == entry_->values.end() ? nullptr : &found->second;
  }
  void put(const KeyInfo& key, std::string_view file) {
    const std::string name(key.name());
    if (name == set_key_) return out_.value(key, set_value_, "as this jar needs it");
    const auto *own = of_entry(name), *least = of_entry(name + "_least"),
               *most = of_entry(name + "_most");
    if (own != nullptr && !key.instead_of.empty()) return;  // nominal volume of a jar
    if (own != nullptr && own->assumed)
      return out_.left_out(key, own->text, fmt::format("{}; {}", replace_it, own->source));
    if (own != nullptr)
      return out_.left_out(key, own->text,
                           fmt::format("of the catalogue{}: {}",
                                       own->unverified ? ", UNVERIFIED" : "", own->source));
    if (most != nullptr) {
      const std::string range =
          least != nullptr ? least->text + " to " + most->text : "up to " + most->text;
      return out_.value(key, most->text, "the machine offers " + range);
    }
    if (material_.put(out_, key)) return;
    if (!key.required) return out_.left_out(key, key.default_value, default_remark(key));
    if (name == "file") return out_.value(key, file, "a sample file was written for you");
    out_.value(key, start_of(key), replace_it);
  }
  /// The value of a new case; of a key whose description names none, one of its kind.
  static std::string start_of(const KeyInfo& key) {
    if (!key.start.empty()) return key.start;
    if (!key.words.empty()) return key.words.front();
    return key.type == "integer" ? "1" : example_of(key.unit);
  }
  static std::string default_remark(const KeyInfo& key) {
    return key.default_source.empty() ? "" : "default: " + key.default_source;
  }

  TemplateText& out_;
  std::string section_, kind_;
  std::optional<CatalogueEntry> entry_;
  MaterialValues material_;
  std::string_view set_key_, set_value_;
};

/// Keys of a section that has no kind, or whose default kind is taken: only what counts under the
/// default words. `given`: keys that stand already.
void put_defaults(TemplateText& out, std::string_view section,
                  std::initializer_list<std::string_view> given,
                  const MaterialValues* material = nullptr) {
  const auto keys = keys_of(section, section == "contact" ? "hertz-mindlin" : "");
  const auto holds = [&](const KeyInfo& key) {
    return std::ranges::all_of(key.under, [&](const auto& condition) {
      const auto choice =
          std::ranges::find_if(keys, [&](const KeyInfo* k) { return k->key == condition.first; });
      return choice != keys.end() &&
             std::ranges::find(condition.second, (*choice)->default_value) !=
                 condition.second.end();
    });
  };
  for (const KeyInfo* key : keys) {
    const bool stands = std::ranges::find(given, key->name()) != given.end();
    const bool needs_file = key->type == "list" || key->type == "table";
    if (stands || needs_file || key->required || !holds(*key)) continue;
    if (material != nullptr && material->put(out, *key)) continue;
    out.left_out(*key, key->default_value,
                 key->default_source.empty() ? "" : "default: " + key->default_source);
  }
}

const KeyInfo& key_named(std::string_view key) {
  return *cases::find_key(key);
}

/// A fifth of the jar's diameter, in whole millimetres.
std::string diameter_for(const CatalogueEntry& jar) {
  const auto found = jar.values.find("diameter");
  if (found == jar.values.end()) return std::string(start_balls(jar.kind).diameter);
  return fmt::format("{} mm",
                     std::max(1.0, std::round(parse_in(found->second.text, "m") * 1e3 / 5)));
}

void put_balls(TemplateText& out, const CaseParts& parts, const cases::Catalogue& catalogue) {
  out.section("[balls]", "a ball set; write another [[balls]] for each further set");
  const StartBalls start = start_balls(parts.jar_kind);
  if (!parts.balls.empty()) {
    const CatalogueEntry entry = catalogue.find("media", parts.balls, "--balls");
    out.comment(fmt::format("{}: mahlwerk describe {}", entry.title, entry.name));
    out.line(fmt::format("model = \"{}\"", entry.name));
    const auto own = entry.values.find("material");
    const bool dense = entry.values.contains("density") || own != entry.values.end();
    const MaterialValues material(catalogue, own != entry.values.end()
                                                 ? own->second.text
                                                 : std::string(dense ? "" : usual_material));
    if (!dense) out.value(key_named("balls.material"), usual_material, replace_it);
    return put_defaults(out, "balls", {"model", "material", "count"}, &material);
  }
  const bool known = !parts.jar.empty();
  const std::string diameter = known ? diameter_for(catalogue.find("jars", parts.jar, "--jar"))
                                     : std::string(start.diameter);
  out.value(key_named("balls.diameter"), diameter, replace_it);
  out.value(key_named("balls.material"), usual_material, replace_it);
  out.value(key_named(fmt::format("balls.{}", start.key)), start.value, replace_it);
  const MaterialValues material(catalogue, std::string(usual_material));
  put_defaults(out, "balls", {"diameter", "material", start.key}, &material);
}

void check_kind(const std::string& kind, std::string_view section, const char* option) {
  const auto kinds = kinds_of(section);
  if (std::ranges::find(kinds, kind) != kinds.end()) return;
  const std::string near = cases::nearest_name(kind, kinds);
  throw InputError(Fault{option, fmt::format("there is no kind of {} called '{}'", section, kind),
                         near.empty() ? fmt::format("one of: {}", fmt::join(kinds, ", "))
                                      : fmt::format("did you mean '{}'?", near),
                         "unknown-word"});
}

/// The sections that the template does not write: "[powder], [liquid], ...".
std::string other_sections() {
  constexpr std::array written{"",        "mill",          "jar", "balls",
                               "contact", "contact.pairs", "run", "observe"};
  std::string names;
  for (const cases::SectionSpec& s : cases::section_list())
    if (std::ranges::find(written, s.name) == written.end())
      names += fmt::format("{}{}{}{}", names.empty() ? "" : ", ", s.several ? "[[" : "[", s.name,
                           s.several ? "]]" : "]");
  return names;
}

}  // namespace

void complete(CaseParts& parts, const cases::Catalogue& catalogue) {
  std::vector<std::string> jars;
  if (!parts.mill.empty()) {
    const CatalogueEntry entry = catalogue.find("mills", parts.mill, "--mill");
    parts.mill_kind = entry.kind;
    jars = entry.jars;
  }
  check_kind(parts.mill_kind, "mill", "--kind");
  if (parts.jar.empty() && parts.jar_kind.empty()) {
    if (jars.empty())
      parts.jar_kind = start_jar(parts.mill_kind);
    else
      parts.jar = jars[jars.size() / 2];  // neither the smallest nor the largest
  }
  // "25 ml" is the mill's own jar of this volume.
  if (std::vector<std::string> called = catalogue.entries_called("jars", parts.jar);
      called.size() > 1) {
    std::erase_if(
        called, [&](const std::string& jar) { return std::ranges::find(jars, jar) == jars.end(); });
    if (called.size() == 1) parts.jar = called.front();
  }
  if (!parts.jar.empty()) parts.jar_kind = catalogue.find("jars", parts.jar, "--jar").kind;
  check_kind(parts.jar_kind, "jar", "--jar-kind");
}

std::string case_template(const CaseParts& parts, const cases::Catalogue& catalogue) {
  const auto entry = [&](std::string_view category, const std::string& name) {
    return name.empty() ? std::nullopt : std::optional(catalogue.find(category, name));
  };
  const auto mill = entry("mills", parts.mill);
  TemplateText out(
      "# #key = value: the value counts already, as a default or by the catalogue. Remove the # "
      "to\n"
      "# change it. Where there is none, three dots stand for it. In brackets: unit and "
      "range.\n\n");
  out.line(fmt::format("title = \"{}\"", mill ? mill->title : "A mill of kind " + parts.mill_kind));
  const bool falls = parts.jar_kind == "periodic-box";
  if (falls)
    out.value(key_named("gravity"), "0 m/s2", "in a periodic box balls would fall without end");
  put_defaults(out, "", {"title", falls ? "gravity" : ""});
  out.section("mill", "the mill and its motion");
  PartWriter mill_part(out, "mill", parts.mill_kind, mill, catalogue);
  if (parts.jar_kind.starts_with("periodic-") && !falls) mill_part.set("jar_axis", "horizontal");
  mill_part.write(parts.motion_file);
  out.section("jar", "inner shape and sizes of the jar");
  if (mill && mill->jars.size() > 1)
    out.comment(
        fmt::format("jars of the catalogue for this mill: {}", fmt::join(mill->jars, ", ")));
  PartWriter(out, "jar", parts.jar_kind, entry("jars", parts.jar), catalogue)
      .write(parts.surface_file);
  put_balls(out, parts, catalogue);
  out.section("contact", "rules and parameters of all contacts; [[contact.pairs]] for exceptions");
  put_defaults(out, "contact", {"law"});
  out.section("run", "engine, times and replicates");
  out.value(key_named("run.time"), "1 s", "short, to try the case; give it more for small errors");
  put_defaults(out, "run", {"time", "until", "longest"});
  out.section("observe", "statistics and records");
  put_defaults(out, "observe", {});
  out.line("");
  out.comment(fmt::format("More sections: {}. `mahlwerk describe powder` shows the keys.",
                          other_sections()));
  return out.text();
}

}  // namespace mahlwerk::commands
