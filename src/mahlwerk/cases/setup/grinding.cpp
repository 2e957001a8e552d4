// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/grinding.hpp"

#include <limits>
#include <stdexcept>

#include "mahlwerk/cases/sections/grinding_fields.hpp"
#include "mahlwerk/powder/models.hpp"

namespace mahlwerk::cases {
namespace {

/// Calls `visit(key, field, number)` for every fit parameter. `C` is Case or const Case.
template <class C, class Visit>
void each_number(C& c, Visit visit) {
  const auto all = [&](const std::string& section, auto& model, const auto& fields) {
    for (const auto& f : fields) visit(section + std::string(f.key), f, model.*f.value);
  };
  const auto of_model = [&](const std::string& section, auto& any) {
    std::visit([&](auto& model) { all(section, model, model.fields()); }, any);
  };
  if (c.capture) {
    of_model("capture.", *c.capture->model);
    all("capture.", *c.capture, std::array{energy_share});
  }
  if (c.grinding) {
    of_model("breakage.", *c.grinding->breakage);
    of_model("fragments.", *c.grinding->fragments);
    all("grinding.", *c.grinding, grinding_shares());
    all("grinding.", *c.grinding, std::array{welding_energy});
  }
  if (c.kinetics) of_model("kinetics.", *c.kinetics->model);
}

std::invalid_argument no_such_parameter(const std::string& key) {
  return std::invalid_argument("the case has no number \"" + key + "\" that could be adjusted");
}

}  // namespace

powder::Process process(const Case& c) {
  powder::Process p{.capture = c.capture->model,
                    .energy_share = c.capture->energy_share,
                    .breakage = {},
                    .fragments = {},
                    .density = c.powder->density.value(),
                    .mass = c.powder->mass};
  if (!c.grinding) return p;
  const Grinding& g = *c.grinding;
  p.breakage = g.breakage;
  p.fragments = g.fragments;
  p.bed = g.bed;
  p.sticking = g.sticking;
  p.sticking_size = g.sticking_size.value_or(std::numeric_limits<double>::infinity());
  p.welding = g.welding;
  p.welding_energy = g.welding_energy;
  return p;
}

std::optional<double> milling_time(const Case& c) {
  if (c.grinding) return c.grinding->time;
  if (c.kinetics) return c.kinetics->time;
  if (c.milling && c.milling->time) return c.milling->time;
  if (c.heat) return c.heat->milling * static_cast<double>(c.heat->cycles);
  return std::nullopt;
}

std::vector<FitParameter> fit_parameters(const Case& c) {
  std::vector<FitParameter> found;
  each_number(c, [&](const std::string& key, const auto& field, double) {
    found.push_back({key, std::string(field.unit), std::string(field.about), field.range});
  });
  return found;
}

void set_fit_parameter(Case& c, const std::string& key, double value) {
  bool known = false;
  each_number(c, [&](const std::string& its, const auto&, double& number) {
    if (its != key) return;
    number = value;
    known = true;
  });
  if (!known) throw no_such_parameter(key);
}

double fit_parameter_value(const Case& c, const std::string& key) {
  const double* found = nullptr;
  each_number(c, [&](const std::string& its, const auto&, const double& number) {
    if (its == key) found = &number;
  });
  if (found == nullptr) throw no_such_parameter(key);
  return *found;
}

}  // namespace mahlwerk::cases
