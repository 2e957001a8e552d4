// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/flow.hpp"
#include "mahlwerk/cases/mill_power.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::cases {
namespace {

using kinematics::Planetary;
using kinematics::Still;
using kinematics::Tumbling;

/// Largest value of `of(t)` over a period; of(0) for an infinite period. The samples include a
/// quarter of the period and thus the peak of a sine.
template <class M, class Of>
double largest(const M& motion, Of of) {
  constexpr int samples = 4096;
  const double period = motion.period();
  if (!std::isfinite(period)) return of(0.0);
  double most = 0;
  for (int i = 0; i < samples; ++i) most = std::max(most, of(period * i / samples));
  return most;
}

double jar_radius(const Jar& jar) {
  return geometry::radius_about_axis(*jar.shape);
}
bool axisymmetric(const Jar& jar) {
  return geometry::axisymmetric(*jar.shape);
}
double jar_reach(const Jar& jar) {
  return geometry::reach(*jar.shape);
}

class Derivation {
 public:
  explicit Derivation(const Case& c) : c_(c) {
    largest_ = *std::ranges::max_element(
        c.balls, {}, [](const BallSet& set) { return set.grains ? 0 : largest_ball({set}); });
    const double widest = largest_ball({largest_});
    if (largest_.body.is_sphere()) largest_.diameter = widest;
    largest_.classes.clear();
    arm_ = jar_radius(c.jar) - 0.5 * widest;
  }

  std::vector<DerivedQuantity> all() {
    std::visit([&](const auto& motion) { speeds(motion); }, *c_.mill.motion);
    std::visit([&](const auto& motion) { special(motion); }, *c_.mill.motion);
    charge();
    for (std::size_t i = 0; i < c_.balls.size(); ++i) body(i);
    return std::move(found_);
  }

 private:
  void add(std::string name, double value, std::string unit, std::string about) {
    found_.push_back({std::move(name), value, std::move(unit), std::move(about)});
  }

  template <class M>
  void speeds(const M& motion) {
    const auto wall_speed = [&](double t) {  // (kin.9)
      const Vec3 axis = motion.rotation(t) * c_.mill.jar_axis;
      const Vec3 spin = motion.spin(t);
      const bool about_axis = axisymmetric(c_.jar) && norm(cross(spin, axis)) <= 1e-12 * norm(spin);
      const double reach = about_axis ? jar_radius(c_.jar) : jar_reach(c_.jar);
      return norm(motion.frame_motion(t).velocity) + norm(spin) * reach;
    };
    peak_ = largest(motion, wall_speed) + geometry::rotor_tip_speed(*c_.jar.shape);
    add("peak_wall_speed", peak_, "m/s",
        "upper bound of the speed of the jar's wall: speed of the centre plus that of rotation "
        "(kin.9)");
    if (!c_.machine_parts.empty())
      add("peak_part_speed", part_speed(c_), "m/s",
          "upper bound of the speed of the parts in the jar, in their frame (kin.22)");
    const double pull =
        largest(motion, [&](double t) { return norm(motion.frame_motion(t).acceleration); });
    if (c_.gravity > 0)
      add("acceleration_number", pull / c_.gravity, "",
          "largest acceleration of the jar's centre over gravity (kin.10)");
  }

  /// Shaken mills: kinetic energy of a ball that moves as fast as the wall.
  template <class M>
  void special(const M&) {
    if constexpr (!std::is_same_v<M, Still>)
      add("expected_impact_energy", 0.5 * largest_.mass() * peak_ * peak_, "J",
          "kinetic energy of the largest ball at the peak wall speed (kin.15)");
  }

