// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/replay.hpp"

// Embeds the script file unchanged in the program (.incbin).
asm(R"(
  .section .rodata
  .global mahlwerk_replay_begin, mahlwerk_replay_end
mahlwerk_replay_begin:
  .incbin ")" MAHLWERK_REPLAY_SCRIPT R"("
mahlwerk_replay_end:
  .byte 0
  .previous
)");

extern "C" const char mahlwerk_replay_begin[], mahlwerk_replay_end[];

namespace mahlwerk::report {

std::string_view replay_script() {
  return {mahlwerk_replay_begin,
          static_cast<std::size_t>(mahlwerk_replay_end - mahlwerk_replay_begin)};
}

}  // namespace mahlwerk::report
