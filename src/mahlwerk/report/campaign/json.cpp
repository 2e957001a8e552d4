// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A campaign as JSON.
#include "mahlwerk/results/files/json.hpp"

#include "mahlwerk/cases/sections/sweep_words.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/campaign/plots.hpp"
#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/study_json.hpp"

namespace mahlwerk::report {
namespace {

using results::Json;

constexpr std::size_t most_points = 5000;

std::string_view status_of(const Point& p) {
  return p.waiting() ? "waiting" : p.failure.empty() ? "done" : "failed";
}

Json point_json(const Campaign& c, const Point& p) {
  Json value = Json::array(), ci95 = Json::array();
  for (std::size_t i = 0; i < c.columns.size(); ++i) {
    value.push_back(value_at(p, i));
    ci95.push_back(half_width_at(p, i));
  }
  return Json::object({{"point", p.number},
                       {"values", p.values},
                       {"status", status_of(p)},
                       {"regime", p.regime},
                       {"warnings", p.warnings},
                       {"folder", p.folder},
                       {"failure", p.failure},
                       {"value", std::move(value)},
                       {"ci95", std::move(ci95)}});
}

/// null: not known.
Json truth(std::optional<bool> known) {
  return known ? Json(*known) : Json();
}

Json effect_json(const Effect& e, Design design) {
  Json made = Json::object(
      {{"key", e.key}, {"significant", truth(e.significant)}, {"inactive", e.inactive}});
  if (design == Design::one_at_a_time) {
    made["low_end"] = e.low_end;
    made["high_end"] = e.high_end;
    made["low"] = interval_json(e.low);
    made["high"] = interval_json(e.high);
    return made;
  }
  made["count"] = e.count;
  if (design == Design::morris) {
    made["mean_absolute"] = interval_json(e.mean_absolute);
    made["mean"] = interval_json(e.mean);
    made["deviation"] = interval_json(e.deviation);
    made["of_noise"] = e.of_noise;
  } else {
    made["first_order"] = interval_json(e.first_order);
    made["total"] = interval_json(e.total);
  }
  return made;
}

Json sensitivity_json(const Sensitivity& s) {
  Json effects = Json::array();
  for (const Effect& e : s.effects) effects.push_back(effect_json(e, s.design));
  return Json::object({{"quantity", s.quantity},
                       {"unit", s.unit},
                       {"design", cases::design_words()[static_cast<std::size_t>(s.design)]},
                       {"base", interval_json(s.base)},
                       {"variance", s.variance},
                       {"noise", s.noise},
                       {"effects", std::move(effects)}});
}

/// What the page says under "What matters".
std::vector<std::string> remarks_of(const Campaign& c) {
  std::vector<std::string> all;
  const std::vector<std::string> inactive = inactive_keys(c.sensitivities);
  for (const Sensitivity& s : c.sensitivities)
    if (std::string words = sensitivity_words(s, inactive); !words.empty())
      all.push_back(std::move(words));
  return all;
}

}  // namespace

std::string campaign_json(const Campaign& c, std::string_view version) {
  Json keys = Json::array(), columns = Json::array(), points = Json::array(),
       sensitivities = Json::array();
  for (const CampaignKey& k : c.keys)
    keys.push_back(Json::object({{"key", k.key}, {"unit", k.unit}, {"follows", k.follows}}));
  for (const Column& q : c.columns)
    columns.push_back(Json::object({{"name", q.name}, {"unit", q.unit}, {"about", q.about}}));
  if (c.points.size() > most_points)
    points = nullptr;
  else
    for (const Point& p : c.points) points.push_back(point_json(c, p));
  for (const Sensitivity& s : c.sensitivities) sensitivities.push_back(sensitivity_json(s));
  Json made = study_head("sweep", version, c.title, c.case_file);
  made["keys"] = std::move(keys);
  made["columns"] = std::move(columns);
  made["points"] = std::move(points);
  made["sensitivities"] = std::move(sensitivities);
  made["remarks"] = remarks_of(c);
  made["notices"] = results::notices_json(c.notices);
  return made.text() + '\n';
}

}  // namespace mahlwerk::report
