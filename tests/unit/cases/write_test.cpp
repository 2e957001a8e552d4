// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/powder/models.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::write_test {
namespace {

using namespace sample;
using cases::Wear;

/// A catalogue without any entry: a resolved case needs none.
const Catalogue& nothing() {
  static const Folder folder;
  static const Catalogue empty = [] {
    std::filesystem::create_directories(folder.path() / "mills");
    return Catalogue(folder.path());
  }();
  return empty;
}

void expect_round_trip(const Case& c, const std::string& file = "case.toml") {
  const std::string text = write(c);
  try {
    EXPECT_TRUE(read_text(text, file, nothing()) == c) << text;
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what() << "\n" << text;
  }
}

TEST(WriteCase, what_was_read_is_read_back_without_the_catalogue) {
  expect_round_trip(read_sample(vial));
  expect_round_trip(read_sample(planetary));
  expect_round_trip(read_sample(drum));
  expect_round_trip(read_sample(
      drum, {{"mill.speed_over_time", "[[\"0 s\", 0], [\"0.7 s\", \"70 %\"], [\"3 s\", 0]]"},
             {"mill.speed_repeats", "true"},
             {"run.settle", "0 s"}}));
  const std::string oil = "[liquid]\nmaterial = \"oil\"\n";
  expect_round_trip(read_sample(vial + oil + "kind = \"film\"\nfilm = \"7.3 um\"\n"));
  expect_round_trip(read_sample(vial + oil + "kind = \"flooded\"\nreach = 0.3\ndrag = false\n"));
  expect_round_trip(read_sample(vial + "[heat]\n[power_meter]\n[microphone]\nhears = \"all\"\n"
                                       "[accelerometer]\nmass = \"3 kg\"\n[thermocouple]\n"));
  expect_round_trip(read_sample(vial + "[accelerometer]\nbandwidth = \"3 kHz\"\naxis = \"y\"\n"));
  expect_round_trip(read_sample(vial + "frames = \"0.7 ms\"\n"));
  expect_round_trip(read_sample(vial + "frames = \"0.7 ms\"\nframes_format = \"vtk\"\n"));
  expect_round_trip(read_sample(vial, {{"seed", "18446744073709551615"}}));
  expect_round_trip(read_sample(vial, {{"title", R"(a "quoted" \ title)"}}));
  Case c = read_sample(vial);
  c.title = "two\nlines\tand a bell \a, \u00b5m";
  expect_round_trip(c);
  expect_round_trip(read_sample(vial + "[sweep]\n\"mill.frequency\" = [\"13 Hz\", \"16 "
                                       "Hz\"]\n\"contact.restitution\" = [0.9, 1]\n"));
}

TEST(WriteCase, the_example_is_read_back) {
  const std::filesystem::path home = MAHLWERK_HOME;
  expect_round_trip(read(home / "examples/01-one-ball/case.toml", Catalogue(home / "catalogue")));
}

TEST(WriteCase, every_entry_of_the_real_catalogue_that_is_complete_is_read_back) {
  const Catalogue real(std::filesystem::path(MAHLWERK_HOME) / "catalogue");
  int complete = 0;
  for (const std::string& jar : real.names("jars")) {
    const std::string text =
        with(with(with(vial, "kind = \"capsule", "model = \"" + jar + "\""), "diameter", ""),
             "volume", "");
    expect_round_trip(read_text(text, "case.toml", real));
    ++complete;
  }
  EXPECT_GT(complete, 3);
}

TEST(WriteCase, origins_stand_behind_the_values_on_one_line) {
  Case c = read_sample(planetary);
  const std::string text = write(c);
  EXPECT_NE(text.find("orbit_radius = \"70 mm\""), std::string::npos);
  EXPECT_NE(text.find("# catalogue mills/p7: test sheet"), std::string::npos);
  EXPECT_NE(text.find("# default: "), std::string::npos);
  for (Origin& o : c.origins) o.source = "evil\nseed = 5\r\n[x]";
  expect_round_trip(c);
}

TEST(WriteCase, a_measured_motion_keeps_its_file) {
  const Folder folder;
  folder.write("motion.csv",
               "time_s,x_m,y_m,z_m\n0,0,0,0\n0.1,0,0,0.01\n0.2,0,0,-0.01\n0.3,0,0,0\n");
  folder.write(
      "case.toml",
      with(with(with(vial, "kind", "kind = \"tabulated\"\nfile = \"motion.csv\""), "frequency", ""),
           "amplitude", ""));
  const auto file = folder.path() / "case.toml";
  expect_round_trip(read(file, catalogue()), file.string());
}

/// Random cases from all registers, with numbers of many digits.
class AnyCase {
 public:
  explicit AnyCase(std::uint32_t stream) : random_(11, stream) {}

