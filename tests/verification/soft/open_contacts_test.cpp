// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What open contacts have dissipated when a run is cut: from the time on at which counting began,
// and without the energy that their springs store.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::open_contacts_test {
namespace {

constexpr double r = 0.0125, wide = 0.2, deep = 0.06;

/// A heap in a drum at 60 % of its critical speed.
std::unique_ptr<scene::Engine> drum(std::size_t few) {
  std::vector<scene::Ball> balls;
  for (int x = -3; x <= 3; ++x)
    for (int y = -1; y <= 0; ++y)
      for (int z = -3; z <= 0; ++z) {
        const Vec3 place{x * 2.08 * r, (y + 0.5) * 2.05 * r, z * 2.08 * r};
        if (std::hypot(place.x, place.z) < 0.5 * wide - 1.1 * r)
          balls.push_back({r, 7800, place, {0.01 * x, 0.003 * y, 0}, {}});
      }
  const double critical = std::sqrt(2 * gravity / (wide - 2 * r));
  const scene::Chamber mill{geometry::Cylinder{wide, deep},
                            kinematics::Tumbling{0.6 * critical},
                            scene::mounted_along({0, 1, 0}),
                            {0, 0, -gravity}};
  contact::Pair pair = pair_of({2e9, 0.3}, {2e9, 0.3}, 0.5, 0.5);
  pair.rolling_friction = 0.01;
  const contact::ContactModel model = of_law(contact::HertzMindlin{}, contact::Rolling::cdt);
  return soft::make_engine(mill, balls, {model, 5e-6, false, few}, contact::PairTable(1, 3, pair),
                           0);
}

TEST(OpenContacts, have_dissipated_nothing_when_counting_begins_and_never_less) {
  for (const std::size_t few : {std::size_t{0}, std::size_t{64}}) {
    const std::string what = few == 0 ? ", many" : ", few";
    const auto engine = drum(few);
    Recorder recorder;
    double time = 0.15, least = 0, apart = 0;
    engine->advance(time, recorder);
    for (int begun = 0; begun < 3; ++begun) {
      engine->begin_counting();
      recorder.all.clear();
      const scene::EnergyBalance start = engine->energy_balance();
      EXPECT_GT(start.elastic, 0) << "contacts are open";
      states("dissipated by open contacts when counting begins [J]" + what, start.lost_open, 0,
             1e-15, "counting begins");
      for (int cut = 0; cut < 50; ++cut) {
        engine->advance(time += 0.001, recorder);
        const scene::EnergyBalance now = engine->energy_balance();
        double records = 0;
        for (const scene::Collision& c : recorder.all) records += c.lost();
        least = std::min(least, now.lost_open / now.elastic);
        apart = max_or_nan(apart, std::abs(records + now.lost_open - now.lost() + start.lost()) /
                                      (now.lost() - start.lost()));
      }
    }
    stays_below("negative dissipation of open contacts over the stored energy" + what, -least, 0,
                "springs store, and do not gain");
    stays_below("records and open contacts against the balance, relative" + what, apart, 1e-9,
                "each loss is in one of them");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::open_contacts_test
