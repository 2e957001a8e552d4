// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Sections of a case on grinding: [capture], [breakage], [fragments], [grinding], [kinetics].
#include "mahlwerk/cases/grinding.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/powder/models.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::grinding_test {
namespace {

using namespace sample;
using tests::states;

const std::string capture = R"([capture]
model = "trapped-volume"
thickness = "1.3 mm"
)";
const std::string breakage = R"([breakage]
model = "vogel-peukert"
f_mat = "1 kg/J/m"
x_w_min = "0.1 J m/kg"
)";
const std::string fragments = R"([fragments]
model = "binary"
)";
const std::string grinding = R"([grinding]
time = "30 s"
)";
const std::string all = powdered + capture + breakage + fragments + grinding;
const std::string tavares = R"([breakage]
model = "tavares"
e_infinity = "100 J/kg"
d_0 = "1 mm"
phi = 1
sigma = 0.5
gamma = 5
a = 0.5
b = 0.03
)";

bool assumed(const Case& c, std::string_view key) {
  const auto at = std::ranges::find(c.origins, key, &Origin::key);
  return at != c.origins.end() && at->assumed;
}

TEST(ReadCapture, models_and_defaults) {
  EXPECT_FALSE(read_sample(powdered).capture.has_value());
  const Case c = read_sample(powdered + capture);
  EXPECT_EQ(c.capture, (Capture{powder::TrappedVolume{1.3e-3, 0.6}, Capture::Energy::normal, 1}));
  EXPECT_TRUE(assumed(c, "capture.packing"));
  EXPECT_TRUE(assumed(c, "capture.energy"));
  EXPECT_EQ(source_of(c, "capture.energy_share"),
            "default: all of it: an upper bound; uncalibrated");
  const auto read_as = [](const std::string& lines) {
    return read_sample(powdered + "[capture]\n" + lines).capture.value();
  };
  EXPECT_EQ(read_as("model = \"barrios\"\nfracture_energy = \"100 J/kg\"\nenergy = \"lost\""),
            (Capture{powder::Barrios{100}, Capture::Energy::lost, 1}));
  EXPECT_EQ(read_as("model = \"surface-layer\"\nsurface_density = \"50 g/m2\"\n"
                    "energy = \"contact-point\"\nenergy_share = \"30 %\""),
            (Capture{powder::SurfaceLayer{0.05}, Capture::Energy::contact_point, 0.3}));
  EXPECT_EQ(read_as("model = \"fixed\"\nmass = \"1 mg\"").model,
            powder::AnyCapture(powder::FixedMass{1e-6}));
}

TEST(ReadCapture, moduli_count_for_it_under_either_engine) {
  EXPECT_FALSE(assumed(read_sample(powdered), "balls.1.youngs_modulus"));
  EXPECT_TRUE(assumed(read_sample(powdered + capture), "balls.1.youngs_modulus"));
  EXPECT_TRUE(assumed(read_sample(powdered + capture), "jar.poisson_ratio"));
}

TEST(ReadCapture, faults) {
  expect_says(
      "powder that is simulated as grains cannot use [capture] as well|",
      with(powdered, "density = \"1280", "density = \"1280 kg/m3\"\nas = \"grains\"") + capture);
  expect_says("[capture] lacks `model`", powdered + "[capture]\n");
  expect_says("there is no model = \"barios\"|did you mean \"barrios\"?",
              powdered + "[capture]\nmodel = \"barios\"\n");
  expect_says("[capture] needs a powder to capture|", vial + capture);
  expect_says("[capture] needs the density of the powder's solid|",
              with(powdered, "density = \"1280", "") + capture);
  expect_says("[capture] needs the size of the powder as fed|",
              with(powdered, "size", "") + capture);
  expect_says(
      "the powder's largest grains (8 mm) are not smaller than the smallest ball (8 mm)|"
      "give larger balls or a finer powder|powder-too-coarse",
      with(powdered, "size", "size = \"8 mm\"") + capture);
  expect_says(
      "no published value is known for this powder: give it, for instance "
      "fracture_energy = \"100 J/kg\", or let `mahlwerk fit` find it from measured sizes|"
      "missing-value",
      powdered + "[capture]\nmodel = \"barrios\"\n");
  expect_says("uses that of [breakage], which has none|",
              powdered + "[capture]\nmodel = \"barrios\"\nfracture_energy = \"0 J/kg\"\n");
  expect_says("|out-of-range", powdered + capture + "energy_share = 1.1\n");
  expect_says("|unknown-key", powdered + capture + "surface_density = \"1 kg/m2\"\n");
}

