// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// report: makes the page of a result anew, in the form of this version.
#include <fmt/format.h>

#include <array>
#include <fstream>
#include <iterator>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/campaigns/campaign_pages.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::string folder;
  bool json = false;
};

constexpr std::array pages{"report.html", "fit.html",     "optimise.html",
                           "match.html",  "compare.html", "paper.html"};

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(
        Fault{file.string(), "the file cannot be read", "check its permissions", "no-result"});
  return {std::istreambuf_iterator<char>(in), {}};
}

/// campaign.html and campaign.csv from the store.
fs::path campaign_page_in(const fs::path& place) {
  const campaign::CampaignLock lock(place / "campaign.lock");
  const campaign::Store store = campaign::open_store(place);
  write_pages(store, campaign::campaign_of(store, catalogue()), place);
  return place / "campaign.html";
}

/// The page of another result, whose words and numbers stay.
fs::path renewed_page_in(const fs::path& place) {
  for (const char* name : pages) {
    fs::path file = place / name;
    if (!fs::exists(file)) continue;
    const std::optional<std::string> made = report::renewed_page(content_of(file));
    if (!made)
      throw InputError(Fault{file.string(), "this is no page of Mahlwerk, or it is damaged",
                             "run the command that made the folder again", "no-result"});
    results::write_whole(file, *made);
    return file;
  }
  throw InputError(Fault{place.string(), "the folder holds no page of a run, campaign or search",
                         "give a folder that a command of Mahlwerk wrote; the page of a run comes "
                         "with `mahlwerk run` and its case.resolved.toml",
                         "no-result"});
}

int report_page(const ReportArguments& given) {
  const fs::path place = given.folder;
  const fs::path page =
      fs::exists(place / "campaign.sqlite") ? campaign_page_in(place) : renewed_page_in(place);
  if (given.json) json_to_stdout(results::Json::object({{"report", page.string()}}));
  if (!given.json) places_to_stdout({{"report", page}});
  return success;
}

}  // namespace

Command report_command() {
  const auto given = std::make_shared<ReportArguments>();
  return {"report",
          "make the page of a run, campaign or search anew, in the form of this version",
          {{.name = "FOLDER",
            .target = &given->folder,
            .about = "the folder that a command of Mahlwerk wrote",
            .required = true},
           json(given->json)},
          [given] { return report_page(*given); }};
}

}  // namespace mahlwerk::commands
