// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"
#include "mahlwerk/cases/register.hpp"

namespace mahlwerk::cases {
namespace {

using kinematics::Planetary;
using kinematics::Tabulated;
using kinematics::Tumbling;

/// "1:-2" as a number, jar over disc; other texts as they are.
double ratio_of(Section& in, const Node& at, const Wanted& wanted) {
  const auto colon = at.text.find(':');
  if (at.kind != Node::Kind::text || colon == std::string::npos) return in.quantity(at, wanted);
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
  return unread;
}

double read_ratio(Section& in, const Wanted& wanted) {
  const Node* at = in.find(wanted.key);
  const bool said = in.gives("ratio_convention");
  const std::string convention = in.choice({"ratio_convention",
                                            {"relative", "absolute"},
                                            "relative",
                                            "the makers' convention, jar relative to disc"});
  if (at == nullptr) return in.value(wanted);
  if (said && at->rank == Rank::catalogue) {
    in.fault(*in.find("ratio_convention"), "ratio_convention is given without a ratio",
             "give `ratio` too, or remove it", "missing-value");
    return unread;
  }
  const double given = ratio_of(in, *at, wanted);
  if (std::isnan(given)) return unread;
  const double ratio = convention == "absolute" ? given - 1 : given;  // (kin.12)
  in.note(wanted.key, show(ratio, ""), at,
          convention == "absolute"
              ? fmt::format("ratio = {} with the jar's absolute speed", at->text)
              : "");
  // Stored relative, whatever was said.
  for (Origin& o : in.findings().origins)
    if (o.key == "mill.ratio_convention") o.value = "\"relative\"";
  return ratio;
}

/// A drum's speed, which may be given as a share of the critical one.
double read_drum_speed(Section& in, const Wanted& wanted, const Case& c) {
  const Node* at = in.find(wanted.key);
  if (at == nullptr || at->kind != Node::Kind::text || at->text.find('%') == std::string::npos)
    return in.value(wanted);
  const double share = in.quantity(*at, {wanted.key, "", any_number, wanted.about});
  const double critical = critical_speed(c.jar, c.balls, c.gravity);
  const double speed = share * critical;
  if (std::isnan(share)) return unread;
  if (!std::isfinite(speed)) return 0;  // a ball larger than the drum, which is reported as such
  in.note(
      wanted.key, show(speed, wanted.unit), at,
      fmt::format("{} of the critical speed {}", at->text, show_rounded(critical, wanted.unit)));
  return speed;
}

/// What the maker of a catalogue's mill offers.
void check_offer(Section& in, const Wanted& wanted, double value, const CatalogueEntry& entry) {
  const Node* at = in.find(wanted.key);
  if (at == nullptr || at->rank == Rank::catalogue) return;
  const auto offered = [&](std::string_view end) -> std::optional<double> {
    const auto found = entry.values.find(fmt::format("{}_{}", wanted.key, end));
    if (found == entry.values.end()) return std::nullopt;
    return parse_in(found->second.text, wanted.unit);
  };
  try {
    const auto least = offered("least"), most = offered("most");
    const bool low = least && value < *least, high = most && value > *most;
    if (!low && !high) return;
    const auto text = [&](std::string_view end) {
      const auto found = entry.values.find(fmt::format("{}_{}", wanted.key, end));
      return found == entry.values.end() ? std::string("any") : found->second.text;
    };
    in.fault(*at,
             fmt::format("{} = \"{}\" is outside what {} offers: {} to {}", wanted.key, at->text,
                         entry.title, text("least"), text("most")),
             "stay within it, or give `kind` and the mill's own numbers instead of `model`",
             "outside-mill-range");
  } catch (const UnitError&) {
    return;  // a "1:-2" among ranges, which the catalogue's own tests look after
  }
}

template <class M>
void read_motion(Section& in, M& motion, const Case& c, const Model& model) {
  for (const auto& field : M::fields()) {
    const Wanted wanted(field);
    double value = 0;
    if constexpr (std::is_same_v<M, Planetary>) {
      value = field.key == "ratio" ? read_ratio(in, wanted) : in.value(wanted);
    } else if constexpr (std::is_same_v<M, Tumbling>) {
      value = read_drum_speed(in, wanted, c);
    } else {
      value = in.value(wanted);
    }
    if (model.entry) check_offer(in, wanted, value, *model.entry);
    motion.*field.value = value;
  }
}

void read_measured(Section& in, Mill& mill, const std::string& folder) {
  const auto file = in.text("file");
  if (!file) {
    if (!in.gives("file"))
      in.missing("file", "the measured motion", "write for instance file = \"motion.csv\"");
    return;
  }
  mill.motion_file = *file;
  const auto path = std::filesystem::path(folder) / *file;
  mill.motion =
      read_motion_file(path.generic_string(), mill.jar_axis, *in.find("file"), in.findings());
}

Vec3 read_axis(Section& in, const Vec3& standard) {
  const std::string word = in.choice(
      {"jar_axis", {"vertical", "horizontal"}, axis_word(standard), "as such mills are built"});
  if (word.empty()) return standard;
  return word == "vertical" ? kinematics::upright : kinematics::lying;
}

}  // namespace

namespace {

std::int64_t read_jars(Section& in) {
  const Wanted wanted("jars_carried", "", {.least = 1, .most = most_jars},
                      "how many jars, all alike, the mill carries");
  const double jars = in.maybe(wanted).value_or(1);
  if (const Node* at = in.find(wanted.key); at != nullptr && jars != std::round(jars))
    in.fault(*at, "`jars_carried` must be a whole number", "write for instance jars_carried = 2",
             "out-of-range");
  return std::isnan(jars) ? 1 : std::llround(jars);
}

}  // namespace

Mill read_mill(const Node* table, const Case& c, const std::string& folder,
               const Catalogue& catalogue, Findings& findings) {
  Mill mill;
  Section in(table, "mill", findings);
  const auto kinds = model_names(std::type_identity<kinematics::AnyMotion>{});
  const Model model = read_model(in, "mills", kinds, catalogue);
  mill.model = model.name;
  if (!choose_model(mill.motion, model.kind)) return mill;
  mill.jar_axis =
      read_axis(in, std::visit([](const auto& m) -> Vec3 { return m.jar_axis; }, mill.motion));
  if (std::holds_alternative<Tabulated>(mill.motion))
    read_measured(in, mill, folder);
  else
    std::visit([&](auto& motion) { read_motion(in, motion, c, model); }, mill.motion);
  mill.jars_carried = read_jars(in);
  in.close();
  return mill;
}

}  // namespace mahlwerk::cases
