// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/choice.hpp"

namespace mahlwerk::soft {

/// How the soft engine treats contacts and time.
struct Rules {
  contact::LawChoice law;
  double time_step = 0;  ///< [s]
  bool hop = true;       ///< over time in which nothing touches and nothing can
};

}  // namespace mahlwerk::soft
