// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/models.hpp"

#include "mahlwerk/base/indirect_members.hpp"

template class mahlwerk::Indirect<mahlwerk::powder::AnyCapture>;
template class mahlwerk::Indirect<mahlwerk::powder::AnyBreakage>;
template class mahlwerk::Indirect<mahlwerk::powder::AnyFragments>;
template class mahlwerk::Indirect<mahlwerk::powder::AnyKinetics>;

namespace mahlwerk::powder {
namespace {

template <class AnyModel>
std::string_view name(const AnyModel& any) {
  return std::visit([](const auto& m) -> std::string_view { return m.name; }, any);
}

}  // namespace

std::string_view name_of(const AnyCapture& capture) {
  return name(capture);
}
std::string_view name_of(const AnyBreakage& breakage) {
  return name(breakage);
}
std::string_view name_of(const AnyFragments& fragments) {
  return name(fragments);
}
std::string_view name_of(const AnyKinetics& kinetics) {
  return name(kinetics);
}
std::string_view about(const AnyCapture& capture) {
  return std::visit([](const auto& m) -> std::string_view { return m.about; }, capture);
}
bool has_median_strength(const AnyBreakage& breakage) {
  return std::visit(
      [](const auto& m) {
        return requires {
          m.median(1.0);
        };
      },
      breakage);
}
bool tracks_strength(const AnyBreakage& breakage) {
  return std::visit([](const auto& m) -> bool { return m.tracks_strength; }, breakage);
}

ReactionShares reaction_shares(const AnyKinetics& kinetics, const MillingConditions& mill,
                               double time) {
  return std::visit([&](const auto& m) { return m.shares(mill, time); }, kinetics);
}
bool reads_hits(const AnyKinetics& kinetics) {
  return std::holds_alternative<ImpactKinetics>(kinetics);
}
bool has_second_product(const AnyKinetics& kinetics) {
  const auto* by_impact = std::get_if<ImpactKinetics>(&kinetics);
  return by_impact != nullptr && by_impact->has_second();
}
bool reads_temperature(const AnyKinetics& kinetics) {
  const auto* ignition = std::get_if<IgnitionKinetics>(&kinetics);
  return std::holds_alternative<ThermalKinetics>(kinetics) ||
         (ignition != nullptr && ignition->trigger == IgnitionKinetics::Trigger::temperature);
}

}  // namespace mahlwerk::powder