TEST(ReadGrinding, defaults) {
  const Case c = read_sample(all);
  ASSERT_TRUE(c.grinding.has_value());
  EXPECT_EQ(*c.grinding, (Grinding{.breakage = powder::VogelPeukert{1, 0.1},
                                   .fragments = powder::BinaryFragments{},
                                   .time = 30,
                                   .smallest = 1.3e-3 / 4096}));
  EXPECT_EQ(source_of(c, "grinding.smallest"), "default: twelve octaves below the feed");
  for (const char* key : {"method", "bed", "smallest", "classes_per_octave", "sticking", "welding"})
    EXPECT_TRUE(assumed(c, std::string("grinding.") + key)) << key;
  EXPECT_EQ(
      read_sample(powdered + capture + tavares + fragments + grinding).grinding->classes_per_octave,
      3);
}

TEST(ReadGrinding, every_key) {
  const Case c = read_sample(all +
                             "method = \"both\"\nbed = \"mixed\"\nsmallest = \"1 um\"\n"
                             "classes_per_octave = 12\nsample = 500\nsticking = \"10 %\"\n"
                             "sticking_size = \"20 um\"\nwelding = 0.01\n"
                             "welding_energy = \"2 kJ/kg\"\n");
  EXPECT_EQ(*c.grinding, (Grinding{.breakage = powder::VogelPeukert{1, 0.1},
                                   .fragments = powder::BinaryFragments{},
                                   .method = Grinding::Method::both,
                                   .time = 30,
                                   .bed = powder::Bed::mixed,
                                   .smallest = 1e-6,
                                   .classes_per_octave = 12,
                                   .sample = 500,
                                   .sticking = 0.1,
                                   .sticking_size = 20e-6,
                                   .welding = 0.01,
                                   .welding_energy = 2000}));
}

TEST(ReadGrinding, lasts_as_long_as_the_mill_mills) {
  const std::string heat = "[heat]\nmilling = \"10 min\"\npause = \"5 min\"\ncycles = 3\n";
  const std::string timeless = powdered + capture + breakage + fragments + "[grinding]\n";
  EXPECT_EQ(read_sample(timeless + heat).grinding->time, 1800);
  expect_says("[grinding] lacks `time`", timeless);
  const std::string kinetics = "[kinetics]\ndose_constant = \"5 kJ/g\"\n";
  EXPECT_EQ(read_sample(all + kinetics).kinetics->time, 30);
  EXPECT_EQ(read_sample(powdered + heat + kinetics).kinetics->time, 1800);
  expect_says("[kinetics] lacks `time`", powdered + kinetics);
}

TEST(ReadGrinding, its_sections_stand_together) {
  expect_says("[breakage] is given without [grinding] or [bed_breakage], which use it|",
              powdered + capture + breakage);
  expect_says("[fragments] is given without [grinding]", powdered + capture + fragments);
  expect_says(
      "[grinding] needs [breakage]: which hits break a grain|add [breakage] with model = "
      "..., one of \"vogel-peukert\"",
      powdered + capture + fragments + grinding);
  expect_says("[grinding] needs [fragments]: the fragments of a broken grain|",
              powdered + capture + breakage + grinding);
  expect_says("[grinding] needs [capture]: the powder that a collision captures|",
              powdered + breakage + fragments + grinding);
  expect_says("|lone-section", powdered + breakage + fragments + grinding);
}

