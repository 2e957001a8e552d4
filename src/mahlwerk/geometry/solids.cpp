// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/solids.hpp"

#include "mahlwerk/base/indirect_members.hpp"

template class mahlwerk::Indirect<mahlwerk::geometry::AnySolid>;
