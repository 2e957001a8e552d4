// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/wav.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::measure {
namespace {

/// Little-endian whole number of `count` bytes.
std::uint64_t whole(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < count; ++i)
    number |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at + i])) << 8 * i;
  return number;
}

struct WavFormat {
  std::uint64_t code = 0, channels = 0, rate = 0, bits = 0;
  std::size_t bytes() const { return bits / 8; }
};

constexpr std::uint64_t pcm = 1, floating = 3, extensible = 0xFFFE;

/// One sample, -1 to 1.
double wav_sample(std::string_view data, std::size_t at, const WavFormat& format) {
  const std::uint64_t raw = whole(data, at, format.bytes());
  if (format.code == floating)
    return format.bits == 64
               ? std::bit_cast<double>(raw)
               : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
  if (format.bits == 8) return (static_cast<double>(raw) - 128) / 128;
  const std::uint64_t shift = 64 - format.bits;
  const auto extended = static_cast<std::int64_t>(raw << shift) >> shift;
  return std::ldexp(static_cast<double>(extended), 1 - static_cast<int>(format.bits));
}

class WavReader {
 public:
  WavReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  Sound read() {
    if (bytes_.size() < 12 || bytes_.substr(0, 4) != "RIFF" || bytes_.substr(8, 4) != "WAVE")
      refuse("this is no WAV file");
    std::optional<std::string_view> data;
    for (std::size_t at = 12; at + 8 <= bytes_.size() && !data;) {
      const std::string_view name = bytes_.substr(at, 4);
      const std::uint64_t size = whole(bytes_, at + 4, 4);
      at += 8;
      if (name == "fmt ") read_format(at, size);
      if (name == "data") data = data_of(at, size);
      at += std::min<std::uint64_t>(size + size % 2, bytes_.size());
    }
    if (!data || format_.code == 0) refuse("it holds no sound");
    return sound_of(*data);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(Fault{file_, what,
                           "convert the recording: ffmpeg -i recording -c:a pcm_s16le sound.wav",
                           "bad-readings"});
  }

  void read_format(std::size_t at, std::uint64_t size) {
    if (size < 16 || at + 16 > bytes_.size()) refuse("its header is damaged");
    format_ = {whole(bytes_, at, 2), whole(bytes_, at + 2, 2), whole(bytes_, at + 4, 4),
               whole(bytes_, at + 14, 2)};
    if (format_.code == extensible && size >= 26 && at + 26 <= bytes_.size())
      format_.code = whole(bytes_, at + 24, 2);
    const bool known = (format_.code == pcm && (format_.bits == 8 || format_.bits == 16 ||
                                                format_.bits == 24 || format_.bits == 32)) ||
                       (format_.code == floating && (format_.bits == 32 || format_.bits == 64));
    if (!known)
      refuse(fmt::format("samples of format {} with {} bit cannot be read", format_.code,
                         format_.bits));
    if (format_.channels < 1 || format_.channels > 64 || format_.rate < 1000 ||
        format_.rate > 10'000'000)
      refuse(fmt::format("{} channels at {} Hz cannot be read", format_.channels, format_.rate));
  }

  /// The samples; a size of 0 or of all ones, which programs write into a pipe, means all the rest.
  std::string_view data_of(std::size_t at, std::uint64_t size) const {
    const std::string_view rest = bytes_.substr(at);
    if (size == 0 || size == 0xFFFFFFFF) return rest;
    if (size > rest.size())
      refuse(fmt::format("it is cut off: {} of {} bytes are here", rest.size(), size));
    return rest.substr(0, size);
  }

  Sound sound_of(std::string_view data) const {
    const std::size_t step = format_.bytes(), channels = format_.channels;
    const std::size_t count = data.size() / (step * channels);
    if (count == 0) refuse("it holds no sound");
    Sound made{static_cast<double>(format_.rate), std::vector<double>(count), 0};
    std::size_t clipped = 0;
    for (std::size_t i = 0; i < count; ++i) {
      bool full = false;
      for (std::size_t c = 0; c < channels; ++c) {
        const double one = wav_sample(data, (i * channels + c) * step, format_);
        if (!(std::abs(one) < 1e6)) refuse(fmt::format("sample {} is no finite number", i + 1));
        full = full || std::abs(one) >= 0.992;
        made.samples[i] += one / static_cast<double>(channels);
      }
      clipped += full ? 1 : 0;
    }
    made.clipped = static_cast<double>(clipped) / static_cast<double>(count);
    return made;
  }

  std::string_view bytes_;
  const std::string& file_;
  WavFormat format_;
};

}  // namespace

Sound read_wav(const std::string& bytes, const std::string& file) {
  return WavReader(bytes, file).read();
}

}  // namespace mahlwerk::measure
