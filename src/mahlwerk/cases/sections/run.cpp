// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [run]: engine, times, replicates and initial velocities.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

/// At most three years; a longer time is taken for a mistake.
constexpr Range run_times{.least = 1e-9, .most = 1e8};
constexpr Range ramp_times{.least = 1e-3, .most = 1e6};
constexpr Range settle_times{.least = 0, .most = 1e8};
/// At most three times the speed of sound in air; no mill accelerates its balls to more.
constexpr Range start_speeds{.least = 0, .most = 1000};
constexpr Range start_spins{.least = 0, .most = 1e6};

constexpr Range until_range{.least = 0, .most = 1, .without_least = true};  // of "until 2 %"

constexpr std::string_view until_word = "until";

bool waits(const Node* time) {
  return time != nullptr && time->kind == Node::Kind::text && time->text.starts_with(until_word);
}

/// time = "until 2 %", with the quantity and the longest time.
void describe_until(KeyVisitor& v, Run& run) {
  constexpr std::string_view about =
      "the half-width of the confidence interval over the mean: \"until 2 %\"";
  StopCriterion& until = *run.until;
  SectionReader* in = v.reader();
  const Node* at = in ? in->find("time") : nullptr;
  if (at != nullptr) {
    Node share = *at;
    share.text.erase(0, until_word.size());
    share.text.erase(0, share.text.find_first_not_of(' '));
    until.within = in->quantity(share, {"time", "", until_range, about});
  }
  v.custom({"time", about, until_range.holds(until.within), "text", true},
           [&] { return in_quotes(fmt::format("{} {}", until_word, show(until.within, ""))); });
  v.word_text(
      {"until", until_quantities(), until_quantities().front(), "the power that a user pays for",
       "quantity whose precision ends a run with time = \"until 2 %\""},
      until.quantity);
  if (at != nullptr) in->record_origin("time", in_quotes(at->text), at);
  v.number({"longest", "s", run_times,
            "counted time at which a run with time = \"until 2 %\" ends in any case", 100.0,
            "a limit that few runs need"},
           run.time);
}

/// Random speeds and spins at the start.
void describe_random_motion(KeyVisitor& v, Run& run) {
  v.number({"start_speed", "m/s", start_speeds, "starting speeds are uniform between 0 and this",
            0.1, "Chen et al. 2016"},
           run.start_speed);
  v.number({"start_spin", "rad/s", start_spins, "starting spins are uniform between 0 and this",
            0.1, "Chen et al. 2016"},
           run.start_spin);
}

/// settle = "auto" or a time.
void describe_settle(KeyVisitor& v, Run& run) {
  constexpr std::string_view key = "settle", word = "\"auto\"";
  constexpr std::string_view about =
      "time before that, left out of the statistics; or \"auto\": until the mill has settled";
  SectionReader* in = v.reader();
  const Node* at = in ? in->find(key) : nullptr;
  const bool automatic = at == nullptr || (at->kind == Node::Kind::text && at->text == "auto");
  if (in != nullptr && automatic) {
    run.settle.reset();
    if (at != nullptr) return in->record_origin(key, std::string(word), at);
    return in->record_default(key, std::string(word),
                              "counting begins once power and hits have no trend");
  }
  if (in == nullptr && !run.settle && !v.visits_all())
    return v.custom({key, about, true, "text"}, [&] { return std::string(word); });
  v.optional_number(
      NumberSpec(key, "s", settle_times, about)
          .with_default_text("\"auto\": counting begins once power and hits have no trend")
          .with({.label = "settling, not counted", .usual = {"0 s", "5 s"}}),
      run.settle);
}

/// time = "60 s" or "until 2 %", the settling time, and the initial speeds and spins.
void describe_times(KeyVisitor& v, Run& run) {
  SectionReader* in = v.reader();
  if (in != nullptr && waits(in->find("time"))) run.until.emplace();
  if (!run.until)
    v.number(
        NumberSpec{"time", "s", run_times,
                   "simulated time that counts; or \"until 2 %\": until `until` is known this well"}
            .with({.label = "simulated time", .symbol = "$t$", .usual = {"0.1 s", "100 s", true}}),
        run.time);
  else if (in == nullptr)
    describe_until(v, run);  // a reader reads it after the other keys
  describe_settle(v, run);
  if (run.start_from.file.empty() || v.visits_all()) describe_random_motion(v, run);
  if (run.until && in != nullptr) describe_until(v, run);
}

/// The file or folder with the state of the balls at the start; keys that it replaces are refused.
void read_start_from(SectionReader& in, StartStates& start) {
  const Node* at = in.find("start_from");
  if (at == nullptr) return;
  start.file = in.text("start_from").value_or("");
  if (start.file.empty()) return;
  start = read_start_states(start.file, *at, in.findings());
  in.refuse({"start_speed", "start_spin", "start_frame", "start"},
            "beside start_from, which gives the state of all balls", "remove it, or start_from");
}

