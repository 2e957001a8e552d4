// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The sizes of the powder, [capture], [breakage], [fragments], [grinding] and [kinetics].
#include <fmt/format.h>

#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/grinding_fields.hpp"
#include "mahlwerk/cases/writer.hpp"

namespace mahlwerk::cases {
namespace {

template <class... Models>
void write_model(Writer& out, const std::string& section, const std::variant<Models...>& any) {
  out.section(fmt::format("[{}]", section), section + ".");
  std::visit(
      [&](const auto& model) {
        out.word("model", model.name);
        out.fields(model, model.fields());
      },
      any);
}

void write_capture(Writer& out, const Capture& capture) {
  write_model(out, "capture", capture.model);
  out.word("energy", word_for(capture.energy, capture_energies()));
  out.fields(capture, std::array{energy_share});
}

void write_own(Writer& out, const Grinding& g) {
  out.section("[grinding]", "grinding.");
  out.fields(g, std::array{grinding_time});
  out.word("method", word_for(g.method, grinding_methods()));
  if (g.method != Grinding::Method::balance) out.line("sample", std::to_string(g.sample));
  out.word("bed", word_for(g.bed, bed_words()));
  out.fields(g, std::array{smallest_size});
  out.line("classes_per_octave", std::to_string(g.classes_per_octave));
  out.fields(g, grinding_shares());
  if (g.sticking_size) out.number("sticking_size", *g.sticking_size, "m");
  out.fields(g, std::array{welding_energy});
}

void write_kinetics(Writer& out, const Kinetics& k) {
  const bool avrami = k.conversion.exponent != 1;
  out.section("[kinetics]", "kinetics.");
  out.word("law", kinetics_laws()[avrami ? 1 : 0]);
  for (const auto& field : kinetics_fields())
    if (avrami || field.value != &powder::Conversion::exponent)
      out.number(field.key, k.conversion.*field.value, field.unit);
  out.word("dose", word_for(k.dose, dose_words()));
  out.fields(k, std::array{kinetics_time});
  if (k.property.empty()) return;
  out.word("property", k.property);
  out.number("initial", k.initial, "");
  out.number("final", k.final, "");
}

}  // namespace

void write_feed(Writer& out, const Powder& powder) {
  using Law = powder::Feed::Law;
  const powder::Feed& feed = powder.feed;
  if (feed.law == Law::equal) {
    if (powder.size) out.number("size", *powder.size, "m");
    return;
  }
  out.word("distribution", word_for(feed.law, feed_words()));
  if (feed.law == Law::sieves) {
    out.line("passing", passing_text(feed.passing));
    return;
  }
  out.number("size", feed.size, "m");
  out.number("spread", feed.spread, "");
}

void write_grinding(Writer& out, const Case& c) {
  if (c.capture) write_capture(out, *c.capture);
  if (c.grinding) {
    write_model(out, "breakage", c.grinding->breakage);
    write_model(out, "fragments", c.grinding->fragments);
    write_own(out, *c.grinding);
  }
  if (c.kinetics) write_kinetics(out, *c.kinetics);
}

}  // namespace mahlwerk::cases
