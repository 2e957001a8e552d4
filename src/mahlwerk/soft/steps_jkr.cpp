// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/contact/jkr.hpp"
#include "mahlwerk/soft/passes.hpp"
#include "mahlwerk/soft/steps.hpp"

namespace mahlwerk::soft {

template Steps steps_of<contact::Jkr>();
template PassOf pass_of<contact::Jkr>();

}  // namespace mahlwerk::soft
