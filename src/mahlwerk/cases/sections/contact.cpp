// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

/// What becomes of bounces without end; several balls have one answer only.
Lasting read_lasting(Section& in, bool several) {
  const std::string word =
      in.choice({"lasting", lasting_words(), several ? "tc" : "roll",
                 several ? "with several balls lasting contacts are carried by the TC rule"
                         : "a ball may come to stay, and roll or slide"});
  const auto at = std::ranges::find(lasting_words(), word);
  return at == lasting_words().end() ? Lasting::roll
                                     : static_cast<Lasting>(at - lasting_words().begin());
}

/// The soft engine's step: a time, or a share of the Rayleigh time.
void read_step(Section& in, Run& run) {
  const Wanted step("time_step", "s", positive, "time step of the soft engine"), share(step_share);
  if (in.one_of({step.key, share.key}) == step.key) {
    run.time_step = in.value(step);
    return;
  }
  run.time_step_fraction = in.value(share);
}

}  // namespace

Contact read_contact(const Node* table, const std::vector<BallSet>& balls, double field,
                     Findings& findings) {
  Contact contact;
  Section in(table, "contact", findings);
  const auto model = read_contact_model(in);
  contact.model = model.value_or(contact::ContactModel());
  contact.rule = read_rule(in, nullptr);
  // Bounces in a stronger field are as much shorter as all motion in the mill is (man.4).
  constexpr double one_g = 9.80665;  // [m/s2]
  const double strength = field / one_g;
  const std::string source = fmt::format(
      "a few times a steel ball's contact time at 1 g; this mill's field is {:.3g} g and "
      "its motion shorter by the root of that",
      strength);
  for (const auto& one : contact_fields()) {
    Wanted wanted(one);
    if (one.value == &Contact::lasting_friction && std::isfinite(contact.rule.friction))
      wanted = wanted.with_default(contact.rule.friction, "the friction of bounces");
    if (one.value == &Contact::contact_time && strength > 1)
      wanted = wanted.with_default(*wanted.standard / std::sqrt(strength), source);
    contact.*one.value = in.value(wanted);
  }
  read_touch(in, contact, model, nullptr);
  contact.lasting = read_lasting(in, balls_count(balls) > 1);
  const Node* pairs = in.find("pairs");
  in.close();
  contact.pairs = read_pairs(pairs, contact, model, findings);
  return contact;
}

namespace {

constexpr std::string_view until_word = "until";

/// time = "60 s", or "until 2 %".
void read_time(Section& in, Run& run) {
  const Node* at = in.find("time");
  const bool waits =
      at != nullptr && at->kind == Node::Kind::text && at->text.starts_with(until_word);
  for (const auto& field : run_fields())
    if (!waits || field.value != &Run::time) run.*field.value = in.value(Wanted(field));
  if (!waits) return;
  Node share = *at;
  share.text.erase(0, until_word.size());
  share.text.erase(0, share.text.find_first_not_of(' '));
  const Wanted wanted("time", "", until_range,
                      "the half-width of the confidence interval over the mean: \"until 2 %\"");
  run.until = Until{.within = in.quantity(share, wanted),
                    .quantity = in.choice({"until", until_words(), until_words().front(),
                                           "what the mill's user pays for"})};
  in.note("time", in_quotes(at->text), at);
  run.time = in.value(Wanted(longest));
}

}  // namespace

Run read_run(const Node* table, Findings& findings) {
  Run run;
  Section in(table, "run", findings);
  run.engine = word_of<EngineName>(
      in.choice({"engine", engines(), "auto", "chosen by what the case needs"}), engines());
  read_time(in, run);
  run.start_frame = in.choice({"start_frame", start_frames(), "laboratory", "paper A"}) == "jar"
                        ? StartFrame::jar
                        : StartFrame::laboratory;
  read_step(in, run);
  run.hop = in.flag("hop", true, "the clock of the soft engine hops over free flight");
  if (const auto replicates = in.whole("replicates", most_replicates)) {
    run.replicates = *replicates;
  } else {
    run.replicates = 5;
    in.note_default("replicates", "5", "as in paper A");
  }
  in.close();
  return run;
}

Observe read_observe(const Node* table, Findings& findings) {
  Observe observe;
  Section in(table, "observe", findings);
  for (const auto& field : observe_fields()) observe.*field.value = in.value(Wanted(field));
  observe.collisions = in.flag("collisions", false, "no record of every collision is kept");
  observe.frames = in.maybe({"frames", "s", positive, "time between two frames for replay"});
  const std::string format =
      in.choice({"frames_format", frames_formats(), "both", "for OVITO and for ParaView"});
  observe.frames_format = format == "xyz"   ? FramesFormat::xyz
                          : format == "vtk" ? FramesFormat::vtk
                                            : FramesFormat::both;
  in.close();
  return observe;
}

}  // namespace mahlwerk::cases
