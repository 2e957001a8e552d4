// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/kinematics/tabulated.hpp"

// The sections of a case, one function each: it names the section's keys with their values to a
// visitor. What cannot be read is left `invalid_value`.
namespace mahlwerk::cases {

using contact::ContactModel;
class Writer;

/// Of all sections but those about many runs, in the order in which they are written. A case is
/// read section by section instead: some follow from others.
void describe(CaseVisitor& v, Case& c);

void describe(KeyVisitor& v, Jar& jar);
void describe(KeyVisitor& v, BallSet& set, const Jar& jar);
/// `c` has its gravity, jar and balls already.
void describe(KeyVisitor& v, Mill& mill, const Case& c);
/// Grains become the last of `balls` where they are read.
void describe(KeyVisitor& v, Powder& powder, std::vector<BallSet>& balls, const Jar& jar);
/// Without its pairs. The model, or null where that could not be read.
const ContactModel* describe(KeyVisitor& v, Contact& contact, const Case& c);
void describe(KeyVisitor& v, PairRule& pair, const Contact& all, const ContactModel* model);
void describe(KeyVisitor& v, Run& run);
void describe(KeyVisitor& v, Observe& observe);
void describe(KeyVisitor& v, Wear& wear);
void describe(KeyVisitor& v, Heat& heat);
/// Of the sections of grinding; `c` has its powder and heat already. `remembering`: the breakage
/// model knows how strong grains are.
void describe(KeyVisitor& v, Capture& capture, const Case& c, bool remembering);
void describe(KeyVisitor& v, powder::AnyBreakage& breakage, const Case& c);
void describe(KeyVisitor& v, powder::AnyFragments& fragments, const Case& c);
void describe(KeyVisitor& v, Grinding& g, const Case& c);
/// `c` has its grinding and heat already.
void describe(KeyVisitor& v, Kinetics& k, const Case& c);

// Parts of sections.

/// The contact model of the soft engine; false after a fault of its words.
bool describe(KeyVisitor& v, ContactModel& model);
/// Whether rolling_damping or one of touch_fields() says anything under the model, null if that is
/// not known; a fault where it is read and does not.
bool has_use(KeyVisitor& v, std::string_view key, const ContactModel* model);
/// How a bounce ends; what is not said is that of `all`, or a default where it is null.
void describe(KeyVisitor& v, contact::BounceRule& rule, const contact::BounceRule* all);
/// How the sizes of a set's balls spread, or their one diameter; false after a fault.
bool describe(KeyVisitor& v, Distribution& d, double& diameter);
/// The classes that `count` balls make; chooses how many classes where nobody said it.
std::vector<SizeClass> read_classes(SectionReader& in, Distribution& d, std::int64_t count);
using Sieves = std::vector<std::array<double, 2>>;  ///< as Distribution::passing
/// `passing`, or `retained`, of up to `most` sieves and the opening that everything passes; empty
/// after a fault.
void describe_sieves(KeyVisitor& v, Sieves& rows, std::int64_t most);
/// How long it is milled; unless said, as long as [grinding] or [heat] says.
void describe_milling_time(KeyVisitor& v, NumberSpec spec, double& time, const Case& c,
                           bool of_grinding);

/// From where they are said, from the catalogue's material, or steel's.
void describe(KeyVisitor& v, contact::ElasticConstants& elastic, const std::string& material);
void describe(KeyVisitor& v, Substance& substance, const std::string& material);
/// The jar's wall: moduli, density and the like of its material, and its thickness.
void describe_wall(KeyVisitor& v, Jar& jar);
/// The density of what is of a material, from where it is said or from the catalogue. Nothing if
/// neither says.
std::optional<double> read_density(SectionReader& in, const NumberSpec& spec,
                                   std::string& material);
/// Of a jar of kind "mesh"; its shape stays without a surface after a fault.
void describe_mesh(KeyVisitor& v, Jar& jar);
/// A measured motion, its rows checked one by one. Faults cite the file's lines.
kinematics::Tabulated read_motion_file(const std::string& file, const Vec3& axis, const Node& at,
                                       Findings& findings);

/// The catalogue's entry, or nothing after a fault; the fault cites the place of `at`.
std::optional<CatalogueEntry> find_entry(SectionReader& in, std::string_view category,
                                         const Node& at);
/// What a section says of its model: by `kind` with its own numbers, or by the `model` of the
/// catalogue, whose values are lent to the section. With both, `model` is a mere name.
struct Model {
  std::string name, kind;  ///< `kind` is empty after a fault
  std::optional<CatalogueEntry> entry;
};
Model read_model(SectionReader& in, std::string_view category,
                 const std::vector<std::string>& kinds);
/// `any` of its kind, and `name` in the catalogue; `model` of what was read. False after a fault.
template <class... Models>
bool describe_kind(KeyVisitor& v, std::string_view category, std::variant<Models...>& any,
                   std::string& name, Model& model) {
  if (SectionReader* in = v.reader()) {
    model = read_model(*in, category, model_names(std::type_identity<std::variant<Models...>>{}));
    name = model.name;
    return choose_model(any, model.kind);
  }
  const bool known = v.model("kind", any);
  v.text("model", name);
  return known;
}

// Reading of whole sections, where there is more to it than a description.

Jar placeholder_jar();  ///< stands for one that could not be read
std::vector<BallSet> read_balls(const Node* list, const Jar& jar, Findings& findings);
Contact read_contact(const Node* table, const Case& c, Findings& findings);
/// The sections of grinding; null where left out.
struct GrindingTables {
  const Node *capture, *breakage, *fragments, *grinding;
};
void read_grinding(const GrindingTables& tables, Case& c, Findings& findings);

// Sections about many runs.

/// [fit]: dotted keys, each with its two ends as text and its place.
struct DottedLists {
  std::map<std::string, std::vector<std::string>> values;
  std::map<std::string, std::string> locations;
};
/// `table` may be null.
DottedLists read_fit(const Node* table, Findings& findings);
/// What [fit] asks of a case that was read: keys it has, ranges they may have, and `given` values.
void check_fit(const Case& c, const std::map<std::string, std::string>& locations,
               Findings& findings);
/// Keys that vary, or follow from those that do, are put into `locations` with where they stand.
Sweep read_sweep(const Node* table, std::map<std::string, std::string>& locations,
                 Findings& findings);
Optimise read_optimise(const Node* table, Findings& findings);
Match read_match(const Node* table, Findings& findings);
void write(Writer& out, const std::map<std::string, FitRange>& fit);
void write(Writer& out, const Sweep& sweep);
void write(Writer& out, const Optimise& search);
void write(Writer& out, const Match& search);

}  // namespace mahlwerk::cases
