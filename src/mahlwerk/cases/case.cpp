// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/case.hpp"

#include <algorithm>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::cases {

double BallSet::mass() const {
  scene::Ball ball;
  ball.radius = 0.5 * diameter;
  ball.density = layers().mean_density(ball.radius);
  return ball.mass();
}

scene::BallLayers BallSet::layers() const {
  return {.density = density,
          .wall_thickness = wall_thickness,
          .coating_thickness = coating_thickness.value_or(0),
          .coating_density = coating_density.value_or(0)};
}

scene::BodyShape BallSet::shape() const {
  return body.is_sphere() ? scene::BodyShape{} : body.solid().shape();
}

double BallSet::inertia_ratio(double of_diameter) const {
  return body.is_sphere() ? layers().inertia_ratio(0.5 * of_diameter)
                          : shape().mean_inertia_ratio();
}

double BallSet::reach() const {
  return body.is_sphere() ? 1 : shape().reach();
}

double BallSet::surface_density() const {
  return coating_thickness ? coating_density.value_or(density) : density;
}

std::vector<SizeClass> BallSet::sizes() const {
  return classes.empty() ? std::vector{SizeClass{diameter, count}} : classes;
}

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;

bool Case::operator==(const Case& o) const {
  return title == o.title && seed == o.seed && mill == o.mill && jar == o.jar &&
         machine_parts == o.machine_parts && balls == o.balls && powder == o.powder &&
         contact == o.contact && liquid == o.liquid && flow == o.flow &&
         bed_breakage == o.bed_breakage && drive == o.drive && run == o.run &&
         observe == o.observe && milling == o.milling && heat == o.heat && capture == o.capture &&
         grinding == o.grinding && kinetics == o.kinetics && parts == o.parts &&
         gravity == o.gravity && gravity_direction == o.gravity_direction && sweep == o.sweep &&
         optimise == o.optimise && match == o.match && uncertainty == o.uncertainty && fit == o.fit;
}

std::vector<const Part*> parts_of(const Case& c) {
  std::vector<const Part*> chosen;
  for (const Part* part : parts())
    if (std::ranges::any_of(part->sections, [&](const PartSection& one) { return one.present(c); }))
      chosen.push_back(part);
  return chosen;
}

Vec3 gravity_in_mill(double gravity, const Vec3& direction, double tilt) {
  const Vec3 untilted = gravity * direction;
  return tilt == 0 ? untilted : rotation_about({0, 1, 0}, tilt) * untilted;  // (kin.19)
}

Vec3 Case::gravity_vector() const {
  return gravity_in_mill(gravity, gravity_direction, mill.tilt);
}

}  // namespace mahlwerk::cases
