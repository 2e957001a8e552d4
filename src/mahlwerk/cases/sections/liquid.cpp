// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [liquid]: films on the bodies, or a jar full of liquid.
#include <fmt/format.h>

#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

/// A property of the liquid: given, or that of its material. A fault if neither gives it.
void describe_property(KeyVisitor& v, const NumberSpec& spec, std::string& material, double& value,
                       const char* example) {
  SectionReader* in = v.reader();
  if (in == nullptr) return v.number(spec.with_default_text("that of the material"), value);
  const auto given = read_of_material(*in, spec, material);
  if (!given)
    in->missing(spec.key, spec.about,
                fmt::format("write {} = \"{}\", or material with the name of a liquid from "
                            "`mahlwerk list materials`",
                            spec.key, example));
  value = given.value_or(invalid_value);
}

}  // namespace

void describe(KeyVisitor& v, Liquid& liquid) {
  contact::Liquid& model = liquid.model;
  std::size_t kind = model.flooded ? 1 : 0;
  const bool known = v.choose({"kind",
                               {"film", "flooded"},
                               "",
                               "",
                               "where the liquid is",
                               {"a thin film on each ball and on the wall: liquid-assisted milling",
                                "the jar is full of liquid, which turns with it: wet milling"}},
                              kind);
  model.flooded = kind == 1;
  if (!known) return v.ignore_unknown_keys();
  describe_property(v, {"viscosity", "Pa s", positive, "dynamic viscosity of the liquid"},
                    liquid.material, model.viscosity, "1 mPa s");
  if (model.flooded) {
    describe_property(v, {"density", "kg/m3", positive, "density of the liquid"}, liquid.material,
                      model.density, "998 kg/m3");
    v.number({"reach",
              "",
              {.least = 0, .most = 1, .without_least = true},
              "gap at which lubrication begins, over the effective radius",
              contact::Liquid().reach,
              "there lubrication is as small as the drag of the balls (liq.2)"},
             model.reach);
    v.flag({"drag", true, "the liquid resists the motion of a ball through it",
            "whether drag and the pressure of the liquid act on each ball"},
           model.drag);
    v.refuse({"film"}, "with kind = \"flooded\"", "remove it, or write kind = \"film\"");
  } else {
    v.number(NumberSpec("film", "m", positive, "thickness of the film on each ball and on the wall")
                 .plausible_within("", "1 mm"),
             model.film);
    v.refuse({"density", "reach", "drag"}, "with kind = \"film\"",
             "remove it, or write kind = \"flooded\"");
  }
  v.text({"material", "the liquid, by its name in the catalogue"}, liquid.material);
  v.number(NumberSpec("roughness", "m", positive,
                      "separation of the mean surfaces of bodies whose asperities touch",
                      contact::Liquid().roughness, "a worn ball; uncalibrated, 0.1-10 um")
               .plausible_within("", "1 mm"),
           model.roughness);
  std::size_t rebound = model.resists_rebound ? 1 : 0;
  v.choose({"rebound",
            {"cavitates", "resists"},
            "cavitates",
            "no liquid bears the tension of a fast rebound (liq.4)",
            "what the liquid does between bodies that separate",
            {"it cavitates: no force", "it pulls as much as it pushes on approach"}},
           rebound);
  model.resists_rebound = rebound == 1;
}

}  // namespace mahlwerk::cases
