// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::contact {

// CMake counts the files in laws/ and compiles the loops of the soft engine for each of them.
static_assert(laws_count == MAHLWERK_LAW_FILES,
              "every file in contact/laws/ is one law, and has its name in contact/laws.hpp");

}  // namespace mahlwerk::contact