  void special(const Tumbling& tumbler) {
    if (drum_motion(c_) == nullptr) {
      add("tumbling_speed", std::abs(tumbler.speed) * 30 / std::numbers::pi, "rpm",
          "turns of the jar end over end");
      return;
    }
    const double critical = critical_speed(c_.jar, c_.balls, across_axis(c_.gravity_vector()));
    add("drum_speed", std::abs(tumbler.speed) * 30 / std::numbers::pi, "rpm",
        "speed of the drum" + state_of_speed());
    add("critical_speed", critical * 30 / std::numbers::pi, "rpm",
        "speed that pins the largest ball to the wall of the drum (kin.11)");
    if (critical > 0)
      add("percent_of_critical", 100 * std::abs(tumbler.speed) / critical, "%",
          fmt::format("speed of the drum{} over the critical speed (kin.11)", state_of_speed()));
    add("expected_impact_energy", largest_.mass() * c_.gravity * 2 * arm_, "J",
        "energy of the largest ball falling through the drum's diameter less its own (kin.17)");
    if (const auto mill = mill_numbers(c_)) powers(*mill);
  }

  void powers(const MillNumbers& mill) {
    if (bond_range.has(mill))
      add("bond_power", bond_power(mill, balls_mass(sets_at_start(c_))), "W",
          "power at the shell by Bond's formula (mil.1)" + state_of_speed());
    if (hogg_fuerstenau_range.has(mill))
      add("hogg_fuerstenau_power", hogg_fuerstenau_power(mill, usual_lift_angle), "W",
          "net power by Hogg and Fuerstenau, lift angle 35 degrees (mil.2)" + state_of_speed());
    if (!morrell_range.has(mill)) return;
    add("morrell_power", morrell_losses * morrell_charge(mill).power, "W",
        "power of the charge by Morrell's C model, times 1.26 (mil.7)" + state_of_speed());
    add("morrell_no_load_power", morrell_no_load_power(mill), "W",
        "power of the empty mill by Morrell (mil.8)" + state_of_speed());
  }
  /// Which speed it is, if the mill will not have it throughout.
  std::string state_of_speed() const {
    if (!speed_varies(c_)) return "";
    return c_.drive ? ", without load" : ", at full speed";
  }

  void special(const Planetary& mill) {
    const double jar_spin = mill.jar_spin(), disc = mill.speed;
    add("speed_ratio_relative", mill.ratio, "",
        "jar speed relative to the disc over disc speed (kin.12)");
    add("speed_ratio_absolute", 1 + mill.ratio, "",
        "jar speed in the laboratory over disc speed (kin.12)");
    add("critical_speed_ratio", 1 + std::sqrt(mill.orbit_radius / arm_), "",
        "magnitude of the relative speed ratio that pins the largest ball, jar against disc "
        "(kin.13)");
    if (const double mu = c_.contact.rule.friction; std::isfinite(mu) && mu > 0)
      add("critical_speed_ratio_with_friction",
          1 + std::sqrt(mill.orbit_radius / arm_ * std::sqrt(1 + 1 / (mu * mu))), "",
          "the same for a ball that the friction of the wall must carry along; between both ratios "
          "the ball slips or is thrown (kin.18)");
    if (c_.gravity > 0)
      add("relative_centrifugal_acceleration", disc * disc * mill.orbit_radius / c_.gravity, "",
          "centrifugal acceleration of the disc over gravity: the makers' g figure (kin.14)");
    const bool pinned = jar_spin * jar_spin * arm_ >= disc * disc * mill.orbit_radius;
    const double energy =  // (kin.16)
        std::abs(jar_spin * jar_spin * jar_spin * arm_ / disc +
                 disc * jar_spin * mill.orbit_radius) *
        arm_ * largest_.mass();
    add("expected_impact_energy", pinned ? 0 : energy, "J",
        pinned ? "none: the largest ball is pinned to the wall all round (kin.13)"
               : "Burgio's energy per hit of the largest ball, with the jar's absolute speed "
                 "(kin.16)");
  }

  void mesh() {
    const auto* mesh = std::get_if<geometry::Mesh>(&*c_.jar.shape);
    if (mesh == nullptr) return;
    const auto triangles = static_cast<double>(mesh->surface().triangles.size());
    const Vec3 size = mesh->extent().size();
    add("jar_triangles", triangles, "", "triangles of the jar's mesh");
    add("jar_faces", mesh->faces, "", "faces into which creases divide the mesh (geo.9)");
    add("jar_width", size.x, "m", "extent of the mesh along the jar's own x axis");
    add("jar_depth", size.y, "m", "extent of the mesh along the jar's own y axis");
    add("jar_height", size.z, "m", "extent of the mesh along the jar's own z axis");
  }

