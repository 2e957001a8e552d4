// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [kinetics]: conversion of powder by a dose of energy.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/grinding_fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

void describe_conversion(KeyVisitor& v, const NumberSpec& spec, double& value) {
  SectionReader* in = v.reader();
  if (in == nullptr || in->gives(spec.key) || spec.standard) return v.number(spec, value);
  in->missing(spec.key, spec.about,
              fmt::format("write for instance {} = \"{}\", or let `mahlwerk fit` find it from "
                          "measurements",
                          spec.key, example_of(spec.unit)));
}

/// A property that changes from an initial to a final value with conversion.
void describe_property(KeyVisitor& v, Kinetics& k) {
  v.text({"property", "name of a property that changes in proportion to conversion"}, k.property);
  if (k.property.empty() && !v.visits_all())
    return v.refuse({"initial", "final"}, "without `property`",
                    "remove it, or write property = \"amorphous content\" or so");
  v.number({"initial", "", any_number, "the property before milling, in its own unit"}, k.initial);
  v.number({"final", "", any_number, "the property after complete conversion"}, k.final);
}

}  // namespace

void describe(KeyVisitor& v, Kinetics& k, const Case& c) {
  std::size_t avrami = k.conversion.exponent != 1 ? 1 : 0;
  v.choose({"law",
            {"first-order", "avrami"},
            "first-order",
            "the simplest law",
            "conversion as a function of the dose",
            {"rate in proportion to what is not converted", "Avrami's law, with an exponent"}},
           avrami);
  for (const auto& field : kinetics_fields())
    if (avrami || field.value != &powder::Conversion::exponent)
      describe_conversion(v, NumberSpec(field), k.conversion.*field.value);
  if (!avrami)
    v.refuse({"exponent"}, "under law = \"first-order\"", "remove it, or write law = \"avrami\"");
  v.word({"dose",
          {"dissipated", "captured"},
          "dissipated",
          "all energy that collisions lose",
          "energy that counts as dose, by mass of powder",
          {"all energy that collisions dissipate", "energy that captured powder receives"}},
         k.dose);
  describe_milling_time(v, {"time", "s", positive, "milling time"}, k.time, c, false);
  describe_property(v, k);
}

}  // namespace mahlwerk::cases
