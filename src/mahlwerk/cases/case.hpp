// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/cases/sizes.hpp"
#include "mahlwerk/cases/sweep.hpp"
#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/contact/contact_model.hpp"
#include "mahlwerk/contact/pair_table.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/powder/dose.hpp"
#include "mahlwerk/powder/feed.hpp"

// A case: what a user asks for, complete and in SI, with nothing left to guess.
namespace mahlwerk::cases {

struct Mill {
  std::string model;  ///< name in the catalogue; empty if the case gives its own numbers
  Indirect<kinematics::AnyMotion> motion;
  std::int64_t jars_carried = 1;  ///< all alike; one of them is simulated
  Vec3 jar_axis{0, 0, 1};         ///< unit vector the mounted jar's own z axis points along
  std::string motion_file;        ///< of a tabulated motion, as written; relative to the case file
  bool operator==(const Mill&) const = default;
};

/// Steel, which stands in for what a case does not say.
constexpr contact::ElasticConstants steel{.youngs_modulus = 210e9, .poisson_ratio = 0.3};

/// What wear and heat ask of a material.
struct Substance {
  double hardness = 0;       ///< [1] Vickers number HV > 0
  double conductivity = 0;   ///< [W/(m K)] of heat > 0
  double heat_capacity = 0;  ///< [J/(kg K)] > 0
  bool operator==(const Substance&) const = default;
};

/// 1.4034, the steel of many balls and jars, which stands in for what a case does not say.
constexpr Substance hardened_steel{.hardness = 600, .conductivity = 30, .heat_capacity = 460};
constexpr double hardened_steel_density = 7730;  ///< [kg/m3]
constexpr double default_wall_thickness = 5e-3;  ///< [m] of a small jar

/// Where a jar's mesh came from.
struct MeshFile {
  std::string file;      ///< as written; relative to the case file
  std::string unit;      ///< of its numbers
  bool centred = false;  ///< moved so that the middle of its extent is the jar's origin
  bool operator==(const MeshFile&) const = default;
};

struct Jar {
  std::string model;     ///< name in the catalogue, or empty
  std::string material;  ///< name in the catalogue, or empty
  Indirect<geometry::AnyShape> shape;
  contact::ElasticConstants elastic = steel;
  MeshFile mesh = {};  ///< of a mesh
  Substance substance = hardened_steel;
  double density = hardened_steel_density;  ///< [kg/m3] of its wall
  double wall = default_wall_thickness;     ///< [m] thickness of it
  bool operator==(const Jar&) const = default;
};

/// Balls of one kind: of one material, with one set of rules, in one or more sizes.
struct BallSet {
  std::int64_t count = 1;  ///< of all sizes
  double diameter = 0;     ///< [m] of each, or of the ball of mean volume where sizes differ
  double density = 0;      ///< [kg/m3]
  std::string material;    ///< name in the catalogue, or empty
  contact::ElasticConstants elastic = steel;
  Substance substance = hardened_steel;
  /// [m] where they start, in the jar's own axes about its centre: one for each ball, or none at
  /// all for random places.
  std::vector<Vec3> positions = {};
  Distribution distribution = {};        ///< what the case says of the diameters
  std::vector<SizeClass> classes = {};   ///< what comes of it, smallest first; none: all are equal
  bool grains = false;                   ///< of the powder
  double mass() const;                   ///< [kg] of one ball, the mean where sizes differ
  std::vector<SizeClass> sizes() const;  ///< the classes, or the one size
  bool operator==(const BallSet&) const = default;
};

/// Powder as grains is a ball set, too, the last one.
struct Powder {
  std::string material;
  double mass = 0;                ///< [kg]
  std::optional<double> size;     ///< [m] the median by mass where sizes differ
  std::optional<double> density;  ///< [kg/m3]
  /// [m] of the spheres that stand for the powder; none: it is a mass that nothing touches
  std::optional<double> grain_size = std::nullopt;
  powder::Feed feed = {};  ///< sizes as fed; those of one size unless the case says more
  bool operator==(const Powder&) const = default;
};

/// What happens when bounces become countless and ever smaller.
enum class SustainedContactModel {
  roll,  ///< the ball goes on in lasting contact, rolling or sliding, until the wall lets it go
  tc,    ///< TC rule: a bounce within `contact_time` of the last one is elastic
  none   ///< nothing; the Zeno guard stops the run
};

/// A rule of its own for those who are named: ball sets ("balls.2", "balls"), faces of the jar
/// ("jar.side", "jar"), or whatever is of a material ("steel").
struct PairRule {
  std::array<std::string, 2> between;
  contact::BounceRule rule;
  double rolling_friction = 0;  ///< as in Contact
  double surface_energy = 0;
  double cohesion = 0;
  bool operator==(const PairRule&) const = default;
};

struct Contact {
  contact::ContactModel model;  ///< of the soft engine
  double softening = 1;         ///< of the soft engine: multiplies every Young's modulus
  contact::BounceRule rule;     ///< friction infinite: paper A's constant e_t
  std::vector<PairRule> pairs;  ///< exceptions from `rule`; the last that fits a pair counts
  double lasting_friction = 0;  ///< mu of lasting contacts of the event engine
  double rolling_friction = 0;  ///< [1] mu_r; [s/m] under viscous rolling
  double surface_energy = 0;    ///< [J/m2] gamma of one surface, of the law jkr
  double cohesion = 0;          ///< [J/m3] energy density, of the law sjkr
  SustainedContactModel lasting = SustainedContactModel::roll;
  /// [m/s] a rebound slower than this, pressed to the wall, has come to stay
  double lasting_speed = 0;
  double contact_time = 0;  ///< [s] t_c of the TC rule
  bool operator==(const Contact&) const = default;
};

/// What starting speeds are measured against.
enum class StartFrame {
  laboratory,
  jar  ///< axes that ride with the jar's centre and do not turn
};

/// Instead of a time: go on until a quantity is known well enough.
struct StopCriterion {
  double within = 0;     ///< half-width of its 95 % confidence interval over time, of its mean
  std::string quantity;  ///< "dissipated_power"
  bool operator==(const StopCriterion&) const = default;
};

/// The engine that a case asks for; a run is by one of the first two.
enum class EngineName { event, soft, automatic };
std::string_view name_of(EngineName engine);  ///< "event", "soft", "auto"

struct Run {
  EngineName engine = EngineName::event;
  double time = 0;                                    ///< [s] counted; with `until`: at most
  std::optional<StopCriterion> until = std::nullopt;  ///< ends each replicate sooner
  double settle = 0;                                  ///< [s] before that, not counted
  std::int64_t replicates = 1;
  double start_speed = 0;  ///< [m/s] starting speeds are uniform in 0 ... this
  double start_spin = 0;   ///< [rad/s] starting spins are uniform in 0 ... this
  StartFrame start_frame = StartFrame::laboratory;  ///< of start_speed
  std::optional<double> time_step = std::nullopt;  ///< [s] of the soft engine; none: it chooses one
  double time_step_fraction = 0.125;  ///< of the Rayleigh time, for the step the engine chooses
  bool free_flight_skip = true;       ///< the soft engine's clock hops over free flight
  bool operator==(const Run&) const = default;
};

/// What frames are written for: OVITO and ParaView, or one of them.
enum class FramesFormat { both, xyz, vtk };

struct Observe {
  double threshold = 0;     ///< [m/s] on u_n
  bool collisions = false;  ///< keep every record in collisions.h5
  /// [s] between two frames of the balls that are kept for replay; none: no frames
  std::optional<double> frames = std::nullopt;
  FramesFormat frames_format = FramesFormat::both;
  bool operator==(const Observe&) const = default;
};

/// How wear is reckoned; absent from a case that asks for none.
struct Wear {
  enum class Model {
    archard,  ///< by force and way slid (wea.1)
    finnie    ///< by energy and angle of each impact (wea.4)
  };
  Model model = Model::archard;
  double coefficient = 1e-4;  ///< [1] Archard's K, or Finnie's k
  bool operator==(const Wear&) const = default;
};

/// Where heat goes, and how long the mill mills; absent from a case that asks for no temperatures.
struct Heat {
  double ambient = 293.15;      ///< [K] of the air, and of all at the start
  double milling = 3600;        ///< [s] of one cycle
  double pause = 0;             ///< [s] after it
  std::int64_t cycles = 1;      ///< of milling and pause
  double cooling = 15;          ///< [W/(m2 K)] from the jar's wall to the air
  double ball_exchange = 50;    ///< [W/(m2 K)] from the balls' surface to the jar
  double share_in_balls = 0.5;  ///< [1] of the lost power that heats the balls first
  bool operator==(const Heat&) const = default;
};

/// What collisions catch of the powder; absent from a case that does not ask.
struct Capture {
  enum class Energy { normal, contact_point, lost };  ///< of a collision, that presses the powder
  Indirect<powder::AnyCapture> model;
  static constexpr double all = 1;
  Energy energy = Energy::normal;
  double energy_share = all;  ///< [1] of it that the caught grains get
  bool operator==(const Capture&) const = default;
};

/// How the powder gets finer; absent from a case that does not ask. Needs Capture and Powder.
struct Grinding {
  enum class Method {
    balance,      ///< the expected distribution, by a population balance
    statistical,  ///< a sample of grains, hit by hit
    both
  };
  Indirect<powder::AnyBreakage> breakage;
  Indirect<powder::AnyFragments> fragments;
  Method method = Method::balance;
  double time = 0;  ///< [s] of milling
  powder::Bed bed = powder::Bed::by_size;
  double smallest = 0;                                 ///< [m] finest size that is told apart
  std::int64_t classes_per_octave = 6;                 ///< of size; a multiple of 3
  std::int64_t sample = 10'000;                        ///< grains of the statistical method
  double sticking = 0;                                 ///< [1] share that lies stuck on the wall
  std::optional<double> sticking_size = std::nullopt;  ///< [m] only grains up to this; none: all
  double welding = 0;         ///< [1] chance that a hit that does not break welds two grains
  double welding_energy = 0;  ///< [J/kg] below which nothing welds
  bool operator==(const Grinding&) const = default;
};

/// What a dose of energy does; absent from a case that does not ask.
struct Kinetics {
  enum class Dose { dissipated, captured };  ///< energy that counts
  powder::Conversion conversion;
  Dose dose = Dose::dissipated;
  double time = 0;  ///< [s] of milling
  /// A property that goes from one value to another as conversion does, in its own unit.
  std::string property;  ///< its name; empty: none
  double initial = 0, final = 1;
  bool operator==(const Kinetics&) const = default;
};

/// What `mahlwerk fit` may choose: from the least to the most, as text.
using FitRange = std::array<std::string, 2>;

/// Where one value of a resolved case came from.
struct Origin {
  std::string key;       ///< "mill.amplitude", "balls.1.density"
  std::string value;     ///< as a user would write it
  std::string source;    ///< "case.toml:9", "--set run.time", "catalogue ...: ...", "default: ..."
  bool assumed = false;  ///< a default the user did not choose
  bool unverified = false;  ///< its source is weak
};

/// Its copies are compiled once, in case.cpp: they take a compiler seconds.
struct Case {
  Case();
  Case(const Case&);
  Case(Case&&) noexcept;
  Case& operator=(const Case&);
  Case& operator=(Case&&) noexcept;
  ~Case();

  std::string title;
  std::uint64_t seed = 1;
  Mill mill;
  Jar jar;
  std::vector<BallSet> balls;
  std::optional<Powder> powder;
  Contact contact;
  Run run;
  Observe observe;
  std::optional<Wear> wear;
  std::optional<Heat> heat;
  std::optional<Capture> capture;
  std::optional<Grinding> grinding;
  std::optional<Kinetics> kinetics;
  double gravity = 9.81;  ///< [m/s2], downwards
  Sweep sweep;            ///< what varies from run to run; empty: one run
  std::optional<Optimise> optimise;
  std::optional<Match> match;
  std::map<std::string, FitRange> fit;  ///< dotted key -> what `mahlwerk fit` chooses from

  /// Not compared: the same case may come from elsewhere.
  std::vector<Origin> origins;
  std::string file;  ///< path it was read from, or empty

  bool operator==(const Case& o) const;
};

}  // namespace mahlwerk::cases
