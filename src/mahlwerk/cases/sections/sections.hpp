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

// The sections of a case. One function `describe` for each calls a visitor for every key with its
// value. Values that cannot be read become `invalid_value`.
namespace mahlwerk::cases {

using contact::ContactModel;
class Writer;

/// All sections except those about many runs, in the order in which they are written. Reading a
/// case does not use this function, because some sections must be read before others.
void describe(CaseVisitor& v, Case& c);

/// The keys of the sections about many runs: [sweep], [optimise], [match], [fit] and [uncertainty].
/// Only for visitors that list keys; such sections are read and written by functions of their own.
void describe_many_runs(CaseVisitor& v);

void describe_gravity_direction(KeyVisitor& v, Vec3& direction);
void describe(KeyVisitor& v, Jar& jar);
void describe(KeyVisitor& v, MachinePart& part);
void describe(KeyVisitor& v, BallSet& set, const Jar& jar);
/// Requires `c` with gravity, jar and balls.
void describe(KeyVisitor& v, Mill& mill, const Case& c);
void describe_speed_over_time(KeyVisitor& v, Mill& mill);
/// A reader appends grains to `balls`.
void describe(KeyVisitor& v, Powder& powder, std::vector<BallSet>& balls, const Jar& jar);
/// [contact] without its pairs. Returns the contact model, or null if it could not be read.
const ContactModel* describe(KeyVisitor& v, Contact& contact, const Case& c);
void describe(KeyVisitor& v, PairRule& pair, const Contact& all, const ContactModel* model);
void describe(KeyVisitor& v, Liquid& liquid);
void describe(KeyVisitor& v, Run& run);
void describe(KeyVisitor& v, Observe& observe);
void describe(KeyVisitor& v, MillingTime& milling);

/// Source of the defaults of [[contact.pairs]].
constexpr std::string_view of_contact = "as in [contact]";

// Parts of sections.

/// The contact model of the soft engine; false after an unknown word.
bool describe(KeyVisitor& v, ContactModel& model);
/// Whether rolling_damping or one of touch_fields() has a meaning for the model (null: unknown). A
/// reader reports a fault for a given key without meaning.
bool has_use(KeyVisitor& v, std::string_view key, const ContactModel* model);
/// A bounce rule. Keys that are not given are taken from `all`; if `all` is null they have
/// defaults.
void describe(KeyVisitor& v, contact::BounceRule& rule, const contact::BounceRule* all);
/// The size distribution of a ball set, or its diameter; false after a fault.
bool describe(KeyVisitor& v, Distribution& d, double& diameter);
/// The shape of a ball set; a reader sets the diameter of the sphere of the same volume. False for
/// spheres.
bool describe_body(KeyVisitor& v, BallShape& body, double& diameter);
/// The size classes of `count` balls. Chooses the number of classes if it is not given.
std::vector<SizeClass> read_classes(SectionReader& in, Distribution& d, std::int64_t count);
using Sieves = std::vector<std::array<double, 2>>;  ///< as Distribution::passing
/// `passing` or `retained` of a sieve analysis, up to `most` + 1 rows: the last opening passes all
/// mass. Empty after a fault.
void describe_sieves(KeyVisitor& v, Sieves& rows, std::int64_t most);
/// Milling time of [grinding] or [kinetics]; by default that of another section.
void describe_milling_time(KeyVisitor& v, NumberSpec spec, double& time);

/// Given values, else those of the catalogue's material, else those of steel.
void describe(KeyVisitor& v, contact::ElasticConstants& elastic, const std::string& material);
void describe(KeyVisitor& v, Substance& substance, const std::string& material);
/// The jar's wall: properties of its material, and its thickness.
void describe_wall(KeyVisitor& v, Jar& jar);
/// The density, given or from the material in the catalogue; no value if neither gives it. Sets
/// `material` to the given name.
std::optional<double> read_density(SectionReader& in, const NumberSpec& spec,
                                   std::string& material);
/// A number that the material in the catalogue may give, by the rules of read_density().
std::optional<double> read_of_material(SectionReader& in, const NumberSpec& spec,
                                       std::string& material);
/// The mesh of a jar of kind "mesh". After a fault the shape has no surface.
void describe_mesh(KeyVisitor& v, Jar& jar);
/// The states of run.start_from: `file` relative to the case file. `states` is null after a fault.
StartStates read_start_states(const std::string& file, const Node& at, Findings& findings);
/// Reads a file with a measured motion. Faults cite the file's lines. With `lean` the table may
/// have three angles: `lean` gets those about x and y as coordinates.
kinematics::Tabulated read_motion_file(const std::string& file, const Vec3& axis, const Node& at,
                                       Findings& findings, kinematics::Tabulated* lean = nullptr);

/// The catalogue entry called `name`; no value after a fault, which cites `at`.
std::optional<CatalogueEntry> find_entry(SectionReader& in, std::string_view category,
                                         const std::string& name, const Node& at);
/// The model of a section: `kind` with numbers in the section, or `model` with the values of a
/// catalogue entry as defaults. With both, `model` is only a name.
struct Model {
  std::string name, kind;  ///< `kind` is empty after a fault
  std::optional<CatalogueEntry> entry;
};
Model read_model(SectionReader& in, std::string_view category,
                 const std::vector<std::string>& kinds);
/// Visits the kind of `any` and its `name` in the catalogue. A reader sets `model`. False after a
/// fault.
template <class... Models>
bool describe_kind(KeyVisitor& v, std::string_view category, std::string_view about,
                   std::variant<Models...>& any, std::string& name, Model& model) {
  if (SectionReader* in = v.reader()) {
    model = read_model(*in, category, model_names(std::type_identity<std::variant<Models...>>{}));
    name = model.name;
    return choose_model(any, model.kind);
  }
  const bool known = v.model({.key = "kind", .words = {}, .standard = "", .about = about}, any);
  v.text({.key = "model",
          .about = "name of an entry of the catalogue, which gives the kind and its numbers",
          .instead = "kind",
          .category = category},
         name);
  return known;
}

// Readers of sections that need more than a description.

Jar invalid_jar();  ///< stands for a jar with faults, so that other sections are still checked
std::vector<BallSet> read_balls(const Node* list, const Jar& jar, Findings& findings);
std::vector<MachinePart> read_machine_parts(const Node* list, Findings& findings);
Contact read_contact(const Node* table, const Case& c, Findings& findings);
/// A node that is a whole number from 1; no value otherwise.
std::optional<double> whole_number(const Node& node);
/// The milling time that the sections of a case state together: a fault if they differ.
void find_milling_time(const Node& root, Findings& findings);

// Sections about many runs.

/// [fit]: dotted keys, each with the two ends of its range as text, and its location.
struct DottedLists {
  std::map<std::string, std::vector<std::string>> values;
  std::map<std::string, std::string> locations;
};
/// `table` may be null.
DottedLists read_fit(const Node* table, Findings& findings);
/// Checks [fit] against a case that was read: the keys exist, the ranges are valid, and every key
/// has a value.
void check_fit(const Case& c, const std::map<std::string, std::string>& locations,
               Findings& findings);
/// Adds the keys that vary, and the keys with a formula, to `locations` with their place in the
/// file.
Sweep read_sweep(const Node* table, std::map<std::string, std::string>& locations,
                 Findings& findings);
Optimise read_optimise(const Node* table, Findings& findings);
Match read_match(const Node* table, Findings& findings);
void list_sweep_keys(KeyVisitor& v);
void list_optimise_keys(KeyVisitor& v);
void list_match_keys(KeyVisitor& v);
void list_fit_keys(KeyVisitor& v);
/// Leaves Uncertainty::sections empty. `table` must not be null.
Uncertainty read_uncertainty(const Node* table, Findings& findings);
void list_uncertainty_keys(KeyVisitor& v);
void write(Writer& out, const std::map<std::string, FitRange>& fit);
void write(Writer& out, const Sweep& sweep);
void write(Writer& out, const Optimise& search);
void write(Writer& out, const Match& search);
void write(Writer& out, const Uncertainty& uncertainty);

}  // namespace mahlwerk::cases
