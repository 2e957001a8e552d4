// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/powder/process.hpp"

// A sample of every model in the registers, with parameters that have an effect. A model without a
// sample here does not link.
namespace mahlwerk::tests {

template <class Model>
Model sample();
template <>
inline powder::VogelPeukert sample() {
  return {2, 0.05};
}
template <>
inline powder::ShiKojovic sample() {
  return {0.5, 2, 0.05};
}
template <>
inline powder::Tavares sample() {
  return {43.4, 3.48e-3, 1.61, 0.5, 4, 5, 0.6, 0.03};
}
template <>
inline powder::Threshold sample() {
  return {200, 1e-3, 0.5};
}
template <>
inline powder::VogelFragments sample() {
  return {1.2, 20e-6};
}
template <>
inline powder::AustinFragments sample() {
  return {0.4, 0.8, 3};
}
template <>
inline powder::T10Fragments sample() {
  return {0.3, 1};
}
template <>
inline powder::BinaryFragments sample() {
  return {};
}
template <>
inline powder::Halves sample() {
  return {};
}
template <>
inline powder::Barrios sample() {
  return {300};
}
template <>
inline powder::TrappedVolume sample() {
  return {1e-4, 0.6};
}
template <>
inline powder::SurfaceLayer sample() {
  return {0.3};
}
template <>
inline powder::FixedMass sample() {
  return {2e-6};
}

template <>
inline powder::DoseKinetics sample() {
  return {2e3, 1.5, 100};
}
template <>
inline powder::ImpactKinetics sample() {
  return {.processed_share = 0.5,
          .threshold_energy = 5e-4,
          .energy_exponent = 0.7,
          .reference_energy = 5e-3,
          .second_share = 0.3,
          .second_threshold = 2e-3,
          .scheme = powder::ImpactKinetics::Scheme::sequential};
}
template <>
inline powder::ThermalKinetics sample() {
  return {.factor_per_impact = 1e9,
          .activation_energy = 80e3,
          .attempts = powder::ThermalKinetics::Attempts::by_impact};
}
template <>
inline powder::IgnitionKinetics sample() {
  return {.ignition_temperature = 400,
          .milled_temperature = 300,
          .activation_dose = 5e3,
          .converted_share = 0.9,
          .trigger = powder::IgnitionKinetics::Trigger::temperature};
}

template <class Any, class... Models>
std::vector<Any> samples(std::type_identity<std::variant<Models...>>) {
  return {Any(sample<Models>())...};
}
inline std::vector<powder::AnyBreakage> every_breakage() {
  return samples<powder::AnyBreakage>(std::type_identity<powder::BreakageModels>{});
}
inline std::vector<powder::AnyFragments> every_fragments() {
  return samples<powder::AnyFragments>(std::type_identity<powder::FragmentsModels>{});
}
inline std::vector<powder::AnyCapture> every_capture() {
  return samples<powder::AnyCapture>(std::type_identity<powder::CaptureModels>{});
}

}  // namespace mahlwerk::tests