TEST(ReadGrinding, faults) {
  expect_says("there is no model = \"vogel-peuckert\"|did you mean \"vogel-peukert\"?",
              with(all, "model = \"vogel", "model = \"vogel-peuckert\""));
  expect_says("there is no model = \"binari\"|did you mean \"binary\"?",
              with(all, "model = \"binary", "model = \"binari\""));
  expect_says("for tic: give it, for instance f_mat = \"1 kg/J/m\", or let `mahlwerk fit`",
              with(with(all, "f_mat", ""), "density = \"1280", "material = \"tic\""));
  expect_says("[fragments] lacks `t10`, and [breakage] model = \"vogel-peukert\" predicts none|",
              with(all, "model = \"binary", "model = \"t10\""));
  EXPECT_EQ(one_fault(with(all, "model = \"binary", "model = \"t10\"\nt10 = 0.3")), "");
  EXPECT_EQ(one_fault(powdered + capture + tavares + "[fragments]\nmodel = \"t10\"\n" + grinding),
            "");
  expect_says(
      "smallest (2 mm) is not below the largest grains as fed (1.3 mm)|write smallest = "
      "\"0.32 um\" or so, or leave it out|out-of-range",
      all + "smallest = \"2 mm\"\n");
  expect_says("|out-of-range", all + "smallest = \"1.3 mm\"\n");
  expect_says("classes_per_octave = 5 is not a multiple of 3|", all + "classes_per_octave = 5\n");
  expect_says("must be a whole number from 3 to 12|", all + "classes_per_octave = 15\n");
  expect_says("sample has no meaning under method = \"balance\"", all + "sample = 1000\n");
  expect_says("sample = 50 must be a whole number from 100 to 1000000|",
              all + "method = \"both\"\nsample = 50\n");
  expect_says("|out-of-range", all + "sticking = 1\n");
  expect_says("sticking_size has no meaning without `sticking`",
              all + "sticking_size = \"1 um\"\n");
  expect_says("welding_energy has no meaning without `welding`",
              all + "welding_energy = \"1 J/kg\"\n");
  expect_says("bad-quantity", all, {{"breakage.f_mat", "1 kg/J"}});
}

TEST(ReadGrinding, mixed_bed_of_grains_that_remember_is_for_samples) {
  const std::string mixed =
      powdered + capture + tavares + fragments + grinding + "bed = \"mixed\"\n";
  expect_says("would take hours", mixed);
  expect_says("would take hours", mixed + "method = \"both\"\n");
  expect_says("write method = \"statistical\", or bed = \"by-size\"|mixed-tavares", mixed);
  EXPECT_EQ(one_fault(mixed + "method = \"statistical\"\n"), "");
}

TEST(ReadGrinding, too_many_classes_name_a_size_that_is_not) {
  const std::string fine = all + "classes_per_octave = 12\nsmallest = ";
  const std::string said = one_fault(fine + "\"0.1 um\"\n");
  EXPECT_NE(said.find("12 classes in each of the 13.7 octaves from 0.1 um to 1.3 mm are 164, more "
                      "than 150"),
            std::string::npos)
      << said;
  const auto at = said.find("smallest = \"");
  ASSERT_NE(at, std::string::npos) << said;
  const std::string size = said.substr(at + 12, said.find('"', at + 12) - at - 12);
  EXPECT_EQ(one_fault(fine + "\"" + size + "\"\n"), "") << size;
  expect_says("are 72, more than 48|",
              powdered + capture + tavares + fragments + grinding + "classes_per_octave = 6\n");
}

TEST(ReadBreakage, strengths_come_from_the_material_where_the_case_is_silent) {
  const Catalogue real(std::filesystem::path(MAHLWERK_HOME) / "catalogue");
  const std::string text = with(with(powdered, "density = \"1280", "material = \"quartz\"") +
                                    capture + tavares + fragments + grinding,
                                "e_infinity", "");
  const Case c = read_text(with(with(text, "d_0", ""), "phi", "phi = 2"), "case.toml", real);
  const auto& read = std::get<powder::Tavares>(*c.grinding->breakage);
  EXPECT_EQ(read.e_infinity, 43.4);
  EXPECT_EQ(read.d_0, 3.48e-3);
  EXPECT_EQ(read.phi, 2);
  EXPECT_EQ(
      source_of(c, "breakage.e_infinity"),
      "catalogue materials/quartz: attributed to Tavares and King (Int. J. Miner. Process. 54, "
      "1998, 1-28); the paper could not be read, check it before use");
  EXPECT_EQ(c.powder->density, 2650);
}

TEST(ReadBreakage, that_knows_strengths_tells_them_to_the_bed) {
  const std::string barrios = "[capture]\nmodel = \"barrios\"\n";
  const Case c = read_sample(powdered + barrios + tavares + fragments + grinding);
  EXPECT_EQ(std::get<powder::Barrios>(*c.capture->model).fracture_energy, 0);
  EXPECT_EQ(source_of(c, "capture.fracture_energy"), "default: that of [breakage] for each size");
  states("E_50 of a grain of 1 mm [J/kg]", process(c).grain(1e-3).fracture_energy, 200, 1e-12,
         "E_inf (1 + (1 mm/1 mm)^1)");
}

