// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/band.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/paper/figure_plot.hpp"

namespace mahlwerk::report {
namespace {

/// The selected points of a campaign without the values of the free numbers, so that these do not
/// distinguish lines.
struct BlankedCampaign {
  Campaign campaign;
  std::vector<const Point*> original;  // by point
};

BlankedCampaign without_free_numbers(const PaperFigure& figure, const Campaign& campaign) {
  BlankedCampaign made;
  made.campaign.keys = campaign.keys;
  made.campaign.columns = campaign.columns;
  for (const ClaimLine& line : lines_along(campaign, figure.at, figure.against, figure.quantity))
    for (const LinePoint& s : line.points) made.original.push_back(s.point);
  std::ranges::sort(made.original);  // in the order of the campaign
  for (const Point* p : made.original) made.campaign.points.push_back(*p);
  for (std::size_t k = 0; k < campaign.keys.size(); ++k)
    if (std::ranges::find(figure.band_over, campaign.keys[k].key) != figure.band_over.end())
      for (Point& p : made.campaign.points)
        if (k < p.values.size()) p.values[k].clear();
  return made;
}

bool is_nominal(const PaperFigure& figure, const Campaign& campaign, const Point& p) {
  return !figure.nominal.empty() && std::ranges::all_of(figure.nominal, [&](const auto& one) {
    const auto key = static_cast<std::size_t>(
        std::ranges::find(campaign.keys, one.first, &CampaignKey::key) - campaign.keys.begin());
    return key < p.values.size() && same_value(p.values[key], one.second);
  });
}

void widen(std::vector<BandPoint>& band, const LinePoint& s) {
  if (!std::isfinite(s.x) || !std::isfinite(s.value)) return;
  const double half = std::isfinite(s.ci95) ? s.ci95 : 0;
  if (band.empty() || band.back().x != s.x) band.push_back({s.x, s.value - half, s.value + half});
  band.back().low = std::min(band.back().low, s.value - half);
  band.back().high = std::max(band.back().high, s.value + half);
}

}  // namespace

std::vector<BandLine> bands_along(const PaperFigure& figure, const Campaign& campaign) {
  const BlankedCampaign blanked = without_free_numbers(figure, campaign);
  std::vector<BandLine> bands;
  for (const ClaimLine& line : lines_along(blanked.campaign, {}, figure.against, figure.quantity)) {
    BandLine band{.others = line.others, .points = {}, .nominal = {}};
    for (LinePoint s : line.points) {
      widen(band.points, s);
      s.point =
          blanked.original[static_cast<std::size_t>(s.point - blanked.campaign.points.data())];
      if (is_nominal(figure, campaign, *s.point)) band.nominal.push_back(s);
    }
    bands.push_back(std::move(band));
  }
  return bands;
}

std::vector<Fault> band_faults(const Paper& paper,
                               const std::map<std::string, cases::Case>& cases) {
  std::vector<Fault> faults;
  for (const PaperFigure& figure : paper.figures) {
    const auto& keys = cases.at(figure.campaign).sweep.keys;
    const auto swept = [&](const std::string& name) {
      return std::ranges::find(keys, name, &cases::SweptKey::key);
    };
    const auto fault = [&](std::string what, std::string remedy, const char* code) {
      faults.push_back({figure.where, std::move(what), std::move(remedy), code});
    };
    for (const std::string& name : figure.band_over)
      if (name == figure.against)
        fault(fmt::format("the band is over {}, which is the axis of the figure", name),
              "name other keys in `band_over`", "paper-unknown-key");
      else if (swept(name) == keys.end())
        fault(fmt::format("{}.toml does not vary {}", figure.campaign, name),
              fmt::format("name a key of its [sweep], or put {} there", name), "paper-unknown-key");
    for (const auto& [name, text] : figure.nominal) {
      const auto key = swept(name);
      if (std::ranges::find(figure.band_over, name) == figure.band_over.end())
        fault(fmt::format("`nominal` gives {}, which is not in `band_over`", name),
              "add it to `band_over`, or remove it", "paper-unknown-key");
      else if (key != keys.end() && !key->range &&
               std::ranges::none_of(key->values, [&wanted = text](const std::string& v) {
                 return same_value(v, wanted);
               }))
        fault(fmt::format("{} does not take the value {} in {}.toml", name, text, figure.campaign),
              fmt::format("its values are {}", fmt::join(key->values, ", ")),
              "paper-unknown-value");
    }
  }
  return faults;
}

}  // namespace mahlwerk::report
