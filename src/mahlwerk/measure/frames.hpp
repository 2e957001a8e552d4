// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace mahlwerk::measure {

/// A grey picture, row by row from the top; 0 is black, 1 white.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<float> grey;

  double at(std::size_t x, std::size_t y) const { return static_cast<double>(grey[y * width + x]); }
};

/// Reads the pictures of a film one by one from a file in which they follow each other as binary
/// PGM or PPM (P5, P6; 8 or 16 bit; colours are averaged), as ffmpeg writes them.
class FrameReader {
 public:
  /// Throws InputError if the file cannot be read.
  explicit FrameReader(const std::string& file);

  /// The next picture; none after the last. Throws InputError if it is damaged, of another format,
  /// larger than 100 megapixels, or of another size than the first.
  std::optional<Picture> next();

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  std::size_t header_number();

  std::string file_;
  std::ifstream stream_;
  std::size_t read_ = 0, width_ = 0, height_ = 0;
};

}  // namespace mahlwerk::measure
