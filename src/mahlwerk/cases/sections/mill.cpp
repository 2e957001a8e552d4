// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::cases {
namespace {

using kinematics::Planetary;
using kinematics::Tabulated;
using kinematics::Tumbling;

/// A ratio given as "1:-2", disc to jar, as a number, jar over disc; other values as quantities.
double ratio_of(SectionReader& in, const Node& at, const NumberSpec& spec) {
  const auto colon = at.text.find(':');
  if (at.kind != Node::Kind::text || colon == std::string::npos) return in.quantity(at, spec);
  try {
    const double disc = parse_in(at.text.substr(0, colon), "");
    const double ratio = parse_in(at.text.substr(colon + 1), "") / disc;
    if (disc != 0 && std::isfinite(ratio)) return ratio;
    in.fault(at, fmt::format("ratio = \"{}\" divides by zero", at.text),
             "write disc to jar: \"1:-2\"", "bad-quantity");
  } catch (const UnitError& error) {
    in.fault(at, fmt::format("ratio = \"{}\": {}", at.text, error.what()),
             "write disc to jar, \"1:-2\", or the number -2", "bad-quantity");
  }
  return invalid_value;
}

Choice ratio_convention() {
  return {"ratio_convention",
          {"relative", "absolute"},
          "relative",
          "the makers' convention, jar relative to disc",
          "frame in which `ratio` counts the turns of the jar",
          {"relative to the disc", "in the laboratory"}};
}

double read_ratio(SectionReader& in, const NumberSpec& spec) {
  const Node* at = in.find(spec.key);
  const bool said = in.gives("ratio_convention");
  const std::string convention = in.choice(ratio_convention());
  if (at == nullptr) {
    const bool offered = in.gives("ratio_most");
    if (offered) return in.value(spec);
    in.missing(spec.key, spec.about, "write disc to jar, for instance ratio = \"1:-2\"");
    return invalid_value;
  }
  if (said && at->precedence == Precedence::catalogue) {
    in.fault(*in.find("ratio_convention"), "ratio_convention is given without a ratio",
             "give `ratio` too, or remove it", "missing-value");
    return invalid_value;
  }
  const double given = ratio_of(in, *at, spec);
  if (std::isnan(given)) return invalid_value;
  const double ratio = convention == "absolute" ? given - 1 : given;  // (kin.12)
  in.record_origin(spec.key, show(ratio, ""), at,
                   convention == "absolute"
                       ? fmt::format("ratio = {} with the jar's absolute speed", at->text)
                       : "");
  // The ratio is stored under the relative convention.
  for (Origin& o : in.findings().origins)
    if (o.key == "mill.ratio_convention") o.value = "\"relative\"";
  return ratio;
}

/// A drum's speed, which may be given as a share of the critical speed.
double read_drum_speed(SectionReader& in, const NumberSpec& spec, const Mill& mill, const Case& c) {
  const Node* at = in.find(spec.key);
  if (at == nullptr || at->kind != Node::Kind::text || at->text.find('%') == std::string::npos)
    return in.value(spec);
  if (const Node* axis = in.find("jar_axis"); axis != nullptr && axis->text == "vertical") {
    in.fault(*at, "a jar that tumbles end over end has no critical speed",
             "write the speed in rpm, or remove jar_axis = \"vertical\" for a drum",
             "bad-quantity");
    return invalid_value;
  }
  const double share = in.quantity(*at, {spec.key, "", any_number, spec.about});
  const Vec3 gravity = gravity_in_mill(c.gravity, c.gravity_direction, mill.tilt);
  const double critical = critical_speed(c.jar, c.balls, across_axis(gravity));
  const double speed = share * critical;
  if (std::isnan(share)) return invalid_value;
  if (!std::isfinite(speed)) return 0;  // a ball larger than the drum, reported elsewhere
  in.record_origin(
      spec.key, show(speed, spec.unit), at,
      fmt::format("{} of the critical speed {}", at->text, show_rounded(critical, spec.unit)));
  return speed;
}

/// A speed is compared with the range of a machine by its magnitude: a negative one reverses it.
double compared(const NumberSpec& spec, double value) {
  return spec.range.without_zero ? std::abs(value) : value;
}

/// The range of a number that the maker of a mill of the catalogue offers; as far as it says.
class OfferedRange {
 public:
  OfferedRange(const NumberSpec& spec, const CatalogueEntry& entry)
      : spec_(spec), least_(text_of(entry, "least")), most_(text_of(entry, "most")) {}

