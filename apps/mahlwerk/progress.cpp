// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace mahlwerk::app {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_interrupt(int signal) {
  stop_asked.store(true);
  std::signal(signal, SIG_DFL);  // the next one ends the program
}

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

const std::atomic<bool>& stop_wanted() {
  return stop_asked;
}

void catch_ctrl_c() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

ProgressLine::ProgressLine(bool quiet) {
  const char* term = std::getenv("TERM");
  on_ = !quiet && isatty(STDERR_FILENO) == 1 && term != nullptr && std::string_view(term) != "dumb";
}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(const campaign::Progress& p) {
  if (!on_) return;
  using Seconds = std::chrono::duration<double>;
  const double gone = Seconds(std::chrono::steady_clock::now() - started_).count();
  const double share = p.wanted > 0 ? p.simulated / p.wanted : 0;
  const double left = share > 0 ? gone * (1 - share) / share : 0;
  show(fmt::format(
      "{:3.0f} %  {:.4g} of {:.4g} s simulated  {:.0f} s left  {:.3g} collisions/s  energy "
      "residual {:.0e}",
      100 * share, p.simulated, p.wanted, left, p.collisions / gone, p.residual));
}

void ProgressLine::show(std::string line) {
  if (!on_) return;
  shown_ = true;
  line.resize(std::min(line.size(), terminal_width() - 1));
  fmt::print(stderr, "\r\033[K{}", line);
  std::fflush(stderr);
}

}  // namespace mahlwerk::app
