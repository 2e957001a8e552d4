// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [capture], [breakage], [fragments] and [grinding]: what collisions catch and how it breaks.
#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/grinding_fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"
#include "mahlwerk/cases/register.hpp"

namespace mahlwerk::cases {
namespace {

/// A number that only measurements on the powder can tell, or a default.
double constant(Section& in, const Wanted& wanted, const Case& c) {
  if (in.gives(wanted.key) || wanted.standard) return in.value(wanted);
  const std::string powder =
      c.powder && !c.powder->material.empty() ? c.powder->material : "this powder";
  in.missing(wanted.key, wanted.about,
             fmt::format("nothing published is at hand for {}: give it, for instance {} = \"{}\", "
                         "or let `mahlwerk fit` find it from measured sizes",
                         powder, wanted.key, example_of(wanted.unit)));
  return unread;
}

/// A bed breaks as its grains do, where the breakage model knows how.
template <class M>
Wanted wanted(const Field<M>& field, bool remembering) {
  Wanted w(field);
  if (std::is_same_v<M, powder::Barrios> && remembering) {
    w.standard = 0;
    w.source = "that of [breakage], size by size";
  }
  return w;
}

/// A section that chooses a model, into `any`, which stays as it is after an unknown word.
/// `remembering`: the breakage model knows how strong grains are.
template <class... Models>
void read_chosen(Section& in, std::variant<Models...>& any, const Case& c, bool remembering) {
  using Register = std::type_identity<std::variant<Models...>>;
  if (!choose_model(any, in.choice({"model", model_names(Register{}), ""}))) return;
  const auto numbers = [&](auto& model) {
    for (const auto& field : model.fields())
      model.*field.value = constant(in, wanted(field, remembering), c);
  };
  std::visit(numbers, any);
  in.close();
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

void read_breakage(const Node* table, Grinding& g, const Case& c, const Catalogue& catalogue,
                   Findings& findings) {
  Section in(table, "breakage", findings);
  if (const auto material = material_of(c, catalogue)) in.lend(*material);
  g.breakage = powder::VogelPeukert{unread, unread};
  read_chosen(in, g.breakage, c, false);
}

Capture read_capture(const Node* table, const Case& c, bool remembering, Findings& findings) {
  Capture capture;
  Section in(table, "capture", findings);
  capture.model = powder::Barrios{unread};
  capture.energy = word_of<Capture::Energy>(
      in.choice({"energy", capture_energies(), "normal",
                 "what presses along the line of centres; sliding does not"}),
      capture_energies());
  capture.energy_share = in.value(Wanted(energy_share));
  read_chosen(in, capture.model, c, remembering);
  return capture;
}

void read_method(Section& in, Grinding& g) {
  using Method = Grinding::Method;
  g.method = word_of<Method>(
      in.choice({"method", grinding_methods(), "balance", "what is expected, without chance"}),
      grinding_methods());
  if (g.method == Method::balance)
    in.refuse({"sample"}, "under method = \"balance\"",
              "remove it, or write method = \"statistical\" or \"both\"");
  else if (in.gives("sample"))
    g.sample = in.whole("sample", most_sample, least_sample).value_or(g.sample);
  else
    in.note_default("sample", std::to_string(g.sample),
                    "shares are off by 0.5 % at most, by chance");
  g.bed = word_of<powder::Bed>(
      in.choice({"bed", bed_words(), "by-size", "each hit meets grains of one size"}), bed_words());
}

/// The finest size and how many classes there are above it.
void read_classes(Section& in, Grinding& g, const Case& c, bool remembering) {
  if (in.gives("smallest") || !c.powder || !c.powder->size) {
    g.smallest = c.powder && c.powder->size ? in.value(Wanted(smallest_size)) : unread;
  } else {
    g.smallest = c.powder->feed.largest() / octaves_below;
    in.note_default("smallest", show_rounded(g.smallest, "m"), "twelve octaves below the feed");
  }
  if (!in.gives("classes_per_octave")) {
    g.classes_per_octave = remembering ? size_step : 2 * size_step;
    in.note_default("classes_per_octave", std::to_string(g.classes_per_octave),
                    remembering ? "few, as each has many strengths" : "a size every 12 %");
    return;
  }
  const std::int64_t n = in.whole("classes_per_octave", most_per_octave, size_step).value_or(0);
  if (n % size_step != 0)
    in.fault(*in.find("classes_per_octave"),
             fmt::format("classes_per_octave = {} is no multiple of {}", n, size_step),
             "write 3, 6, 9 or 12: half the volume is then a class further down", "out-of-range");
  g.classes_per_octave = n;
}

void read_sticking_and_welding(Section& in, Grinding& g) {
  for (const auto& field : grinding_shares()) g.*field.value = in.value(Wanted(field));
  if (in.gives("sticking"))
    g.sticking_size = in.maybe({"sticking_size", "m", positive, "largest grain size that sticks"});
  else
    in.refuse({"sticking_size"}, "without `sticking`", "remove it, or write sticking = \"10 %\"");
  if (in.gives("welding"))
    g.welding_energy = in.value(Wanted(welding_energy));
  else
    in.refuse({"welding_energy"}, "without `welding`", "remove it, or write welding = 0.01");
}

void read_own(const Node* table, Grinding& g, const Case& c, bool remembering, Findings& findings) {
  Section in(table, "grinding", findings);
  g.time = read_milling_time(in, Wanted(grinding_time), c);
  read_method(in, g);
  read_classes(in, g, c, remembering);
  read_sticking_and_welding(in, g);
  in.close();
}

/// [breakage], [fragments] and [grinding] stand together or not at all.
void lone_sections(const GrindingTables& t, Findings& findings) {
  const auto fault = [&](const Node* at, std::string what, std::string remedy) {
    findings.faults.push_back({at->where, std::move(what), std::move(remedy), "lone-section"});
  };
  const auto part = [&](const Node* table, std::string_view name, std::string_view what,
                        const std::vector<std::string>& models) {
    if (table != nullptr && t.grinding == nullptr)
      fault(table, fmt::format("[{}] stands without [grinding], which alone uses it", name),
            "add [grinding] with time = \"30 s\" or so, or remove it");
    if (table == nullptr && t.grinding != nullptr)
      fault(t.grinding, fmt::format("[grinding] needs [{}]: {}", name, what),
            fmt::format("add [{}] with model = ..., one of {}", name, listed(models)));
  };
  part(t.breakage, "breakage", "which hits break a grain",
       model_names(std::type_identity<powder::AnyBreakage>{}));
  part(t.fragments, "fragments", "into what a grain breaks",
       model_names(std::type_identity<powder::AnyFragments>{}));
}

bool remembers(const powder::AnyBreakage& breakage) {
  return std::visit([](const auto& model) { return model.remembers; }, breakage);
}

}  // namespace

double read_milling_time(Section& in, const Wanted& wanted, const Case& c) {
  if (in.gives(wanted.key)) return in.value(wanted);
  double time = 0;
  std::string_view source;
  if (in.name() != "grinding" && c.grinding) {
    time = c.grinding->time;
    source = "that of [grinding]";
  } else if (c.heat) {
    time = c.heat->milling * static_cast<double>(c.heat->cycles);
    source = "all milling of [heat]";
  } else {
    return in.value(wanted);
  }
  in.note_default(wanted.key, show(time, wanted.unit), source);
  return time;
}

void read_grinding(const GrindingTables& t, Case& c, const Catalogue& catalogue,
                   Findings& findings) {
  lone_sections(t, findings);
  Grinding g;
  if (t.breakage != nullptr) read_breakage(t.breakage, g, c, catalogue, findings);
  if (t.fragments != nullptr) {
    Section in(t.fragments, "fragments", findings);
    read_chosen(in, g.fragments, c, false);
  }
  if (t.capture != nullptr) c.capture = read_capture(t.capture, c, remembers(g.breakage), findings);
  if (t.grinding == nullptr) return;
  read_own(t.grinding, g, c, remembers(g.breakage), findings);
  c.grinding = g;
}

}  // namespace mahlwerk::cases
