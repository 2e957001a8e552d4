// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/contact/pairwise_table.hpp"

namespace mahlwerk::contact {

/// The collision rule of each pair of ball kinds, and of each kind with each face.
using BounceTable = PairwiseTable<BounceRule>;

}  // namespace mahlwerk::contact