  [[nodiscard]] bool excludes(double value) const {
    try {
      const double size = compared(spec_, value);
      return (!least_.empty() && size < parse_in(least_, spec_.unit)) ||
             (!most_.empty() && size > parse_in(most_, spec_.unit));
    } catch (const UnitError&) {
      return false;  // a range of ratios like "1:-2"; the catalogue's own tests check it
    }
  }
  [[nodiscard]] bool excludes(const std::string& value) const {
    try {
      return excludes(parse_in(value, spec_.unit));
    } catch (const UnitError&) {
      return false;  // reported where the value is used
    }
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("{} to {}", least_.empty() ? "any" : least_, most_.empty() ? "any" : most_);
  }

 private:
  std::string text_of(const CatalogueEntry& entry, std::string_view end) const {
    const auto found = entry.values.find(fmt::format("{}_{}", spec_.key, end));
    return found == entry.values.end() ? std::string() : found->second.text;
  }

  const NumberSpec& spec_;
  std::string least_, most_;
};

/// Warns of a given value, and of ranges of [sweep], [optimise] and [match], beyond what the maker
/// of a mill of the catalogue offers.
void remark_on_offer(SectionReader& in, const NumberSpec& spec, double value,
                     const CatalogueEntry& entry, const Case& c) {
  const OfferedRange offered(spec, entry);
  const auto warn = [&](const std::string& what) {
    in.findings().remarks.push_back(
        warning("beyond-mill-range",
                fmt::format("{}, which {} does not offer: its range is {}. The mill itself could "
                            "not run so.",
                            what, entry.title, offered.text())));
  };
  if (const Node* at = in.find(spec.key);
      at != nullptr && at->precedence != Precedence::catalogue && offered.excludes(value))
    warn(fmt::format("mill.{} is {}", spec.key, at->text));
  const auto check = [&](std::string_view section, const std::vector<SweptKey>& keys) {
    for (const SweptKey& one : keys) {
      if (one.key != fmt::format("mill.{}", spec.key)) continue;
      const auto beyond = std::ranges::find_if(
          one.values, [&](const std::string& text) { return offered.excludes(text); });
      if (beyond != one.values.end())
        warn(fmt::format("[{}] varies {} to {}", section, one.key, *beyond));
    }
  };
  check("sweep", c.sweep.keys);
  if (c.optimise) check("optimise", c.optimise->over);
  if (c.match) check("match", c.match->over);
}

/// Reads a number of the motion, with the special forms of a mill.
template <class M>
double read_motion_number(SectionReader& in, const NumberSpec& spec, const Mill& mill,
                          const Case& c) {
  if (std::is_same_v<M, Planetary> && spec.key == "ratio") return read_ratio(in, spec);
  if (std::is_same_v<M, Tumbling>) return read_drum_speed(in, spec, mill, c);
  return in.value(spec);
}

template <class M>
void describe_motion(KeyVisitor& v, M& motion, const Mill& mill, const Case& c,
                     const Model& model) {
  SectionReader* in = v.reader();
  if (in == nullptr) {
    v.fields(motion, M::fields());
    std::size_t relative = 0;
    if (std::is_same_v<M, Planetary>) v.choose(ratio_convention(), relative);
    return;
  }
  for (const auto& field : M::fields()) {
    const NumberSpec spec(field);
    const double value = read_motion_number<M>(*in, spec, mill, c);
    if (model.entry) remark_on_offer(*in, spec, value, *model.entry, c);
    motion.*field.value = value;
  }
}

void describe_measured(KeyVisitor& v, Mill& mill) {
  SectionReader* in = v.reader();
  if (in == nullptr)
    return v.text({"file", "table of the measured motion (CSV), relative to the case file", true},
                  mill.motion_file);
  const auto file = in->text("file");
  if (!file) {
    if (!in->gives("file"))
      in->missing("file", "the measured motion", "write for instance file = \"motion.csv\"");
    return;
  }
  mill.motion_file = *file;
  const auto path = std::filesystem::path(in->findings().folder) / *file;
  mill.motion =
      read_motion_file(path.generic_string(), mill.jar_axis, *in->find("file"), in->findings());
}

void describe_axis(KeyVisitor& v, Mill& mill) {
  const Vec3 standard = std::visit([](const auto& m) -> Vec3 { return m.jar_axis; }, *mill.motion);
  const std::array axes{kinematics::upright, kinematics::lying};
  auto word_index = static_cast<std::size_t>(std::ranges::find(axes, mill.jar_axis) - axes.begin());
  const bool sound = v.choose({"jar_axis",
                               {"vertical", "horizontal"},
                               standard == kinematics::upright ? "vertical" : "horizontal",
                               "as such mills are built",
                               "direction of the axis of the mounted jar",
                               {"upright jar", "lying jar; along x"},
                               {.label = "axis of the jar"}},
                              word_index);
  if (word_index < axes.size()) mill.jar_axis = sound ? axes[word_index] : standard;
}

/// The number of jars. For a catalogue's mill its default is a plain number of the entry.
void describe_jars(KeyVisitor& v, std::int64_t& carried) {
  const NumberSpec spec("jars_carried", "", {.least = 1, .most = max_jars},
                        "number of identical jars that the mill carries");
  SectionReader* in = v.reader();
  if (in == nullptr) {
    if (carried != 1 || v.visits_all())
      v.integer(
          {spec.key, 1, max_jars, spec.about, 1, "one jar; for a mill of the catalogue its number"},
          carried);
    return;
  }
  const double jars = in->optional_number(spec).value_or(1);
  if (const Node* at = in->find(spec.key); at != nullptr && jars != std::round(jars))
    in->fault(*at, "`jars_carried` must be a whole number", "write for instance jars_carried = 2",
              "out-of-range");
  carried = std::isnan(jars) ? 1 : std::llround(jars);
}

/// The whole mill leans. A shaken jar has a `tilt` of its own, of the line of its motion.
void describe_tilt(KeyVisitor& v, Mill& mill) {
  if (std::holds_alternative<kinematics::Vibration>(*mill.motion)) return;
  const NumberSpec spec("tilt", "rad", tilts,
                        "angle by which the whole mill leans: its x axis, that of a drum, rises");
  std::optional<double> given = mill.tilt == 0 ? std::nullopt : std::optional(mill.tilt);
  v.optional_number(
      spec.with_default_text("0 deg, a level mill").with({.usual = {"0 deg", "90 deg"}}), given);
  mill.tilt = given.value_or(0);
}

/// Warns of a jar whose sizes are the case's own, if it holds much less or more than those of the
/// mill.
void remark_on_volume(SectionReader& in, const CatalogueEntry& mill, const Jar& jar) {
  constexpr double least = 0.5, most = 1.5;  // times the smallest and the largest jar
  const double volume = geometry::volume(*jar.shape);
  std::vector<double> known;
  for (const std::string& name : mill.jars) {
    const CatalogueEntry entry = in.catalogue().find("jars", name);
    if (const auto at = entry.values.find("volume"); at != entry.values.end())
      known.push_back(parse_in(at->second.text, "m3"));
  }
  if (known.empty()) return;
  const auto [small, large] = std::ranges::minmax(known);
  if (!(volume < least * small) && !(volume > most * large)) return;
  in.findings().remarks.push_back(warning(
      "jar-does-not-fit",
      fmt::format("The jar holds {}; those of {} in the catalogue hold {} to {}. Does it go "
                  "into this mill?",
                  show_rounded(volume, "m3", 3), mill.title, show_rounded(small, "m3", 3),
                  show_rounded(large, "m3", 3))));
}

/// Warns of a jar that the catalogue names for other mills only, or that does not fit the mill.
void remark_on_jar(SectionReader& in, const CatalogueEntry& mill, const Jar& jar) {
  const auto fits = [&](const CatalogueEntry& one) {
    return std::ranges::find(one.jars, jar.model) != one.jars.end();
  };
  if (jar.model.empty() || fits(mill)) return remark_on_volume(in, mill, jar);
  std::string others;
  for (const std::string& name : in.catalogue().names("mills"))
    if (const CatalogueEntry other = in.catalogue().find("mills", name); fits(other))
      others += (others.empty() ? "" : ", ") + other.title;
  if (others.empty()) return;
  std::string own;
  for (const std::string& name : mill.jars) own += (own.empty() ? "" : ", ") + name;
  in.findings().remarks.push_back(
      warning("jar-of-another-mill",
              fmt::format("The jar {} belongs to other mills ({}), not to {}{}", jar.model, others,
                          mill.title,
                          own.empty() ? ", of which the catalogue has no jar."
                                      : fmt::format(". Its jars in the catalogue: {}.", own))));
}

}  // namespace

void describe(KeyVisitor& v, Mill& mill, const Case& c) {
  Model model;
  if (!describe_kind(v, "mills", "motion of the mill", *mill.motion, mill.model, model))
    return v.ignore_unknown_keys();
  describe_tilt(v, mill);
  if (v.reader() != nullptr) describe_axis(v, mill);
  if (std::holds_alternative<Tabulated>(*mill.motion)) describe_measured(v, mill);
  if (!std::holds_alternative<Tabulated>(*mill.motion))
    std::visit([&](auto& motion) { describe_motion(v, motion, mill, c, model); }, *mill.motion);
  if (v.reader() == nullptr) describe_axis(v, mill);
  describe_jars(v, mill.jars_carried);
  describe_speed_over_time(v, mill);
  if (v.reader() != nullptr && model.entry) remark_on_jar(*v.reader(), *model.entry, c.jar);
}

}  // namespace mahlwerk::cases
