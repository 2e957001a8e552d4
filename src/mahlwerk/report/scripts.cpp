// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/scripts.hpp"

#include <cstddef>

// Embeds the script files unchanged in the program (.incbin).
asm(R"(
  .section .rodata
  .global mahlwerk_replay_begin, mahlwerk_replay_end, mahlwerk_plots_begin, mahlwerk_plots_end
mahlwerk_replay_begin:
  .incbin ")" MAHLWERK_REPLAY_SCRIPT R"("
mahlwerk_replay_end:
  .byte 0
mahlwerk_plots_begin:
  .incbin ")" MAHLWERK_PLOTS_SCRIPT R"("
mahlwerk_plots_end:
  .byte 0
  .previous
)");

extern "C" const char mahlwerk_replay_begin[], mahlwerk_replay_end[], mahlwerk_plots_begin[],
    mahlwerk_plots_end[];

namespace mahlwerk::report {
namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

std::string_view replay_script() {
  return between(mahlwerk_replay_begin, mahlwerk_replay_end);
}

std::string_view plots_script() {
  return between(mahlwerk_plots_begin, mahlwerk_plots_end);
}

}  // namespace mahlwerk::report
