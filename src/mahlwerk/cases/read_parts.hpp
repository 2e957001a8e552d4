// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/section.hpp"

// The sections of a case file, one function each. What cannot be read is left `unread`.
namespace mahlwerk::cases {

/// The catalogue's entry, or nothing after a fault; the fault cites the place of `at`.
std::optional<CatalogueEntry> look_up(const Catalogue& catalogue, std::string_view room,
                                      const Node& at, Findings& findings);

/// What a section says of its model: by `kind` with its own numbers, or by the `model` of the
/// catalogue, whose values are lent to the section. With both, `model` is a mere name.
struct Model {
  std::string name, kind;  ///< `kind` is empty after a fault
  std::optional<CatalogueEntry> entry;
};
Model read_model(Section& in, std::string_view room, const std::vector<std::string>& kinds,
                 const Catalogue& catalogue);

/// The density of what is of a material, from where it is said or from the catalogue. Nothing if
/// neither says.
std::optional<double> read_density(Section& in, const Wanted& wanted, std::string& material,
                                   const Catalogue& catalogue);
/// Moduli, each from where it is said, from the catalogue's material, or steel's.
contact::Elastic read_elastic(Section& in, const std::string& material, const Catalogue& catalogue);
/// Hardness and what heat asks for, likewise.
Substance read_substance(Section& in, const std::string& material, const Catalogue& catalogue);
/// The jar's wall: what it is made of, its density and thickness, likewise.
void read_wall(Section& in, Jar& jar, const Catalogue& catalogue);

Jar unread_jar();  ///< stands for one that could not be read
/// `folder` is where files are looked for.
Jar read_jar(const Node* table, const std::string& folder, const Catalogue& catalogue,
             Findings& findings);
/// A jar of kind "mesh"; its shape stays without a surface after a fault.
void read_mesh(Section& in, Jar& jar, const std::string& folder);
std::vector<BallSet> read_balls(const Node* list, const Jar& jar, const Catalogue& catalogue,
                                Findings& findings);
/// `folder` is where files are looked for; `c` has its gravity, jar and balls already.
Mill read_mill(const Node* table, const Case& c, const std::string& folder,
               const Catalogue& catalogue, Findings& findings);
/// How the sizes of a set's balls spread; false after a fault.
bool read_distribution(Section& in, Distribution& d);
/// `passing`, or `retained`, of up to `most` sieves and the opening that everything passes, as
/// rows of Distribution::passing; empty after a fault.
std::vector<std::array<double, 2>> read_sieves(Section& in, std::int64_t most);
/// The classes that `count` balls make; chooses how many classes where nobody said it.
std::vector<SizeClass> read_classes(Section& in, Distribution& d, std::int64_t count);
/// Into `c`, which has its jar and balls already; grains become its last ball set.
void read_powder(const Node* table, Case& c, const Catalogue& catalogue, Findings& findings);
/// `field` [m/s2] is the strongest of the mill, which contact_time follows from where it is not
/// given.
Contact read_contact(const Node* table, const std::vector<BallSet>& balls, double field,
                     Findings& findings);
/// How a bounce ends; what is not said is that of `all`, or a default where it is null.
contact::BounceRule read_rule(Section& in, const contact::BounceRule* all);
/// The contact model of the soft engine; nothing if its words have a fault.
std::optional<contact::ContactModel> read_contact_model(Section& in);
/// The numbers of touch_fields() of [contact], or of a pair that inherits those of `all`. Silent
/// without a model.
template <class Owner>
void read_touch(Section& in, Owner& owner, const std::optional<contact::ContactModel>& model,
                const Contact* all);
std::vector<PairRule> read_pairs(const Node* list, const Contact& all,
                                 const std::optional<contact::ContactModel>& model,
                                 Findings& findings);
Run read_run(const Node* table, Findings& findings);
Observe read_observe(const Node* table, Findings& findings);
Wear read_wear(const Node* table, Findings& findings);
Heat read_heat(const Node* table, Findings& findings);
/// The sections of grinding; null where left out.
struct GrindingTables {
  const Node *capture, *breakage, *fragments, *grinding;
};
/// Into `c`, which has its powder and heat already.
void read_grinding(const GrindingTables& tables, Case& c, const Catalogue& catalogue,
                   Findings& findings);
/// `c` has its grinding and heat already.
Kinetics read_kinetics(const Node* table, const Case& c, Findings& findings);
/// How long it is milled; unless said, as long as [grinding] or [heat] says.
double read_milling_time(Section& in, const Wanted& wanted, const Case& c);

/// [fit]: dotted keys, each with its two ends as text and its place.
struct DottedLists {
  std::map<std::string, std::vector<std::string>> values;
  std::map<std::string, std::string> places;
};
/// `table` may be null.
DottedLists read_fit(const Node* table, Findings& findings);
/// Keys that vary, or follow from those that do, are put into `places` with where they stand.
Sweep read_sweep(const Node* table, std::map<std::string, std::string>& places, Findings& findings);
Optimise read_optimise(const Node* table, Findings& findings);
Match read_match(const Node* table, Findings& findings);
/// What [fit] asks of a case that was read: keys it has, ranges they may have, and `given` values.
void check_fit(const Case& c, const std::map<std::string, std::string>& places, Findings& findings);

/// A measured motion, its rows checked one by one. Faults cite the file's lines.
kinematics::Tabulated read_motion_file(const std::string& file, const Vec3& axis, const Node& at,
                                       Findings& findings);

/// What the engine does not look at, or nobody asked for, is no assumption of the results.
void keep_what_matters(Case& c);

/// Given starting places outside the jar, in its wall or in each other. For parts that fit
/// otherwise.
void bad_places(const Case& c, std::vector<Fault>& found);

/// Values out of range, for a case that no reader has seen.
std::vector<Fault> bad_values(const Case& c);
/// Of the powder and the sections of grinding, within misfits().
void bad_powder(const Case& c, std::vector<Fault>& found);
void bad_grinding(const Case& c, std::vector<Fault>& found);
/// Faults of parts that were read but do not go together; silent about what is `unread`.
std::vector<Fault> misfits(const Case& c);

double jar_volume(const Jar& jar);                       ///< [m3]
double ball_volume(const BallSet& set);                  ///< [m3] of one ball
double balls_mass(const std::vector<BallSet>& balls);    ///< [kg] of all but grains of powder
double balls_volume(const std::vector<BallSet>& balls);  ///< [m3] of all but grains of powder
std::int64_t balls_count(const std::vector<BallSet>& balls);
double largest_ball(const std::vector<BallSet>& balls);  ///< [m] diameter
/// [m] Diameter, of all but grains of powder; infinite without balls.
double smallest_ball(const std::vector<BallSet>& balls);
/// [rad/s] at which the largest ball is pinned to the wall of a tumbling jar (kin.11).
double critical_speed(const Jar& jar, const std::vector<BallSet>& balls, double gravity);

}  // namespace mahlwerk::cases
