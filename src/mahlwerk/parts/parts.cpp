// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The register of parts, in the order of sections, quantities, tables and panels.
#include <array>

#include "mahlwerk/cases/part.hpp"

namespace mahlwerk::parts {
namespace wear {
const cases::Part& part();
}
namespace heat {
const cases::Part& part();
}
namespace grinding {
const cases::Part& part();
}
namespace kinetics {
const cases::Part& part();
}
namespace bed_breakage {
const cases::Part& part();
}
namespace powder_feedback {
const cases::Part& part();
}
namespace flow {
const cases::Part& part();
}
namespace mixing {
const cases::Part& part();
}
namespace drive {
const cases::Part& part();
}
namespace power_meter {
const cases::Part& part();
}
namespace microphone {
const cases::Part& part();
}
namespace accelerometer {
const cases::Part& part();
}
namespace thermocouple {
const cases::Part& part();
}
}  // namespace mahlwerk::parts

std::span<const mahlwerk::cases::Part* const> mahlwerk::cases::parts() {
  using namespace mahlwerk::parts;
  static const std::array all{&wear::part(),
                              &heat::part(),
                              &grinding::part(),
                              &bed_breakage::part(),
                              &powder_feedback::part(),
                              &kinetics::part(),
                              &flow::part(),
                              &mixing::part(),
                              &drive::part(),
                              &power_meter::part(),
                              &microphone::part(),
                              &accelerometer::part(),
                              &thermocouple::part()};
  return all;
}
