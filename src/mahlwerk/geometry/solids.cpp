// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/solids.hpp"

#include "mahlwerk/base/indirect_members.hpp"

template class mahlwerk::Indirect<mahlwerk::geometry::AnySolid>;

namespace mahlwerk::geometry {

std::string_view name_of(const AnySolid& solid) {
  return std::visit([](const auto& s) -> std::string_view { return s.name; }, solid);
}

}  // namespace mahlwerk::geometry
