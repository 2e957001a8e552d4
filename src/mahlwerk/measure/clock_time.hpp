// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace mahlwerk::measure {

/// [s] The time "12:31", "12:31:05.2", "2026-11-29 12:31:05" or "2026-11-29T12:31:05Z", since the
/// begin of the day or, with a date, since 1970; none if the text is no such time.
std::optional<double> clock_time(std::string_view text);

}  // namespace mahlwerk::measure
