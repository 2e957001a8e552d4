// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace mahlwerk {

/// Bytes as text of 64 harmless characters, padded by '=' (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace mahlwerk
