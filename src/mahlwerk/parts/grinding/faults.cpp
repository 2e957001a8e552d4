// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/grinding/faults.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/sections/grinding_fields.hpp"
#include "mahlwerk/powder/models.hpp"

namespace mahlwerk::parts::grinding {
namespace {

using cases::Case;
using cases::Grinding;

class GrindingCheck {
 public:
  GrindingCheck(const Case& c, std::vector<Fault>& found) : c_(c), found_(found) {}

  void all() {
    if (c_.capture) capture();
    if (c_.grinding) grinding(*c_.grinding);
  }

 private:
  void fault(const std::string& key, std::string what, std::string remedy, std::string code) {
    found_.push_back(
        {cases::location_of(c_, key), std::move(what), std::move(remedy), std::move(code)});
  }

  void capture() {
    const auto needs = [&](std::string_view what, std::string remedy) {
      fault("capture.model", fmt::format("[capture] needs {}", what), std::move(remedy),
            "missing-value");
    };
    if (!c_.powder) return needs("a powder to capture", "add [powder] with mass, density and size");
    if (!c_.powder->density)
      needs("the density of the powder's solid",
            "write density = \"2650 kg/m3\" or so in [powder], or material with a name from "
            "`mahlwerk list materials`");
    if (!sized())
      needs("the size of the powder as fed",
            "write size = \"1 mm\" or so in [powder], or a distribution");
    else
      feed();
    if (c_.powder->grain_size)
      fault("powder.as", "powder that is simulated as grains cannot use [capture] as well",
            "leave out `as`: the captured mass then follows from collisions of the balls",
            "grains-and-capture");
    const auto* barrios = std::get_if<powder::Barrios>(&*c_.capture->model);
    const bool known = c_.grinding && powder::has_median_strength(*c_.grinding->breakage);
    if (barrios != nullptr && barrios->fracture_energy == 0 && !known)
      fault("capture.fracture_energy",
            "capture.fracture_energy = 0 uses that of [breakage], which has none",
            "give a value, or choose [breakage] model = \"tavares\"", "missing-value");
  }

  void feed() {
    const double largest = c_.powder->feed.largest(), ball = cases::smallest_ball(c_.balls);
    if (!(largest >= ball)) return;
    fault(
        c_.powder->feed.law == powder::Feed::Law::sieves ? "powder.passing" : "powder.size",
        fmt::format("the powder's largest grains ({}) are not smaller than the smallest ball ({})",
                    show_rounded(largest, "m"), show_rounded(ball, "m")),
        "give larger balls or a finer powder", "powder-too-coarse");
  }

  void grinding(const Grinding& g) {
    if (!c_.capture)
      fault("grinding.time", "[grinding] needs [capture]: the powder that a collision captures",
            "add [capture] with model = \"barrios\" or another", "lone-section");
    const auto* t10 = std::get_if<powder::T10Fragments>(&*g.fragments);
    const auto& [told, name] = std::visit(
        [](const auto& m) {
          bool read = true;
          for (const auto& field : m.fields()) read = read && !std::isnan(m.*field.value);
          return std::pair{m.predicts_t10 || !read, m.name};
        },
        *g.breakage);
    if (t10 != nullptr && t10->t10 == 0 && !told)
      fault(
          "fragments.model",
          fmt::format("[fragments] lacks `t10`, and [breakage] model = \"{}\" predicts none", name),
          "write t10 = 0.3 or so, or choose \"shi-kojovic\" or \"tavares\"", "missing-value");
    const bool remembers = powder::tracks_strength(*g.breakage);
    if (remembers && g.bed == powder::Bed::mixed && g.method != Grinding::Method::statistical)
      fault("grinding.bed",
            "the balance of a mixed bed under tavares would take hours: its thousand states are "
            "computed again at each change of the bed",
            "write method = \"statistical\", or bed = \"by-size\"", "mixed-tavares");
    if (sized()) classes(g);
  }

  /// Whether the feed has a largest size.
  bool sized() const {
    if (!c_.powder) return false;
    const powder::Feed& feed = c_.powder->feed;
    return feed.law == powder::Feed::Law::sieves ? feed.passing.size() > 1 : feed.size != 0;
  }

  void classes(const Grinding& g) {
    const double largest = c_.powder->feed.largest(), octaves = math::log2(largest / g.smallest);
    if (octaves <= 0) {
      fault("grinding.smallest",
            fmt::format("smallest ({}) is not below the largest grains as fed ({})",
                        show_rounded(g.smallest, "m"), show_rounded(largest, "m")),
            fmt::format("write smallest = \"{}\" or so, or leave it out",
                        show_rounded(largest / cases::octaves_below, "m", 2)),
            "out-of-range");
      return;
    }
    const bool remembers = powder::tracks_strength(*g.breakage);
    const double most = remembers ? cases::max_strength_tracking_classes : cases::max_size_classes;
    const auto per_octave = static_cast<double>(g.classes_per_octave);
    const double count = std::ceil(octaves * per_octave);
    if (!(count > most)) return;
    const double enough = 1.05 * largest / math::exp2(std::floor(most / per_octave));
    fault(
        "grinding.smallest",
        fmt::format("{} classes in each of the {:.1f} octaves from {} to {} are {:.0f}, more than "
                    "{:.0f}",
                    g.classes_per_octave, octaves, show_rounded(g.smallest, "m"),
                    show_rounded(largest, "m"), count, most),
        fmt::format("write smallest = \"{}\" or more, or fewer classes_per_octave",
                    show_rounded(enough, "m", 2)),
        "too-many-classes");
  }

  const Case& c_;
  std::vector<Fault>& found_;
};

}  // namespace

void check(const Case& c, std::vector<Fault>& found) {
  GrindingCheck(c, found).all();
}

}  // namespace mahlwerk::parts::grinding
