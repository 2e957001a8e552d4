// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"

namespace mahlwerk::cases {

/// A key that takes three numbers: a point, or a direction of any length.
struct VectorKey {
  NumberSpec component;  ///< key, unit and description
  Vec3 standard;
  std::string_view source;  ///< of the default
  bool direction = false;   ///< scaled to a length of 1
  bool required = false;    ///< there is no default
};

/// Visits the key; a reader sets `value`, to the default if the section does not give it.
void describe(KeyVisitor& v, const VectorKey& key, Vec3& value);

}  // namespace mahlwerk::cases
