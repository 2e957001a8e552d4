// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Writes a campaign's store as page, pictures and tables.
#include "mahlwerk/commands/campaigns/campaign_pages.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"

namespace mahlwerk::commands {

namespace fs = std::filesystem;

namespace {

/// Above this number of points, only the usual quantities are read from the store.
constexpr std::size_t many_points = 5000;

/// Whether the points are those of this plan: compares the first and the last point. The case may
/// have changed since the run.
bool made_by(const report::Campaign& campaign, const campaign::Plan& plan,
             const cases::Case& mill_case) {
  if (campaign.points.empty() || plan.size() != campaign.points.size()) return false;
  const std::vector<std::string> own = campaign::base_values(plan, mill_case);
  for (const std::size_t i : {std::size_t{0}, plan.size() - 1}) {
    const std::vector<std::string>&kept = campaign.points[i].values,
          said = campaign::point_values(plan, i, own);
    const bool same = std::ranges::equal(kept, said, [](const auto& a, const auto& b) {
      const NumberText x = number_text(a), y = number_text(b);
      return a == b || (x.number == y.number && x.rest == y.rest);
    });
    if (!same) return false;
  }
  return true;
}

void add_sensitivities_of_design(report::Campaign& campaign, const campaign::Store& store) {
  try {
    const cases::Case mill_case = cases::read(store.case_file(), catalogue(), store.overrides());
    if (mill_case.sweep.empty()) return;
    const campaign::Plan plan(mill_case.sweep, mill_case.seed);
    if (made_by(campaign, plan, mill_case))
      add_sensitivities(campaign, mill_case.sweep, plan.design());
  } catch (const InputError&) {
    // the case was removed or changed since: the report omits the sensitivities
  }
}

}  // namespace

report::Campaign campaign_of(const campaign::Store& store) {
  report::Campaign campaign;
  campaign.title = store.title();
  std::vector<std::string> names;
  const bool all = store.counts().points <= many_points;
  const std::vector<std::string>& usual = results::usual_columns();
  for (const results::Quantity& q : store.quantities()) {
    // Standard errors need the number of replicates.
    const bool wanted = q.name == "replicates" || std::ranges::find(usual, q.name) != usual.end();
    if (!all && !wanted) continue;
    names.push_back(q.name);
    campaign.columns.push_back({q.name, q.unit, q.about});
  }
  store.read(names, [&](const campaign::StoredPoint& stored) {
    report::Point point{.number = stored.number,
                        .values = stored.values,
                        .value = stored.value,
                        .ci95 = stored.ci95,
                        .regime = stored.regime,
                        .warnings = stored.warnings,
                        .folder = stored.folder};
    if (stored.state == campaign::RunState::failed) point.failure = stored.message;
    point.waiting = stored.state == campaign::RunState::waiting;
    campaign.points.push_back(std::move(point));
  });
  campaign.notices = store.notices();
  campaign.keys = report::campaign_keys(store.keys(), campaign.points);
  for (report::CampaignKey& key : campaign.keys) key.follows = store.follows(key.key);
  add_sensitivities_of_design(campaign, store);
  return campaign;
}

void write_pages(const campaign::Store& store, const report::Campaign& campaign,
                 const fs::path& place) {
  results::list_files(place, {"campaign.csv", "campaign.html"});
  write_table(store, place / "campaign.csv");
  results::write_whole(place / "campaign.html", report::campaign_page(campaign, version()));
}

void write_table(const campaign::Store& store, const fs::path& file) {
  results::write_whole(file, [&](const fs::path& aside) {
    errno = 0;
    std::ofstream out(aside, std::ios::binary);
    store.write_csv(out);
    out.close();
    if (!out) throw results::cannot_write(file, errno != 0 ? std::strerror(errno) : "not whole");
  });
}

}  // namespace mahlwerk::commands
