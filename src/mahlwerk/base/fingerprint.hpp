// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace mahlwerk {

/// 64-bit FNV-1a hash of `bytes`, or of more bytes after those of which `hash` is the hash. Detects
/// accidental changes; not cryptographic.
constexpr std::uint64_t fingerprint(std::string_view bytes,
                                    std::uint64_t hash = 0xcbf29ce484222325) {
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

}  // namespace mahlwerk
