// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [kinetics]: what a dose of energy does.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/grinding_fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

/// A property goes from a first value to a last one.
void read_property(Section& in, Kinetics& k) {
  if (in.gives("property")) k.property = in.text("property").value_or("");
  if (k.property.empty()) {
    in.refuse({"initial", "final"}, "without `property`",
              "remove it, or write property = \"amorphous content\" or so");
    return;
  }
  k.initial = in.value({"initial", "", any_number, "the property before milling, in its own unit"});
  k.final = in.value({"final", "", any_number, "the property of what is all converted"});
}

}  // namespace

Kinetics read_kinetics(const Node* table, const Case& c, Findings& findings) {
  Kinetics k;
  Section in(table, "kinetics", findings);
  const bool avrami =
      in.choice({"law", kinetics_laws(), "first-order", "the simplest"}) == "avrami";
  for (const auto& field : kinetics_fields()) {
    const bool exponent = field.value == &powder::Conversion::exponent;
    if (exponent && !avrami) continue;
    if (in.gives(field.key) || field.standard)
      k.conversion.*field.value = in.value(Wanted(field));
    else
      in.missing(field.key, field.about,
                 fmt::format("write for instance {} = \"{}\", or let `mahlwerk fit` find it from "
                             "what was measured",
                             field.key, example_of(field.unit)));
  }
  if (!avrami)
    in.refuse({"exponent"}, "under law = \"first-order\"", "remove it, or write law = \"avrami\"");
  k.dose = word_of<Kinetics::Dose>(
      in.choice({"dose", dose_words(), "dissipated", "all that the collisions lose"}),
      dose_words());
  k.time = read_milling_time(in, Wanted(kinetics_time), c);
  read_property(in, k);
  in.close();
  return k;
}

}  // namespace mahlwerk::cases
