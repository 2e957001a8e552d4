// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/frames.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::measure {
namespace {

constexpr std::size_t most_pixels = 100'000'000;

/// Value 0 to 1 of the next sample.
float sample(const unsigned char*& at, bool wide, float most) {
  const unsigned value = wide ? static_cast<unsigned>(at[0] << 8U | at[1]) : at[0];
  at += wide ? 2 : 1;
  return static_cast<float>(value) / most;
}

}  // namespace

FrameReader::FrameReader(const std::string& file) : file_(file) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError(Fault{file, "there is no such file", "check the path", "no-such-file"});
  stream_.open(file, std::ios::binary);
  if (!stream_)
    throw InputError(
        Fault{file, "the file cannot be read", "check its permissions", "no-such-file"});
}

void FrameReader::refuse(const std::string& what) const {
  throw InputError(Fault{file_, fmt::format("picture {}: {}", read_ + 1, what),
                         "make the file anew: ffmpeg -i film.mp4 -f image2pipe -c:v pgm film.pgm",
                         "bad-readings"});
}

std::size_t FrameReader::header_number() {
  int c = stream_.get();
  for (bool comment = false; comment || c == '#' || std::isspace(c) != 0; c = stream_.get())
    comment = c == '#' || (comment && c != '\n' && c != EOF);
  std::size_t number = 0;
  int digits = 0;
  for (; std::isdigit(c) != 0 && digits < 9; c = stream_.get(), ++digits)
    number = 10 * number + static_cast<std::size_t>(c - '0');
  if (digits == 0 || std::isspace(c) == 0) refuse("its header is damaged");
  return number;
}

std::optional<Picture> FrameReader::next() {
  int first = stream_.get();
  while (std::isspace(first) != 0) first = stream_.get();
  if (first == EOF) {
    if (read_ == 0) refuse("the file is empty");
    return std::nullopt;
  }
  const int kind = stream_.get();
  if (first != 'P' || (kind != '5' && kind != '6')) refuse("this is no binary PGM or PPM picture");
  const std::size_t width = header_number(), height = header_number(), most = header_number();
  if (width < 8 || height < 8 || width > most_pixels / height || most < 1 || most > 65535)
    refuse(fmt::format("{} x {} pixels with values up to {} cannot be read", width, height, most));
  if (read_ > 0 && (width != width_ || height != height_))
    refuse(fmt::format("it has {} x {} pixels, the first {} x {}", width, height, width_, height_));
  width_ = width, height_ = height;
  const bool wide = most > 255;
  const std::size_t colours = kind == '6' ? 3 : 1;
  std::vector<unsigned char> bytes(width * height * colours * (wide ? 2 : 1));
  stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(stream_.gcount()) != bytes.size()) refuse("it is cut off");
  Picture picture{width, height, std::vector<float>(width * height)};
  const unsigned char* at = bytes.data();
  for (float& grey : picture.grey) {
    for (std::size_t c = 0; c < colours; ++c) grey += sample(at, wide, static_cast<float>(most));
    grey /= static_cast<float>(colours);
  }
  ++read_;
  return picture;
}

}  // namespace mahlwerk::measure
