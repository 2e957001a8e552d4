// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/file/section_reader.hpp"

// Files that a part is read from.
namespace mahlwerk::cases {

void describe_part_mesh(KeyVisitor& v, MachinePart& part);  ///< `file` and `unit`
void read_part_mesh(SectionReader& in, MachinePart& part);
/// The table of a measured motion: three coordinates and three angles.
void describe_part_motion_file(KeyVisitor& v, MachinePart& part);

}  // namespace mahlwerk::cases