/// The time of a ramp. Without one only its default may stand in a case.
void describe_ramp(KeyVisitor& v, Run& run) {
  constexpr double usual = 2;  // [s]
  const NumberSpec spec(
      "ramp_time", "s", ramp_times,
      "time in which the mill comes to its speed from rest, with start = \"ramp\"", usual,
      "assumed; makers do not state it");
  SectionReader* in = v.reader();
  if (run.start == StartLayout::ramp || v.visits_all()) return v.number(spec, run.ramp_time);
  if (in == nullptr || !in->gives(spec.key)) return;
  if (in->value(spec) != usual)
    in->refuse({spec.key}, "where the mill runs at its speed from the start",
               "write start = \"ramp\", or remove it");
}

/// Arrangement and state of the balls at the start. Written only where a case gives them.
void describe_start(KeyVisitor& v, Run& run) {
  const bool all = v.reader() != nullptr || v.visits_all(), own = run.start_from.file.empty();
  if ((all && own) || v.visits_all() || run.start != StartLayout::random)
    v.word({"start",
            {"random", "layers", "ramp"},
            "random",
            "balls lie anywhere",
            "arrangement of the balls at the start",
            {"random positions", "the first ball set lowest, each set above the one before",
             "random positions, and the mill comes to its speed from rest within ramp_time"}},
           run.start);
  describe_ramp(v, run);
  if (all || run.settle_at_rest != 0)
    v.number({"settle_at_rest", "s", settle_times,
              "time before the start of the mill, which stands still; not counted", 0.0,
              "the mill runs from the start"},
             run.settle_at_rest);
  if (v.reader() == nullptr)
    v.text({"start_from",
            "result folder, or a file in it, whose last state of the balls is the start"},
           run.start_from.file);
}

/// Written only where a case gives it, as it changes no result of the run itself.
void describe_sensitivity(KeyVisitor& v, Run& run) {
  if (v.reader() == nullptr && !v.visits_all() && run.sensitivity == SensitivityMode::automatic)
    return;
  v.word({"sensitivity",
          {"auto", "on", "off"},
          "auto",
          "where it simulates less time than the run",
          "whether a single run also computes what its assumed values decide",
          {"where this simulates less time than the run", "always", "never"}},
         run.sensitivity);
}

/// Written only where a case gives it, as it changes no result but its last digits.
void describe_device(KeyVisitor& v, Run& run) {
  if (v.reader() == nullptr && !v.visits_all() && run.device == DeviceName::automatic) return;
  v.word({"device",
          {"auto", "cpu", "gpu"},
          "auto",
          "the processor",
          "what computes a run with engine = \"soft\"",
          {"the processor", "the processor", "the first NVIDIA graphics card of the machine"}},
         run.device);
}

/// The soft engine's step: a time, or an error with a share of the Rayleigh time.
void describe_step(KeyVisitor& v, Run& run) {
  const NumberSpec step = NumberSpec("time_step", "s", positive,
                                     "time step of the soft engine, and in LAMMPS")
                              .in_place_of("time_step_fraction")
                              .read_by(soft_and_lammps),
                   share = NumberSpec(step_share).read_by(soft_and_lammps),
                   error = NumberSpec(step_error).read_by(soft_only);
  SectionReader* in = v.reader();
  const auto before = [&](std::string_view key) { return in->one_of({step.key, key}) == step.key; };
  const bool timed =
      in != nullptr ? before(share.key) && before(error.key) : run.time_step.has_value();
  if (timed || v.visits_all()) v.optional_number(step, run.time_step);
  if (timed && !v.visits_all()) return;
  v.number(error, run.step_error);
  v.number(share, run.time_step_fraction);
}

}  // namespace

void describe(KeyVisitor& v, Run& run) {
  v.word({"engine",
          engines(),
          "auto",
          "chosen by what the case needs",
          "engine that computes the run",
          {"instantaneous collisions, from event to event", "contact forces and time steps",
           "the program chooses event or soft by the case, and says why",
           "the soft engine's model in LAMMPS, an installed program, on one or many processors"}},
         run.engine);
  if (SectionReader* in = v.reader()) read_start_from(*in, run.start_from);
  describe_times(v, run);
  if (run.start_from.file.empty() || v.visits_all())
    v.word({"start_frame",
            {"laboratory", "jar"},
            "laboratory",
            "Chen et al. 2016",
            "frame of reference of the starting speeds",
            {"at rest", "moves with the centre of the jar, without rotation"}},
           run.start_frame);
  describe_step(v, run);
  v.flag({"hop", true, "the soft engine skips time steps in free flight and at rest",
          "whether the soft engine skips time steps while nothing touches (at most 128 balls), and "
          "all steps once the balls in a jar that stands still are at rest",
          soft_only},
         run.free_flight_skip);
  describe_device(v, run);
  v.integer({.key = "replicates",
             .least = 1,
             .most = max_replicates,
             .about = "runs that differ only by chance",
             .standard = 5,
             .source = "as in Chen et al. 2016",
             .presentation = {.usual = {"1", "20"}}},
            run.replicates);
  describe_start(v, run);
  describe_sensitivity(v, run);
}

}  // namespace mahlwerk::cases