TEST(ReadKinetics, laws_doses_and_properties) {
  const auto read_as = [](const std::string& lines) {
    return read_sample(all + "[kinetics]\ndose_constant = \"5 kJ/g\"\n" + lines).kinetics.value();
  };
  EXPECT_EQ(read_as(""),
            (Kinetics{powder::DoseKinetics{5e6, 1, 0}, Kinetics::Dose::dissipated, 30, "", 0, 1}));
  EXPECT_EQ(read_as("law = \"avrami\"\nexponent = 2\nonset = \"1 kJ/kg\"\ndose = \"captured\"\n"
                    "time = \"30 s\"\nproperty = \"amorphous content\"\ninitial = 5\nfinal = 100"),
            (Kinetics{powder::DoseKinetics{5e6, 2, 1000}, Kinetics::Dose::captured, 30,
                      "amorphous content", 5, 100}));
  const auto fault = [](const std::string& lines) {
    return one_fault(powdered + "[kinetics]\ntime = \"1 h\"\n" + lines);
  };
  const std::string dose = "dose_constant = \"5 kJ/g\"\n";
  EXPECT_NE(fault("").find("lacks `dose_constant`"), std::string::npos) << fault("");
  EXPECT_NE(fault(dose + "exponent = 2").find("no meaning under law = \"first-order\""),
            std::string::npos);
  EXPECT_NE(fault(dose + "law = \"avrami\"").find("lacks `exponent`"), std::string::npos);
  EXPECT_NE(fault(dose + "initial = 2").find("initial has no meaning without `property`"),
            std::string::npos);
  EXPECT_NE(fault(dose + "property = \"x\"\ninitial = 2").find("lacks `final`"), std::string::npos);
  EXPECT_NE(fault(dose + "dose = \"captured\"").find("needs [capture]"), std::string::npos);
  expect_says("[kinetics] needs a powder that takes the dose",
              vial + "[kinetics]\ntime = \"1 h\"\n" + dose);
}

TEST(ReadGrinding, is_read_back) {
  const std::string rosin = "distribution = \"rosin-rammler\"\nsize = \"1 mm\"\nspread = 3";
  const std::string kinetics =
      "[kinetics]\ndose_constant = \"5 kJ/g\"\nlaw = \"avrami\"\nexponent = 2\n"
      "property = \"p\"\ninitial = 0\nfinal = 1\n";
  for (const std::string& text :
       {powdered + capture, all, with(all, "size", rosin) + kinetics,
        powdered + capture + tavares + fragments + grinding + "method = \"both\"\n",
        powdered + "[capture]\nmodel = \"barrios\"\n" + tavares + fragments + grinding,
        all + "sticking = 0.1\nsticking_size = \"1 um\"\n[fit]\n\"breakage.f_mat\" = [\"0.01 "
              "kg/J/m\", \"100 kg/J/m\"]\n\"grinding.sticking\" = [0.1, 0.5]\n"}) {
    const Case c = read_sample(text);
    EXPECT_TRUE(read_sample(write(c)) == c) << write(c);
  }
}

TEST(Grinding, as_a_process) {
  const Case c = read_sample(all + "sticking = 0.1\nsticking_size = \"1 um\"\nwelding = 0.2\n" +
                             "welding_energy = \"3 J/kg\"\n");
  const powder::Process p = process(c);
  EXPECT_EQ(p.breakage, *c.grinding->breakage);
  EXPECT_EQ(p.fragments, *c.grinding->fragments);
  EXPECT_EQ(p.capture, *c.capture->model);
  EXPECT_EQ(p.density, 1280);
  EXPECT_EQ(p.mass, 0.15e-3);
  EXPECT_EQ(p.sticking, 0.1);
  EXPECT_EQ(p.sticking_size, 1e-6);
  EXPECT_EQ(p.welding, 0.2);
  EXPECT_EQ(p.welding_energy, 3);
  EXPECT_EQ(process(read_sample(all)).sticking_size, HUGE_VAL);
  EXPECT_EQ(process(read_sample(powdered + capture)).capture,
            powder::AnyCapture(powder::TrappedVolume{1.3e-3, 0.6}));
}

}  // namespace
}  // namespace mahlwerk::cases::grinding_test
