// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/contact/laws.hpp"

#include "mahlwerk/base/indirect_members.hpp"

template class mahlwerk::Indirect<mahlwerk::contact::AnyLaw>;

namespace mahlwerk::contact {

// CMake counts the files in laws/ and compiles the innermost loops of the soft engine for each law.
static_assert(laws_count == MAHLWERK_LAW_FILES,
              "every file in contact/laws/ is one law, and has its name in contact/laws.hpp");

std::string_view name_of(const AnyLaw& law) {
  return std::visit([](const auto& l) { return l.name; }, law);
}
std::string_view shortest_time_name(const AnyLaw& law) {
  return std::visit([](const auto& l) -> std::string_view { return l.shortest_time_name; }, law);
}
std::span<const AdhesionParameter> adhesion(const AnyLaw& law) {
  return std::visit([]<class L>(const L&) { return adhesion_of<L>(); }, law);
}

}  // namespace mahlwerk::contact
