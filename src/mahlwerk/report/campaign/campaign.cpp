// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/campaign/campaign.hpp"

#include <fmt/format.h>

#include "mahlwerk/report/campaign/plots.hpp"
#include "mahlwerk/report/campaign/points.hpp"
#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/plot/picture_json.hpp"

namespace mahlwerk::report {
namespace {

/// Pictures, side by side on wide pages.
std::string panels(const std::vector<Picture>& pictures) {
  std::string text;
  for (const Picture& p : pictures) {
    const std::string below =
        p.caption.empty() ? "" : fmt::format("<figcaption>{}</figcaption>\n", p.caption);
    text += fmt::format("<figure>\n{}{}</figure>\n", drawing(p.json), below);
  }
  return text.empty() ? "" : fmt::format("<div class=\"panels\">\n{}</div>\n", text);
}

std::vector<Picture> sensitivity_figures(const Campaign& c) {
  std::vector<Picture> list;
  for (const Sensitivity& s : c.sensitivities)
    for (Picture& p : sensitivity_pictures(s)) list.push_back(std::move(p));
  return list;
}

std::string sensitivity_section(const Campaign& c) {
  if (c.sensitivities.empty()) return "";
  std::string words;
  const std::vector<std::string> inactive = inactive_keys(c.sensitivities);
  for (const Sensitivity& s : c.sensitivities)
    if (const std::string one = sensitivity_words(s, inactive); !one.empty())
      words += fmt::format("<p>{}</p>\n", escaped(one));
  if (!inactive.empty())
    words += fmt::format("<p>Without effect in this case: {}.</p>\n", escaped(joined(inactive)));
  return "<h2>What matters</h2>\n" + words + panels(sensitivity_figures(c));
}

/// All quantities in the same panels, or each with its own heading if it has several pictures.
std::string quantities_section(const Sheet& sheet) {
  const Layout layout = layout_of(sheet);
  std::vector<Picture> all;
  std::string by_quantity;
  bool several = false;
  for (const std::size_t column : sheet.shown) {
    const std::vector<Picture> own = quantity_pictures(sheet, layout, column);
    several = several || own.size() > 1;
    by_quantity +=
        fmt::format("<h2>{}</h2>\n", escaped(label(sheet.campaign.columns[column].name))) +
        panels(own);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all.empty() ? "" : several ? by_quantity : "<h2>Quantities</h2>\n" + panels(all);
}

}  // namespace

std::string campaign_page(const Campaign& c, std::string_view version) {
  const Sheet sheet(c);
  const std::vector<Picture> regimes = regime_map(sheet);
  const std::string body =
      campaign_lead(sheet) + failures(c) + notice_boxes(c.notices, c.points.size(), "point") +
      sensitivity_section(c) + (regimes.empty() ? "" : "<h2>Regimes</h2>\n" + panels(regimes)) +
      quantities_section(sheet) + point_table(sheet);
  return page(c.title, body,
              fmt::format("Mahlwerk {}. All quantities of all points are in campaign.csv.",
                          escaped(version)));
}

}  // namespace mahlwerk::report
