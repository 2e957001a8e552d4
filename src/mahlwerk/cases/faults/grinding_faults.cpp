// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Powder that does not fit its jar, and inconsistent sections of grinding.
#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"
#include "mahlwerk/cases/sections/grinding_fields.hpp"
#include "mahlwerk/powder/models.hpp"

namespace mahlwerk::cases {
namespace {

class GrindingCheck {
 public:
  GrindingCheck(const Case& c, std::vector<Fault>& found) : c_(c), found_(found) {}

  void all() {
    if (c_.capture) capture();
    if (c_.grinding) grinding(*c_.grinding);
    if (c_.kinetics) kinetics(*c_.kinetics);
  }

 private:
  void fault(const std::string& key, std::string what, std::string remedy, std::string code) {
    found_.push_back({location_of(c_, key), std::move(what), std::move(remedy), std::move(code)});
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
    const double largest = c_.powder->feed.largest(), ball = smallest_ball(c_.balls);
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
                        show_rounded(largest / octaves_below, "m", 2)),
            "out-of-range");
      return;
    }
    const bool remembers = powder::tracks_strength(*g.breakage);
    const double most = remembers ? max_strength_tracking_classes : max_size_classes;
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

  void kinetics(const Kinetics& k) {
    const bool by_dose = std::holds_alternative<powder::DoseKinetics>(*k.model);
    if (!c_.powder)
      fault(by_dose ? "kinetics.dose_constant" : "kinetics.model",
            "[kinetics] needs a powder that takes the dose", "add [powder] with mass",
            "missing-value");
    if (k.dose == Kinetics::Dose::captured && !c_.capture)
      fault("kinetics.dose",
            "dose = \"captured\" needs [capture]: the powder that collisions capture",
            "add [capture], or write dose = \"dissipated\"", "lone-section");
    if (const auto* m = std::get_if<powder::ImpactKinetics>(&*k.model)) by_impact(k, *m);
    if (powder::reads_temperature(*k.model) && !k.temperature && !c_.heat)
      fault("kinetics.model",
            fmt::format("[kinetics] model = \"{}\" needs the temperature of the powder",
                        powder::name_of(*k.model)),
            "write temperature = \"60 degC\" or so, or add [heat]", "missing-value");
    if (const auto* m = std::get_if<powder::IgnitionKinetics>(&*k.model);
        m != nullptr && m->milled_temperature > m->ignition_temperature)
      fault("kinetics.milled_temperature",
            fmt::format("milling would raise the ignition temperature, from {} to {}",
                        show_rounded(m->ignition_temperature, "K"),
                        show_rounded(m->milled_temperature, "K")),
            "give a milled_temperature of at most ignition_temperature", "out-of-range");
  }

  void by_impact(const Kinetics& k, const powder::ImpactKinetics& m) {
    if (!c_.capture && !k.mass_per_hit)
      fault("kinetics.model",
            "[kinetics] model = \"by-impact\" needs the mass of powder that a hit captures",
            "add [capture], or write mass_per_hit = \"1 mg\" or so", "missing-value");
    if (m.scheme == powder::ImpactKinetics::Scheme::parallel && m.energy_exponent == 0 &&
        m.processed_share + m.second_share > 1)
      fault("kinetics.second_share",
            fmt::format("both reactions would process {:.4g} times the powder that a hit captures",
                        m.processed_share + m.second_share),
            "give shares with a sum of at most 1", "out-of-range");
  }

  const Case& c_;
  std::vector<Fault>& found_;
};

}  // namespace

void bad_powder(const Case& c, std::vector<Fault>& found) {
  if (!c.powder || !c.powder->density || c.powder->grain_size) return;  // grains are ball sets
  const double powder = c.powder->mass / *c.powder->density, balls = balls_volume(c.balls);
  const double jar = jar_volume(c.jar);
  if (!(powder + balls > jar)) return;
  found.push_back(
      {location_of(c, "powder.mass"),
       fmt::format("the powder's solid ({}) and the balls ({}) are more than the jar "
                   "holds ({})",
                   show_rounded(powder, "m3"), show_rounded(balls, "m3"), show_rounded(jar, "m3")),
       "give less powder, fewer balls or a larger jar", "powder-too-much"});
}

void bad_grinding(const Case& c, std::vector<Fault>& found) {
  GrindingCheck(c, found).all();
}

}  // namespace mahlwerk::cases
