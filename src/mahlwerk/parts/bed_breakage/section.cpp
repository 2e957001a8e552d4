// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/bed_breakage/section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::parts::bed_breakage {
namespace {

using cases::BedBreakage;
using cases::Case;
using cases::NumberSpec;

constexpr std::int64_t most_grains = 10000000;

void describe_spheres(cases::KeyVisitor& v, BedBreakage& bed, const Case& c) {
  if (v.reader() != nullptr && cases::coarse_grains(c))
    return v.refuse({"smallest", "largest_number"},
                    "where grain_size exceeds the size of the powder: the spheres keep their size",
                    "remove it, or leave grain_size out");
  v.optional_number(
      NumberSpec("smallest", "m", positive, "smallest fragment that is simulated as a sphere")
          .with_default_text("a quarter of the grains"),
      bed.smallest);
  if (v.reader() == nullptr ? bed.largest_number || v.visits_all() : v.gives("largest_number")) {
    std::int64_t number = bed.largest_number.value_or(10000);
    v.integer({"largest_number", 1, most_grains,
               "largest number of grains at a time; beyond it, grains that break stand for many "
               "finer ones",
               std::nullopt, "", "four times the grains at the start"},
              number);
    bed.largest_number = number;
  }
}

class BedBreakageCheck {
 public:
  BedBreakageCheck(const Case& c, std::vector<Fault>& found)
      : c_(c), bed_(*c.bed_breakage), found_(found) {}

  void all() {
    if (!c_.powder || !c_.powder->grain_size)
      return fault("powder.as", "grains break only where the powder is simulated as grains",
                   "write as = \"grains\" in [powder], or remove [bed_breakage]");
    law();
    others();
    sizes();
    interval();
  }

 private:
  void fault(const char* key, std::string what, std::string remedy) {
    found_.push_back(
        {cases::location_of(c_, key), std::move(what), std::move(remedy), "bad-bed-breakage"});
  }
  /// The energy of a contact follows from force and overlap for laws without adhesion and history.
  void law() {
    const std::string_view law = contact::name_of(*c_.contact.model.law);
    if (law != "hertz-mindlin" && law != "linear-spring")
      fault("contact.law", fmt::format("law = \"{}\" with grains that break", law),
            "write law = \"hertz-mindlin\" or \"linear-spring\", or remove [bed_breakage]");
  }
  void others() {
    if (c_.flow)
      fault("flow.outlet", "grains that break in a jar that balls leave and enter",
            "remove [flow] or [bed_breakage]");
    if (c_.liquid)
      fault("liquid", "grains that break in a liquid", "remove [liquid] or [bed_breakage]");
    if (cases::has_bodies(c_))
      fault("balls.1.shape", "grains that break among balls that are no spheres",
            "leave the shapes out, or remove [bed_breakage]");
    if (std::ranges::any_of(cases::parts_of(c_),
                            [](const cases::Part* part) { return part->name == "mixing"; }))
      fault("mixing.colour", "grains that break have no colour to mix",
            "remove [mixing] or [bed_breakage]");
    if (c_.observe.final_state)
      fault("observe.final_state", "final_state = true: no run can start from grains that broke",
            "leave final_state out");
    if (c_.balls.back().classes.size() > 1 || c_.balls.back().layers().layered())
      fault("powder.size", "grains that break must be spheres of one size",
            "leave the distribution of the spheres out");
  }
  void sizes() {
    const double grain = *c_.powder->grain_size;
    if (bed_.smallest && !(*bed_.smallest < grain))
      fault("bed_breakage.smallest",
            fmt::format("fragments of {} are no smaller than the grains ({})",
                        show_rounded(*bed_.smallest, "m"), show_rounded(grain, "m")),
            "give a smaller size, or leave it out");
    const powder::BedBreakage bed = cases::bed_breakage(c_);
    const double limit = bed.coarse ? bed.feed.smallest() : bed.smallest_fragment;
    if (!(bed.finest < limit * (1 - 1e-9)))
      fault("bed_breakage.finest",
            fmt::format("a finest size of {} is not below {}", show_rounded(bed.finest, "m"),
                        show_rounded(limit, "m")),
            "give a smaller size, or leave it out");
    else if (limit / bed.finest > 1e5)
      fault("bed_breakage.finest",
            fmt::format("a finest size of {} is more than 1e5 times below {}",
                        show_rounded(bed.finest, "m"), show_rounded(limit, "m")),
            "give a larger size, or leave it out");
    if (bed_.largest_number && *bed_.largest_number < c_.balls.back().count)
      fault("bed_breakage.largest_number",
            fmt::format("largest_number = {} is below the grains at the start ({})",
                        *bed_.largest_number, c_.balls.back().count),
            "give a larger number, or leave it out");
  }
  void interval() {
    const double counted = cases::counted_time(c_);
    constexpr double most_rows = 1000;
    if (bed_.interval && (*bed_.interval > counted || *bed_.interval < counted / most_rows))
      fault("bed_breakage.interval",
            fmt::format(
                "an interval of {} is not within the counted time ({}) and a thousandth of it",
                show_rounded(*bed_.interval, "s"), show_rounded(counted, "s")),
            "give another interval, or leave it out");
  }

  const Case& c_;
  const BedBreakage& bed_;
  std::vector<Fault>& found_;
};

}  // namespace

void describe(cases::KeyVisitor& v, BedBreakage& bed, const Case& c) {
  describe_spheres(v, bed, c);
  v.optional_number(NumberSpec("finest", "m", positive, "finest size that is resolved")
                        .with_default_text("a 16th of `smallest`; a 64th of the powder where "
                                           "grains stand for many particles"),
                    bed.finest);
  v.integer({"classes_per_octave", 3, 12, "size classes for a factor of two, a multiple of three",
             BedBreakage().classes_per_octave, "half the volume is one class below"},
            bed.classes_per_octave);
  if (cases::SectionReader* in = v.reader(); in != nullptr && bed.classes_per_octave % 3 != 0)
    in->fault(*in->find("classes_per_octave"),
              fmt::format("classes_per_octave = {} is not a multiple of 3", bed.classes_per_octave),
              "write 3, 6, 9 or 12", "out-of-range");
  v.optional_number(
      NumberSpec("interval", "s", positive, "time between two rows of bed_breakage.csv")
          .with_default_text("a hundredth of the counted time"),
      bed.interval);
}

void check(const Case& c, std::vector<Fault>& found) {
  BedBreakageCheck(c, found).all();
}

}  // namespace mahlwerk::parts::bed_breakage