  void charge() {
    mesh();
    const double jar = jar_volume(c_.jar), mass = balls_mass(c_.balls);
    double count = 0;
    for (const BallSet& set : c_.balls)
      if (!set.grains) count += static_cast<double>(set.count);
    const std::vector<BallSet> at_start = sets_at_start(c_);
    add("jar_volume", jar, "m3", "inner volume of the empty jar");
    add("ball_count", count, "", "number of balls of all sets");
    add("ball_mass", largest_.mass(), "kg", "mass of the largest ball");
    add("total_ball_mass", mass, "kg", "mass of all balls");
    add("filling", 100 * balls_volume(at_start) / jar, "%",
        "solid volume of the balls over the jar's volume");
    const bool drum = std::holds_alternative<Tumbling>(*c_.mill.motion);
    if (drum)
      add("bulk_filling", 100 * bulk_filling(at_start, c_.jar), "%",
          "J: bulk volume of the balls, with 40 % voids, over the jar's volume (obs.14)");
    if (!c_.powder) return;
    add("powder_mass", c_.powder->mass, "kg", "mass of the powder");
    add("ball_to_powder", mass / c_.powder->mass, "", "mass of the balls over mass of the powder");
    if (const auto voids = void_filling(c_); drum && voids)
      add("void_filling", 100 * *voids, "%",
          "U: bulk volume of the powder over the voids between the balls at rest (obs.15)");
    if (c_.balls.back().grains) grains(c_.balls.back(), *c_.powder, jar);
  }

  /// A set of bodies that are no spheres.
  void body(std::size_t i) {
    const BallSet& set = c_.balls[i];
    if (set.body.is_sphere()) return;
    const std::string number = c_.balls.size() > 1 ? fmt::format("_{}", i + 1) : "";
    add("equivalent_diameter" + number, set.diameter, "m",
        "diameter of the sphere of the same volume as a body of the set (bod.1)");
    if (set.body.is_convex()) return;
    add("spheres_of_a_body" + number, static_cast<double>(set.body.solid().spheres.size()), "",
        "number of spheres that stand for a body");
    add("scale_of_spheres" + number, 100 * set.body.scale(), "%",
        "size of the clump of spheres over that of the body: their volumes are the same (bod.15)");
  }

  void grains(const BallSet& set, const Powder& powder, double jar) {
    add("grain_count", static_cast<double>(set.count), "",
        "number of spheres that represent the powder");
    add("grain_filling", 100 * static_cast<double>(set.count) * ball_volume(set) / jar, "%",
        "solid volume of the grains over the jar's volume");
    if (!powder.size) return;
    const double ratio = *powder.grain_size / *powder.size;  // (chg.9)
    add("coarse_graining_ratio", ratio, "", "size of a grain over the powder's size (chg.9)");
    add("particles_per_grain", ratio * ratio * ratio, "",
        "particles of the powder that each grain represents (chg.10)");
  }

  const Case& c_;
  BallSet largest_;
  double arm_ = 0;   // [m] distance of the centre of a ball on the wall from the jar's axis
  double peak_ = 0;  // [m/s]
  std::vector<DerivedQuantity> found_;
};

}  // namespace

double across_axis(const Vec3& gravity) {
  return gravity.y == 0 ? std::abs(gravity.z) : math::hypot(gravity.y, gravity.z);
}

double critical_speed(const Jar& jar, const std::vector<BallSet>& balls, double gravity) {
  return std::sqrt(gravity / (jar_radius(jar) - 0.5 * largest_ball(balls)));  // (kin.11)
}

std::vector<DerivedQuantity> derived_quantities(const Case& c) {
  if (c.balls.empty()) return {};
  return Derivation(c).all();
}

}  // namespace mahlwerk::cases
