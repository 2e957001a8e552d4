// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/cases/ball_shape.hpp"
#include "mahlwerk/cases/bed_breakage.hpp"
#include "mahlwerk/cases/flow.hpp"
#include "mahlwerk/cases/machine_part.hpp"
#include "mahlwerk/cases/material.hpp"
#include "mahlwerk/cases/part_values.hpp"
#include "mahlwerk/cases/run.hpp"
#include "mahlwerk/cases/sizes.hpp"
#include "mahlwerk/cases/sweep.hpp"
#include "mahlwerk/cases/uncertainty.hpp"
#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/contact/contact_model.hpp"
#include "mahlwerk/contact/lubrication.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/kinematics/drive.hpp"
#include "mahlwerk/kinematics/speed_program.hpp"
#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/powder/feed.hpp"
#include "mahlwerk/scene/ball_layers.hpp"

// A case: complete description of a run in SI units, with all defaults filled in.
namespace mahlwerk::cases {

struct Mill {
  std::string model;  ///< name in the catalogue; empty if the case gives its own numbers
  Indirect<kinematics::AnyMotion> motion;
  std::int64_t jars_carried = 1;  ///< identical jars; one of them is simulated
  Vec3 jar_axis{0, 0, 1};         ///< unit vector along the z axis of the mounted jar
  std::string motion_file;        ///< of a tabulated motion, as written; relative to the case file
  double tilt = 0;                ///< [rad] of the whole mill about its y axis; its x axis rises
  kinematics::SpeedProgram speed_over_time;  ///< empty: its speed is constant
  bool operator==(const Mill&) const = default;
};

constexpr double default_wall_thickness = 5e-3;  ///< [m] of a small jar

/// Source of a jar's mesh.
struct MeshFile {
  std::string file;  ///< as written; relative to the case file
  std::string unit;  ///< unit of the coordinates in the file
  bool centred =
      false;  ///< whether the mesh is moved so that the middle of its extent is the origin
  bool operator==(const MeshFile&) const = default;
};

struct Jar {
  std::string model;     ///< name in the catalogue, or empty
  std::string material;  ///< name in the catalogue, or empty
  Indirect<geometry::AnyShape> shape;
  contact::ElasticConstants elastic = steel;
  MeshFile mesh = {};  ///< only for a jar of kind "mesh"
  Substance substance = hardened_steel;
  double density = hardened_steel_density;  ///< [kg/m3] of its wall
  double wall = default_wall_thickness;     ///< [m] thickness of its wall
  /// [m] of the whole mill of which a jar that is periodic along its axis is a slice; none: unknown
  std::optional<double> mill_length = std::nullopt;
  bool operator==(const Jar&) const = default;
};

/// Balls of one material with one set of bounce rules, in one or more sizes.
struct BallSet {
  std::int64_t count = 1;  ///< number of balls of all sizes
  /// [m] of each ball; with a distribution, of the ball of mean volume; of a body, of the sphere of
  /// its volume
  double diameter = 0;
  double density = 0;    ///< [kg/m3] of its material
  std::string material;  ///< name in the catalogue, or empty
  contact::ElasticConstants elastic = steel;
  Substance substance = hardened_steel;
  /// [m] initial positions in the jar's own axes, relative to its centre: one for each ball, or
  /// none for random positions.
  std::vector<Vec3> positions = {};
  /// [m/s] initial velocities relative to Run::start_frame and [rad/s] initial spins, along the
  /// jar's own axes: one for each of `positions`, or none for random ones.
  std::vector<Vec3> velocities = {}, spins = {};
  Distribution distribution = {};       ///< distribution of the diameters
  std::vector<SizeClass> classes = {};  ///< its size classes, smallest first; none: equal balls
  bool grains = false;                  ///< whether the balls are grains of the powder
  /// [m] of the shell of hollow balls, made of `density`; none: solid
  std::optional<double> wall_thickness = std::nullopt;
  /// [m] of a layer of another density around it; none: no coating
  std::optional<double> coating_thickness = std::nullopt;
  std::optional<double> coating_density = std::nullopt;  ///< [kg/m3]
  BallShape body = {};                                   ///< shape of the balls
  scene::BallLayers layers() const;                      ///< of one ball
  scene::BodyShape shape() const;                        ///< of one ball; a sphere has none
  double inertia_ratio(double diameter) const;  ///< Ball::inertia_ratio of a ball of `diameter` [m]
  /// [1] Diameter of the sphere that holds a ball over the diameter of the sphere of its volume.
  double reach() const;
  double surface_density() const;        ///< [kg/m3] of the coating, or of an uncoated ball
  double mass() const;                   ///< [kg] of one ball; with a distribution, the mean
  std::vector<SizeClass> sizes() const;  ///< the classes, or one class of equal balls
  bool operator==(const BallSet&) const = default;
};

/// The powder. Powder that is simulated as grains is also the last ball set.
struct Powder {
  std::string material;
  double mass = 0;                ///< [kg]
  std::optional<double> size;     ///< [m] with a size distribution, the median by mass
  std::optional<double> density;  ///< [kg/m3]
  /// [m] diameter of the spheres that represent the powder; none: the powder is only a mass and is
  /// not simulated
  std::optional<double> grain_size = std::nullopt;
  powder::Feed feed = {};  ///< initial size distribution; by default one size
  bool operator==(const Powder&) const = default;
};

/// Treatment of inelastic collapse: infinitely many bounces in a finite time.
enum class SustainedContactModel {
  roll,  ///< sustained contact: the ball rolls or slides on the wall until it detaches
  tc,    ///< TC rule: a bounce within `contact_time` of the last one is elastic
  none   ///< no treatment; the Zeno guard stops the run
};

/// A contact rule for the pairs that two names select: ball sets ("balls.2", "balls"), faces of the
/// jar ("jar.side", "jar"), parts ("parts.stirrer", "parts"), or all bodies of a material
/// ("steel").
struct PairRule {
  std::array<std::string, 2> between;
  contact::BounceRule rule;
  double rolling_friction = 0;  ///< as in Contact
  double surface_energy = 0;
  double cohesion = 0;
  double surface_tension = 0;
  bool operator==(const PairRule&) const = default;
};

struct Contact {
  contact::ContactModel model;  ///< of the soft engine
  double softening = 1;         ///< of the soft engine: factor on every Young's modulus
  contact::BounceRule rule;     ///< infinite friction: the constant e_t of Chen et al. 2016
  std::vector<PairRule> pairs;  ///< exceptions from `rule`; the last one that matches a pair counts
  double lasting_friction = 0;  ///< mu of sustained contacts of the event engine
  double rolling_friction = 0;  ///< [1] mu_r; [s/m] with viscous rolling resistance
  double surface_energy = 0;    ///< [J/m2] gamma of one surface, for the law jkr
  double cohesion = 0;          ///< [J/m3] energy density, for the law sjkr
  double surface_tension = 0;   ///< [N/m] of the liquid, for the law capillary
  SustainedContactModel lasting = SustainedContactModel::roll;
  /// [m/s] a ball that is pressed to the wall and rebounds slower enters a sustained contact
  double lasting_speed = 0;
  double contact_time = 0;  ///< [s] t_c of the TC rule
  bool operator==(const Contact&) const = default;
};

struct DrawnSections {
  Mill mill;
  Contact contact;
};

/// Liquid in the jar; absent from a case without [liquid]: a dry mill.
struct Liquid {
  std::string material;   ///< name in the catalogue, or empty
  contact::Liquid model;  ///< viscosity, density and extent
  bool operator==(const Liquid&) const = default;
};

/// File format of the frames: extended XYZ for OVITO, VTK for ParaView, or both.
enum class FramesFormat { both, xyz, vtk };

struct Observe {
  double threshold = 0;      ///< [m/s] normal speed u_n above which collisions are counted apart
  bool collisions = false;   ///< whether every collision is recorded in collisions.h5
  bool final_state = false;  ///< whether the balls at the end are written, for Run::start_from
  /// [s] between two frames of the balls for replay; none: no frames
  std::optional<double> frames = std::nullopt;
  FramesFormat frames_format = FramesFormat::both;
  bool operator==(const Observe&) const = default;
};

/// Milling time, beyond the simulated time; absent from a case without [milling].
struct MillingTime {
  std::optional<double> time = std::nullopt;  ///< [s] without pauses; none: see milling_time()
  double dose = 1e6;                          ///< [J/kg] of powder, whose milling time is computed
  bool reverse = false;  ///< whether the sense of rotation changes after each cycle
  bool operator==(const MillingTime&) const = default;
};

/// Heat transfer and milling cycles; absent from a case without [heat].
struct Heat {
  double ambient = 293.15;    ///< [K] of the air, and of all parts at the start
  double milling = 3600;      ///< [s] milling time of one cycle
  double pause = 0;           ///< [s] pause at the end of each cycle
  std::int64_t cycles = 1;    ///< of milling and pause
  double cooling = 15;        ///< [W/(m2 K)] from the jar's wall to the air
  double ball_exchange = 50;  ///< [W/(m2 K)] from the balls' surface to the jar
  /// [1] of the lost power that heats the balls first; none: by the collisions (hea.12)
  std::optional<double> share_in_balls = std::nullopt;
  bool operator==(const Heat&) const = default;
};

/// Capture of powder by collisions; absent from a case without [capture].
struct Capture {
  enum class Energy { normal, contact_point, lost };  ///< energy of a collision, acting on powder
  Indirect<powder::AnyCapture> model;
  static constexpr double all = 1;
  Energy energy = Energy::normal;
  double energy_share = all;  ///< [1] share of this energy that the captured grains receive
  bool operator==(const Capture&) const = default;
};

/// Comminution of the powder; absent from a case without [grinding]. Needs Capture and Powder.
struct Grinding {
  enum class Method {
    balance,      ///< expected size distribution, by a population balance
    statistical,  ///< random sample of grains, hit by hit
    both
  };
  Indirect<powder::AnyBreakage> breakage;
  Indirect<powder::AnyFragments> fragments;
  Method method = Method::balance;
  double time = 0;  ///< [s] of milling
  powder::Bed bed = powder::Bed::by_size;
  double smallest = 0;                                 ///< [m] finest size that is resolved
  std::int64_t classes_per_octave = 6;                 ///< size classes; a multiple of 3
  std::int64_t sample = 10'000;                        ///< grains of the statistical method
  double sticking = 0;                                 ///< [1] share that sticks to the wall
  std::optional<double> sticking_size = std::nullopt;  ///< [m] largest that sticks; none: all
  double welding = 0;         ///< [1] probability that a hit without breakage welds two grains
  double welding_energy = 0;  ///< [J/kg] least specific energy for welding
  bool operator==(const Grinding&) const = default;
};

/// Kinetics of a reaction of the powder; absent from a case without [kinetics].
struct Kinetics {
  enum class Dose { dissipated, captured };  ///< energy that counts as dose
  enum class TemperatureOf { balls, jar };   ///< node of [heat] whose temperature the powder has
  Indirect<powder::AnyKinetics> model;
  Dose dose = Dose::dissipated;
  double time = 0;  ///< [s] of milling
  /// Name of a property that changes from `initial` to `final`, in its own unit, in proportion to
  /// the conversion; empty: none.
  std::string property;
  double initial = 0, final = 1;
  std::optional<double> molar_mass = std::nullopt;    ///< [kg/mol] of the powder, for doses by mole
  std::optional<double> mass_per_hit = std::nullopt;  ///< [kg] captured by a hit, without [capture]
  Capture::Energy hit_energy = Capture::Energy::normal;  ///< of a hit, without [capture]
  std::optional<double> temperature = std::nullopt;      ///< [K] constant; none: by [heat]
  TemperatureOf temperature_of = TemperatureOf::balls;
  bool operator==(const Kinetics&) const = default;
};

/// [m/s2] Gravity in the axes of a mill that is tilted about its y axis.
Vec3 gravity_in_mill(double gravity, const Vec3& direction, double tilt);

/// Range searched by `mahlwerk fit`: least and largest value, as text.
using FitRange = std::array<std::string, 2>;

/// Source of one value of a resolved case.
struct Origin {
  std::string key;       ///< "mill.amplitude", "balls.1.density"
  std::string value;     ///< as written in a case file
  std::string source;    ///< "case.toml:9", "--set run.time", "catalogue ...: ...", "default: ..."
  bool assumed = false;  ///< a default that the user did not choose
  bool unverified = false;  ///< the source in the catalogue is weak
  /// Plausible range of an assumed value, as written in a case; empty: not known.
  std::array<std::string, 2> range = {};
};

/// A resolved case. The copy operations are defined in case.cpp to save compile time.
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
  std::vector<MachinePart> machine_parts;  ///< in the jar, beside the balls
  std::vector<BallSet> balls;
  std::optional<Powder> powder;
  Contact contact;
  std::optional<Liquid> liquid;
  std::optional<Flow> flow;
  std::optional<BedBreakage> bed_breakage;
  std::optional<kinematics::Motor> drive;  ///< absent: the mill has its speed
  Run run;
  Observe observe;
  std::optional<MillingTime> milling;
  std::optional<Heat> heat;
  std::optional<Capture> capture;
  std::optional<Grinding> grinding;
  std::optional<Kinetics> kinetics;
  PartValues parts;                  ///< sections that only parts read: [wear], sensors
  double gravity = 9.81;             ///< [m/s2]
  Vec3 gravity_direction{0, 0, -1};  ///< unit vector, in the axes of a mill without tilt
  Sweep sweep;                       ///< keys that vary from run to run; empty: one run
  std::optional<Optimise> optimise;
  std::optional<Match> match;
  std::optional<Uncertainty> uncertainty;  ///< keys with a scatter of values
  std::map<std::string, FitRange> fit;     ///< dotted key -> range searched by `mahlwerk fit`

  /// [m/s2] Gravity in the axes of the mill.
  Vec3 gravity_vector() const;

  // operator== ignores these: equal cases may come from different files.
  std::vector<Origin> origins;  ///< source of each value
  Notices remarks;              ///< what the reader of the file noticed
  std::string file;             ///< path of the case file, or empty

  bool operator==(const Case& o) const;
};

}  // namespace mahlwerk::cases