  Case draw() {
    Case c;
    c.title = "random";
    c.seed = static_cast<std::uint64_t>(random_.uniform() * 1.8e19);
    c.gravity = random_.uniform(0, 20);
    pick(*c.mill.motion);
    c.mill.jar_axis = flip() ? kinematics::upright : kinematics::lying;
    c.mill.model = flip() ? "some mill" : "";
    geometry::FormulaShape shape;  // a mesh comes from a file
    pick(shape);
    std::visit([&](const auto& s) { c.jar.shape = s; }, shape);
    c.jar.material = flip() ? "steel" : "";
    const double room = 2 * geometry::inradius(*c.jar.shape);
    for (int n = flip() ? 1 : 2; n > 0; --n)
      c.balls.push_back({flip() ? 1 : 2, room * random_.uniform(0.01, 0.4),
                         random_.uniform(900, 16000), flip() ? "steel" : "", elastic(),
                         substance()});
    c.jar.elastic = elastic();
    c.jar.substance = substance();
    c.jar.density = std::max(1e-3, size());
    c.jar.wall = size();
    if (flip()) draw_places(c);
    if (flip()) draw_powder(c.powder.emplace());
    draw_contact(c.contact);
    c.run = {.engine = flip() ? EngineName::event : EngineName::soft,
             .time = size(),
             .settle = size(),
             .replicates = whole(10000),
             .start_speed = size(),
             .start_spin = size()};
    if (flip())
      c.run.until = StopCriterion{.within = random_.uniform(),
                                  .quantity = until_quantities()[flip() ? 0 : 2]};
    if (flip()) c.mill.jars_carried = whole(100);
    c.run.start_frame = flip() ? StartFrame::laboratory : StartFrame::jar;
    c.run.free_flight_skip = flip();
    if (flip())
      c.run.time_step = size();
    else
      c.run.time_step_fraction = random_.uniform(), c.run.step_error = 0.1 * random_.uniform();
    c.observe = {size(), flip()};
    if (flip()) c.parts.set(Wear{flip() ? Wear::Model::archard : Wear::Model::finnie, size()});
    if (flip())
      c.heat = {size(), size(), flip() ? 0 : size(), whole(1000),
                size(), size(), random_.uniform()};
    draw_grinding(c);
    if (c.powder && flip()) draw_kinetics(c.kinetics.emplace());
    if (c.kinetics && flip()) {
      c.kinetics->dose =
          c.capture && flip() ? Kinetics::Dose::captured : Kinetics::Dose::dissipated;
      c.fit["kinetics.onset"] = {"0.5 J/kg", "3 kJ/g"};
    }
    draw_milling_time(c);
    if (c.contact.rule.restitution.points().empty() && flip())
      c.sweep.keys.push_back({"contact.restitution", {"0.5", "0.9", "1e-3"}});
    if (flip()) c.sweep.keys.push_back({"title", {"12 mm", "a \"b\"", "true"}});
    return c;
  }

 private:
  bool flip() { return random_.uniform() < 0.5; }
  double size() { return std::pow(10, random_.uniform(-5, 4)); }
  std::int64_t whole(int most) {
    return 1 + static_cast<std::int64_t>(random_.uniform(0, most - 1));
  }

