// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reporting/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>

#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/printable.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/commands/reporting/listener.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/terminal.hpp"

namespace mahlwerk::commands {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_interrupt(int signal) {
  stop_asked.store(true);
  // The next signal ends the program. SIGHUP is ignored: a closing terminal sends it repeatedly.
  std::signal(signal, signal == SIGHUP ? SIG_IGN : SIG_DFL);
}

/// Functions of a signal handler may only make system calls.
extern "C" void on_early_signal(int) {
  constexpr std::string_view text = "interrupted: nothing was begun\n",
                             json =
                                 "{\"ended\": \"interrupted\", \"exit\": 130, \"faults\": "
                                 "[{\"code\": \"interrupted\", \"where\": \"\", \"what\": "
                                 "\"interrupted\", \"remedy\": \"nothing was begun\"}]}\n";
  const std::string_view words = json_messages() ? json : text;
  if (::write(STDERR_FILENO, words.data(), words.size()) < 0) _exit(interrupted);
  _exit(interrupted);
}

/// SIGHUP stays ignored under nohup.
void on_signals(void (*handler)(int)) {
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
  if (std::signal(SIGHUP, handler) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

/// [s] between two lines without a terminal.
std::chrono::duration<double> between_lines() {
  constexpr double usual = 30;
  const char* said = std::getenv("MAHLWERK_PROGRESS_EVERY");
  const NumberText wanted = number_text(said != nullptr ? said : "");
  return std::chrono::duration<double>(wanted.number >= 0 ? wanted.number : usual);
}

}  // namespace

const std::atomic<bool>& stop_wanted() {
  return listener() != nullptr ? listener()->stop : stop_asked;
}

void catch_ctrl_c() {
  // With a listener signals belong to the program that called the command.
  if (listener() == nullptr) on_signals(on_interrupt);
}

void catch_early_signals() {
  on_signals(on_early_signal);
}

ProgressLine::ProgressLine(bool quiet)
    : listener_(listener()),
      on_(!quiet),
      terminal_(is_terminal(Stream::errors)),
      every_(between_lines()) {
  if (!terminal_ && json_messages()) on_ = false;  // no progress lines between JSON messages
}

ProgressLine::~ProgressLine() {
  if (shown_) to_stderr("\r\033[K");
}

void ProgressLine::show(const campaign::Progress& p) {
  if (!on_) return;
  using Seconds = std::chrono::duration<double>;
  const double gone = Seconds(std::chrono::steady_clock::now() - started_).count();
  const double share = p.total > 0 ? p.simulated / p.total : 0;
  const std::string time = left(share);
  warn_if_endless(p);
  const bool known = p.residual > 0;  // LAMMPS tells none
  show(fmt::format("{:3.0f} %  {:.4g} of {:.4g} s simulated  {}{:.3g} collisions/s{}", 100 * share,
                   p.simulated, p.total, time.empty() ? "" : time + "  ", p.collisions / gone,
                   known ? fmt::format("  energy residual {:.0e}", p.residual) : ""));
}

std::string ProgressLine::left(double share) {
  constexpr double minute = 60, hour = 3600;
  const double gone = std::chrono::duration<double>(Clock::now() - started_).count();
  const double done = share - *(first_share_ = first_share_.value_or(share));
  if (done <= 0) return "";
  const double seconds = std::max(0.0, gone * (1 - share) / done);
  if (!terminal_ || seconds < 2 * minute) return fmt::format("{:.0f} s left", seconds);
  return seconds < 2 * hour ? fmt::format("{:.0f} min left", seconds / minute)
                            : fmt::format("{:.1f} h left", seconds / hour);
}

/// Warns once if the run, at the rate of the last seconds, takes hours.
void ProgressLine::warn_if_endless(const campaign::Progress& p) {
  constexpr std::chrono::seconds recent{3}, standstill{20};  // a slice may take more than `recent`
  constexpr double hour = 3600, most = 2 * hour;
  const Clock::time_point now = Clock::now();
  if (warned_ || now - rated_ < (p.simulated > simulated_ ? recent : standstill)) return;
  const double took = std::chrono::duration<double>(now - rated_).count();
  const double rate = (p.simulated - simulated_) / took;
  const double left = std::max(0.0, p.total - p.simulated) / rate;  // infinite at a standstill
  rated_ = now;
  simulated_ = p.simulated;
  if (!(left > most)) return;
  warned_ = true;
  if (shown_) to_stderr("\r\033[K");
  print_warning({"run.time",
                 fmt::format("at its present rate the run takes {} more",
                             left < 1000 * hour ? fmt::format("{} hours", two_digits(left / hour))
                                                : "months"),
                 "Ctrl-C keeps what is computed; engine = \"auto\", a smaller contact.softening, "
                 "fewer run.replicates, a shorter run.time or run.settle shorten it",
                 "long-run"});
}

void ProgressLine::show(std::string line) {
  if (!on_) return;
  line = printable(line);
  if (listener_ != nullptr) return listener_->progress(line);
  if (!terminal_) {
    const Clock::time_point now = Clock::now();
    if (now - last_ < every_) return;
    last_ = now;
    return to_stderr(line + '\n');
  }
  shown_ = true;
  line.resize(std::min(line.size(), terminal_width(Stream::errors) - 1));
  to_stderr("\r\033[K" + line);
}

}  // namespace mahlwerk::commands
