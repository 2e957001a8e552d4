// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace mahlwerk {

/// Base64 encoding of `bytes`, padded with '=' (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace mahlwerk
