// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/grinding/section.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/grinding_fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/powder/models.hpp"

namespace mahlwerk::parts::grinding {

using namespace cases;  // the words of sections

namespace {

/// A number with a default, or one that must be measured on the powder.
void describe_constant(KeyVisitor& v, const NumberSpec& spec, double& value, const Case& c) {
  SectionReader* in = v.reader();
  if (in == nullptr || in->gives(spec.key) || spec.standard) return v.number(spec, value);
  value = invalid_value;
  const std::string powder =
      c.powder && !c.powder->material.empty() ? c.powder->material : "this powder";
  in->missing(spec.key, spec.about,
              fmt::format("no published value is known for {}: give it, for instance {} = \"{}\", "
                          "or let `mahlwerk fit` find it from measured sizes",
                          powder, spec.key, example_of(spec.unit)));
}

/// The spec of a field. The fracture energy of Barrios' bed has a default if the breakage model
/// provides it.
template <class M>
NumberSpec spec_of(const Field<M>& field, bool remembering) {
  const NumberSpec usual(field);
  return std::is_same_v<M, powder::Barrios> && remembering
             ? usual.with_default(0, "that of [breakage] for each size")
             : usual;
}

/// The model and its numbers; false after an unknown word. `remembering`: the breakage model tracks
/// the strength of grains.
template <class... Models>
bool describe_model(KeyVisitor& v, std::string_view about, std::variant<Models...>& any,
                    const Case& c, bool remembering) {
  if (!v.model({.key = "model", .words = {}, .standard = "", .about = about}, any)) {
    v.ignore_unknown_keys();
    return false;
  }
  const auto numbers = [&](auto& model) {
    for (const auto& field : model.fields())
      describe_constant(v, spec_of(field, remembering), model.*field.value, c);
  };
  std::visit(numbers, any);
  return true;
}

/// The powder's material, if the catalogue has it.
std::optional<CatalogueEntry> material_of(const Case& c, const Catalogue& catalogue) {
  const std::string name = c.powder ? c.powder->material : "";
  if (!catalogue.has("materials", name)) return {};
  try {
    return catalogue.find("materials", name);
  } catch (const InputError&) {
    return {};  // [powder] has reported it
  }
}

void describe_method(KeyVisitor& v, Grinding& g) {
  using Method = Grinding::Method;
  v.word({"method",
          {"balance", "statistical", "both"},
          "balance",
          "expected values, not random",
          "how sizes are computed",
          {"population balance, for expected values", "a random sample of grains, hit by hit",
           "both methods"}},
         g.method);
  if (g.method == Method::balance)
    v.refuse({"sample"}, "under method = \"balance\"",
             "remove it, or write method = \"statistical\" or \"both\"");
  if (g.method != Method::balance || (v.visits_all() && !v.tries_all_words()))
    v.integer({"sample", min_sample, max_sample, "grains of the statistical method",
               Grinding().sample, "sampling error of shares 0.5 % at most"},
              g.sample);
  v.word({"bed",
          {"by-size", "mixed"},
          "by-size",
          "each hit captures grains of one size",
          "what a collision captures",
          {"grains of one size", "the powder with its present size distribution"}},
         g.bed);
}

/// The finest size, by default a fixed ratio below the largest of the feed.
void describe_smallest(KeyVisitor& v, Grinding& g, const Case& c) {
  SectionReader* in = v.reader();
  const bool sized = c.powder && c.powder->size;
  if (in != nullptr && !in->gives("smallest") && sized) {
    g.smallest = c.powder->feed.largest() / octaves_below;
    in->record_default("smallest", show_rounded(g.smallest, "m"), "twelve octaves below the feed");
  } else if (in != nullptr && !sized) {
    g.smallest = invalid_value;
  } else {
    v.number(NumberSpec("smallest", "m", positive, "finest grain size that is resolved")
                 .with_default_text("largest size of the feed / 4096"),
             g.smallest);
  }
}

/// The number of size classes per octave.
void describe_per_octave(KeyVisitor& v, Grinding& g, bool remembering) {
  v.integer({"classes_per_octave", size_step, max_per_octave,
             "size classes for a factor of two, a multiple of three; 3 by default under tavares",
             remembering ? size_step : 2 * size_step,
             remembering ? "few, as each class has many strengths" : "a size every 12 %"},
            g.classes_per_octave);
  SectionReader* in = v.reader();
  if (in != nullptr && g.classes_per_octave % size_step != 0)
    in->fault(*in->find("classes_per_octave"),
              fmt::format("classes_per_octave = {} is not a multiple of {}", g.classes_per_octave,
                          size_step),
              "write 3, 6, 9 or 12: half the volume is then a whole number of classes below",
              "out-of-range");
}

void describe_sticking_and_welding(KeyVisitor& v, Grinding& g) {
  const bool read = v.reader() != nullptr;
  v.fields(g, grinding_shares());
  if (!read || v.gives("sticking"))
    v.optional_number(NumberSpec("sticking_size", "m", positive, "largest grain size that sticks")
                          .with_default_text("grains of all sizes"),
                      g.sticking_size);
  else
    v.refuse({"sticking_size"}, "without `sticking`", "remove it, or write sticking = \"10 %\"");
  if (!read || v.gives("welding"))
    v.number(NumberSpec(welding_energy), g.welding_energy);
  else
    v.refuse({"welding_energy"}, "without `welding`", "remove it, or write welding = 0.01");
}

/// The tables of the sections; null for a missing section.
struct Tables {
  const Node *capture, *breakage, *fragments, *grinding, *bed_breakage;
};

/// Reports incomplete sets of [breakage], [fragments] and [grinding].
void unused_sections(const Tables& t, Findings& findings) {
  const auto fault = [&](const Node* at, std::string what, std::string remedy) {
    findings.faults.push_back({at->where, std::move(what), std::move(remedy), "lone-section"});
  };
  const auto part = [&](const Node* table, std::string_view name, std::string_view what,
                        const std::vector<std::string>& models) {
    if (table != nullptr && t.grinding == nullptr && t.bed_breakage == nullptr)
      fault(table,
            fmt::format("[{}] is given without [grinding] or [bed_breakage], which use it", name),
            "add [grinding] with time = \"30 s\" or so, or remove it");
    const Node* user = t.grinding != nullptr ? t.grinding : t.bed_breakage;
    if (table == nullptr && user != nullptr)
      fault(user,
            fmt::format("[{}] needs [{}]: {}", user == t.grinding ? "grinding" : "bed_breakage",
                        name, what),
            fmt::format("add [{}] with model = ..., one of {}", name, quoted_list(models)));
  };
  part(t.breakage, "breakage", "which hits break a grain",
       model_names(std::type_identity<powder::AnyBreakage::Models>{}));
  part(t.fragments, "fragments", "the fragments of a broken grain",
       model_names(std::type_identity<powder::AnyFragments::Models>{}));
}

}  // namespace

void describe(KeyVisitor& v, Capture& capture, const Case& c, bool remembering) {
  const auto energy = [&] {
    v.word({"energy",
            {"normal", "contact-point", "lost"},
            "normal",
            "the part along the line of centres; sliding does not press",
            "energy of a collision that acts on the powder",
            {"kinetic energy of the approach along the line of centres",
             "kinetic energy of the relative motion at the contact point",
             "energy that the collision dissipates"}},
           capture.energy);
    v.number(NumberSpec(energy_share), capture.energy_share);
  };
  if (v.reader() != nullptr) energy();
  if (describe_model(v, "which powder a collision captures", *capture.model, c, remembering) &&
      v.reader() == nullptr)
    energy();
}

void describe(KeyVisitor& v, powder::AnyBreakage& breakage, const Case& c) {
  SectionReader* in = v.reader();
  if (in != nullptr)
    if (const auto material = material_of(c, in->catalogue())) in->add_defaults(*material);
  describe_model(v, "which hits break a grain", breakage, c, false);
}

void describe(KeyVisitor& v, powder::AnyFragments& fragments, const Case& c) {
  describe_model(v, "sizes of the fragments of a broken grain", fragments, c, false);
}

void describe(KeyVisitor& v, Grinding& g, const Case& c) {
  constexpr Range times{.least = 0, .most = 1e8, .without_least = true};  // three years
  describe_milling_time(v,
                        NumberSpec("time", "s", times, "how long the mill grinds")
                            .with({.label = "milling time", .symbol = "$t$"}),
                        g.time);
  describe_method(v, g);
  describe_smallest(v, g, c);
  describe_per_octave(v, g, powder::tracks_strength(*g.breakage));
  describe_sticking_and_welding(v, g);
}

void read(SectionTables& tables, Case& c, Findings& findings) {
  const Tables t{.capture = tables.table("capture"),
                 .breakage = tables.table("breakage"),
                 .fragments = tables.table("fragments"),
                 .grinding = tables.table("grinding"),
                 .bed_breakage = tables.table("bed_breakage")};
  unused_sections(t, findings);
  Grinding g;
  const auto read_one = [&](const Node* table, const char* name, auto& what, auto... more) {
    SectionReader in(table, name, findings);
    describe(in, what, c, more...);
    in.report_unknown_keys();
  };
  if (t.breakage != nullptr) {
    g.breakage = powder::VogelPeukert{invalid_value, invalid_value};
    read_one(t.breakage, "breakage", *g.breakage);
  }
  if (t.fragments != nullptr) read_one(t.fragments, "fragments", *g.fragments);
  if (t.capture != nullptr) {
    Capture capture{.model = powder::Barrios{invalid_value}};
    read_one(t.capture, "capture", capture, powder::tracks_strength(*g.breakage));
    c.capture = capture;
  }
  if (t.bed_breakage != nullptr) {
    c.bed_breakage.emplace();
    c.bed_breakage->breakage = g.breakage, c.bed_breakage->fragments = g.fragments;
  }
  if (t.grinding == nullptr) return;
  read_one(t.grinding, "grinding", g);
  c.grinding = g;
}

}  // namespace mahlwerk::parts::grinding
