// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [run]: for how long, by which engine, and how it begins.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

/// Three years; what a mill does, it does in minutes.
constexpr Range run_times{.least = 0, .most = 1e8, .without_least = true};
constexpr Range settle_times{.least = 0, .most = 1e8};
/// No mill throws its balls faster than sound travels in air three times over.
constexpr Range start_speeds{.least = 0, .most = 1000};
constexpr Range start_spins{.least = 0, .most = 1e6};

constexpr Range until_range{.least = 0, .most = 1, .without_least = true};  // of "until 2 %"

constexpr std::string_view until_word = "until";

bool waits(const Node* time) {
  return time != nullptr && time->kind == Node::Kind::text && time->text.starts_with(until_word);
}

/// time = "until 2 %", of what, and how long at most.
void describe_until(Walk& w, Run& run) {
  constexpr std::string_view about =
      "the half-width of the confidence interval over the mean: \"until 2 %\"";
  Until& until = *run.until;
  Section* in = w.reading();
  const Node* at = in ? in->find("time") : nullptr;
  if (at != nullptr) {
    Node share = *at;
    share.text.erase(0, until_word.size());
    share.text.erase(0, share.text.find_first_not_of(' '));
    until.within = in->quantity(share, {"time", "", until_range, about});
  }
  w.formed({"time", about, until_range.holds(until.within)},
           [&] { return in_quotes(fmt::format("{} {}", until_word, show(until.within, ""))); });
  w.one_word({"until", until_words(), until_words().front(), "what the mill's user pays for"},
             until.quantity);
  if (at != nullptr) in->note("time", in_quotes(at->text), at);
  w.number(
      {"longest", "s", run_times, "the counted time at which a run ends that is not sure by then",
       100.0, "a limit that few runs need"},
      run.time);
}

/// time = "60 s" or "until 2 %", and how it begins.
void describe_times(Walk& w, Run& run) {
  Section* in = w.reading();
  if (in != nullptr && waits(in->find("time"))) run.until.emplace();
  if (!run.until)
    w.number({"time", "s", run_times, "simulated time that counts"}, run.time);
  else if (in == nullptr)
    describe_until(w, run);  // it is read after the others
  w.number({"settle", "s", settle_times, "time before that, left out of the statistics", 0.0,
            "statistics from the start"},
           run.settle);
  w.number({"start_speed", "m/s", start_speeds, "starting speeds are uniform between 0 and this",
            0.1, "paper A"},
           run.start_speed);
  w.number({"start_spin", "rad/s", start_spins, "starting spins are uniform between 0 and this",
            0.1, "paper A"},
           run.start_spin);
  if (run.until && in != nullptr) describe_until(w, run);
}

/// The soft engine's step: a time, or a share of the Rayleigh time.
void describe_step(Walk& w, Run& run) {
  const Wanted step("time_step", "s", positive, "time step of the soft engine"), share(step_share);
  if (w.one_of({step.key, share.key}, run.time_step ? step.key : share.key) == step.key)
    w.maybe(step, run.time_step);
  else
    w.number(share, run.time_step_fraction);
}

}  // namespace

void describe(Walk& w, Run& run) {
  w.word({"engine", engines(), "auto", "chosen by what the case needs"}, run.engine);
  describe_times(w, run);
  w.word({"start_frame", {"laboratory", "jar"}, "laboratory", "paper A"}, run.start_frame);
  describe_step(w, run);
  w.flag({"hop", true, "the clock of the soft engine hops over free flight"}, run.hop);
  w.whole(
      {"replicates", 1, most_replicates, "runs that differ by chance alone", 5, "as in paper A"},
      run.replicates);
}

}  // namespace mahlwerk::cases
