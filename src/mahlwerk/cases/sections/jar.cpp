// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {
namespace {

template <class S>
constexpr bool has_height = requires(S s) {
  s.height;
};
template <class S>
constexpr bool is_round = requires(S s) {
  s.diameter;
};
template <class S>
constexpr bool has_fillet = requires(S s) {
  s.fillet;
};

/// A size of a plain shape may follow from its volume; other shapes have internal parts.
template <class S>
constexpr bool is_plain = geometry::has_exact_touches<S>;

constexpr NumberSpec inner_volume =
    NumberSpec("volume", "m3", positive, "inner volume")
        .with({.label = "jar volume", .usual = {"1 ml", "1000 ml", true}});

/// The size that follows from a volume: the volume is linear in the height, or cubic in the
/// diameter of a sphere.
template <class S>
double size_for(S shape, double volume) {
  if constexpr (!is_round<S>) {
    shape.height = 1;
    return volume / shape.volume();
  } else if constexpr (has_height<S>) {
    shape.height = 0;
    const double radius = 0.5 * shape.diameter;
    const double height = (volume - shape.volume()) / (std::numbers::pi * radius * radius);
    constexpr double rounding = 1e-12;  // a capsule may have no cylinder
    return std::abs(height) < rounding * shape.diameter ? 0 : height;
  } else {
    return math::cbrt(6 * volume / std::numbers::pi);
  }
}

/// The volume of the shape with its least height.
template <class S>
double min_volume(S shape) {
  if constexpr (has_fillet<S>) {
    shape.height = 2 * shape.fillet;
  } else {
    shape.height = 0;
  }
  return shape.volume();
}

template <class S>
void size_from_volume(SectionReader& in, S& shape, std::string_view follows, double S::*size) {
  const Node& at = *in.find("volume");
  const double volume = in.quantity(at, inner_volume);
  shape.*size = size_for(shape, volume);
  if constexpr (has_height<S> && is_round<S>) {
    const double least = min_volume(shape);
    if (volume < least || (volume == least && !std::is_same_v<S, geometry::Capsule>)) {
      in.fault(at,
               fmt::format("volume = \"{}\" is too small for a diameter of {}: the {} holds more "
                           "than {} without any height",
                           at.text, show(shape.diameter, "m"), S::name, show_rounded(least, "m3")),
               "give a larger volume or a smaller diameter", "volume-too-small");
      shape.*size = invalid_value;
    }
  }
  if (!std::isnan(shape.*size))
    in.record_origin(follows, show(shape.*size, "m"), &at,
                     fmt::format("follows from volume = \"{}\"", at.text));
}

template <class S>
void read_shape(SectionReader& in, S& shape) {
  constexpr std::string_view follows = has_height<S> ? "height" : "diameter";
  const bool by_volume = is_plain<S> && in.one_of({follows, "volume"}) == "volume";
  double S::*size = nullptr;
  for (const auto& field : S::fields()) {
    if (field.key == follows && by_volume) {
      size = field.value;
      continue;
    }
    NumberSpec spec(field);
    if (field.key == follows && is_plain<S>) spec.instead = "volume";
    shape.*field.value = in.value(spec);
  }
  if constexpr (is_plain<S>) {
    if (size != nullptr) size_from_volume(in, shape, follows, size);
  } else if (std::ranges::none_of(
                 S::fields(), [&](const auto& field) { return std::isnan(shape.*field.value); })) {
    shape.complete();
  }
}

void describe_shape(KeyVisitor& v, geometry::AnyShape& any) {
  SectionReader* in = v.reader();
  const auto numbers = [&]<class S>(S& shape) {
    if (in == nullptr) {
      v.fields(shape, S::fields());
      if (is_plain<S>)
        v.alternative(inner_volume.in_place_of(has_height<S> ? "height" : "diameter"));
    }
    if constexpr (!std::is_same_v<S, geometry::Mesh>)  // read by describe_mesh()
      if (in != nullptr) read_shape(*in, shape);
  };
  std::visit(numbers, any);
}

}  // namespace

Jar invalid_jar() {
  geometry::Sphere nothing;
  nothing.diameter = invalid_value;
  return {.model = "", .material = "", .shape = nothing};
}

void describe(KeyVisitor& v, Jar& jar) {
  Model model;
  const bool known =
      describe_kind(v, "jars", "inner shape of the jar", *jar.shape, jar.model, model);
  constexpr TextSpec material{
      .key = "material",
      .about = "material of the jar, by its name in the catalogue; gives the properties below",
      .category = "materials"};
  if (v.reader() != nullptr) v.text(material, jar.material);
  if (!known) {
    jar.shape = invalid_jar().shape;
    return v.ignore_unknown_keys();
  }
  if (std::holds_alternative<geometry::Mesh>(*jar.shape)) describe_mesh(v, jar);
  describe_shape(v, *jar.shape);
  const Vec3 periods = geometry::periods(*jar.shape);
  if (!std::isfinite(periods.x) && std::isfinite(periods.z))
    v.optional_number(NumberSpec("mill_length", "m", positive,
                                 "length of the whole mill of which the jar is a slice, for its "
                                 "power; left out: not told"),
                      jar.mill_length);
  if (v.reader() == nullptr) v.text(material, jar.material);
  describe_wall(v, jar);
}

}  // namespace mahlwerk::cases
