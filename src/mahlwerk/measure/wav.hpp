// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace mahlwerk::measure {

/// A sound with the mean of its channels.
struct Sound {
  double rate = 0;              ///< [Hz] samples per second
  std::vector<double> samples;  ///< -1 to 1
  double clipped = 0;  ///< share of the samples at the largest value that the file can hold
};

/// Reads the bytes of a WAV file: PCM of 8, 16, 24 or 32 bit or floating point of 32 or 64 bit.
/// `file` is the name that faults cite. Throws InputError for another or a damaged file.
Sound read_wav(const std::string& bytes, const std::string& file);

}  // namespace mahlwerk::measure
