// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/part.hpp"

namespace mahlwerk::parts::kinetics {

/// [kinetics]: conversion of powder by dose, impact, temperature or ignition. Requires `c` with
/// grinding and heat.
void describe(cases::KeyVisitor& v, cases::Kinetics& k, const cases::Case& c);

}  // namespace mahlwerk::parts::kinetics
