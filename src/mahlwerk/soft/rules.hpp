// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "mahlwerk/contact/contact_model.hpp"

namespace mahlwerk::soft {

/// How the soft engine treats contacts and time.
struct Rules {
  contact::ContactModel model;
  double time_step = 0;             ///< [s]
  bool free_flight_skip = true;     ///< over time in which nothing touches and nothing can
  std::size_t few_body_limit = 32;  ///< largest number of balls for the solver of few
  double most_overlap = 0.01;  ///< of a radius at the start; bodies that overlap more are refused
  int threads = 1;  ///< that share the work of one run; the result is the same for any number
};

}  // namespace mahlwerk::soft