  /// A number within a field's range.
  double within(const Range& r) {
    const double low = std::isfinite(r.least) ? r.least : -size();
    return std::isfinite(r.most) ? random_.uniform(low, r.most) : low + size();
  }
  template <class... Models>
  void pick(std::variant<Models...>& model) {
    const auto which = static_cast<std::size_t>(random_.uniform(0, sizeof...(Models)));
    std::size_t i = 0;
    ((i++ == which ? (void)(model = draw_model<Models>()) : void()), ...);
  }
  template <class M>
  M draw_model() {
    M m{};
    for (const auto& field : M::fields()) m.*field.value = within(field.range);
    if constexpr (requires { m.fillet; })
      m.fillet = random_.uniform(0.01, 0.5) * std::min(m.diameter, m.height);
    return m;
  }
  void draw_powder(Powder& powder) {
    powder.mass = 1e-6 * size();
    if (flip()) draw_feed(powder.feed);
    if (powder.feed.size > 0 || !powder.feed.passing.empty())
      powder.size = powder.feed.quantile(0.5);
    if (flip()) {
      powder.density = random_.uniform(500, 16000);
      powder.material = "tic";
    }
  }
  void draw_feed(powder::Feed& feed) {
    using Law = powder::Feed::Law;
    feed.law = static_cast<Law>(whole(5) - 1);
    if (feed.law != Law::sieves) feed.size = 1e-6 * size();
    if (feed.law == Law::lognormal || feed.law == Law::rosin_rammler)
      feed.spread = random_.uniform(1.1, 3);
    if (feed.law != Law::sieves) return;
    const double low = 1e-6 * size(), share = random_.uniform();
    feed.passing = {{low, 0}, {low * 1.1, share}, {low * random_.uniform(1.2, 9), 1}};
  }
  /// Cases with too many or too few classes have faults and are not read back.
  void draw_grinding(Case& c) {
    if (!c.powder || !c.powder->size || !c.powder->density) return;
    Capture& capture = c.capture.emplace();
    pick(*capture.model);
    capture.energy = static_cast<Capture::Energy>(whole(4) - 1);
    capture.energy_share = random_.uniform();
    if (flip()) return;
    Grinding& g = c.grinding.emplace();
    pick(*g.breakage);
    pick(*g.fragments);
    g.method = static_cast<Grinding::Method>(whole(4) - 1);
    g.time = size();
    g.bed = flip() ? powder::Bed::by_size : powder::Bed::mixed;
    g.smallest = c.powder->feed.largest() / random_.uniform(2, 9000);
    g.classes_per_octave = 3 * whole(5);
    if (g.method != Grinding::Method::balance) g.sample = 99 + whole(900'000);
    g.sticking = random_.uniform();
    if (flip()) g.sticking_size = size();
    g.welding = random_.uniform();
    g.welding_energy = size();
  }
  /// One time for all sections, as a case has.
  void draw_milling_time(Case& c) {
    if (!milling_time(c) && !flip()) return;
    const double time = milling_time(c).value_or(size());
    if (flip()) c.milling = MillingTime{.time = time, .dose = size()};
    if (c.grinding) c.grinding->time = time;
    if (c.kinetics) c.kinetics->time = time;
    if (c.heat) c.heat->milling = time / static_cast<double>(c.heat->cycles);
  }
  void draw_kinetics(Kinetics& k) {
    k.model =
        powder::DoseKinetics{size(), flip() ? 1 : random_.uniform(0.5, 4), flip() ? 0 : size()};
    k.time = size();
    if (!flip()) return;
    k.property = "a \"property\"";
    k.initial = -size();
    k.final = size();
  }
  contact::Restitution draw_restitution() {
    if (flip()) return random_.uniform();
    if (flip()) return contact::Restitution::viscoelastic(random_.uniform(), size());
    contact::Restitution::Points points{{size(), random_.uniform()}};
    while (flip()) points.emplace_back(points.back().first + size(), random_.uniform());
    return contact::Restitution::tabulated(points);
  }
  contact::BounceRule draw_rule() {
    return {draw_restitution(), random_.uniform(-1, 1), flip() ? INFINITY : size()};
  }
  contact::ElasticConstants elastic() { return {size(), random_.uniform(-0.99, 0.5)}; }
  Substance substance() { return {size(), size(), size()}; }
  /// Positions for the last set. Cases in which they do not fit have faults and are not read back.
  void draw_places(Case& c) {
    BallSet& set = c.balls.back();
    const double r = 0.5 * set.diameter;
    for (std::int64_t n = 0; n < set.count; ++n)
      set.positions.push_back({0.1 * r * random_.uniform(), 0, (n == 0 ? -1.1 : 1.1) * r});
  }
  /// Optional numbers are sometimes left out; numbers that others replace are always left out.
  template <class L>
  void draw_numbers(L& law) {
    for (const auto& s : contact::switches_of<L>()) law.*s.second = flip();
    for (const auto& f : L::fields())
      if (f.is_optional() && flip()) law.*f.value = 0;
    for (const auto& f : L::fields())
      if (!contact::is_given(law, f) && !f.is_optional()) law.*f.value = L().*f.value;
  }
  contact::ContactModel draw_model() {
    contact::ContactModel model;
    pick(*model.law);
    std::visit([&](auto& law) { draw_numbers(law); }, *model.law);
    model.rolling =
        static_cast<contact::Rolling>(whole(static_cast<int>(contact::rolling_rules.size())) - 1);
    model.curved_walls = flip();
    model.partial_slip = flip();
    model.rescaled_unloading = flip() && !model.partial_slip;
    if (flip()) model.twisting = contact::Twisting::marshall;
    if (has_meaning("rolling_damping", model)) model.rolling_damping = random_.uniform();
    return model;
  }
  template <class Owner>
  void draw_touch(Owner& owner, const contact::ContactModel& model) {
    for (const auto& f : touch_fields<Owner>())
      owner.*f.value = has_meaning(f.key, model) ? size() : 0;
  }
  void draw_contact(Contact& contact) {
    contact.model = draw_model();
    contact.softening = random_.uniform();
    contact.rule = draw_rule();
    if (flip()) contact.pairs.push_back({{"balls.1", "jar"}, draw_rule()});
    if (flip()) contact.pairs.push_back({{"balls", "balls.1"}, draw_rule()});
    draw_touch(contact, contact.model);
    for (PairRule& pair : contact.pairs) draw_touch(pair, contact.model);
    contact.lasting_friction = size();
    contact.lasting = flip()   ? SustainedContactModel::tc
                      : flip() ? SustainedContactModel::roll
                               : SustainedContactModel::none;
    contact.lasting_speed = size();
    contact.contact_time = random_.uniform(1e-7, 1e-3);
  }

  Random random_;
};

TEST(WriteCase, random_cases_over_the_registers_are_read_back) {
  int tried = 0, ground = 0;
  for (std::uint32_t i = 0; i < 1600; ++i) {  // a third of the mills exceed the speed limit
    const Case c = AnyCase(i).draw();
    if (std::holds_alternative<kinematics::Tabulated>(*c.mill.motion))
      continue;  // has its own test
    if (!faults(c).empty()) continue;
    expect_round_trip(c);
    ++tried;
    ground += c.grinding.has_value();
  }
  EXPECT_GT(tried, 600);
  EXPECT_GT(ground, 10);
}

}  // namespace
}  // namespace mahlwerk::cases::write_test
