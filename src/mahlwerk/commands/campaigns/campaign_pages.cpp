// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Writes a campaign's store as page, pictures and tables.
#include "mahlwerk/commands/campaigns/campaign_pages.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>

#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/manifest.hpp"

namespace mahlwerk::commands {

namespace fs = std::filesystem;

void write_pages(const campaign::Store& store, const campaign::Campaign& campaign,
                 const fs::path& place) {
  const std::map<std::string, std::string> figures = report::campaign_figures(campaign);
  std::vector<std::string> names{"campaign.csv", "campaign.json", "campaign.html"};
  for (const auto& [name, picture] : figures) names.push_back(name);
  results::list_files(place, names);
  write_table(store, place / "campaign.csv");
  results::write_whole(place / "campaign.json", report::campaign_json(campaign, version()));
  results::write_whole(place / "campaign.html", report::campaign_page(campaign, version()));
  for (const auto& [name, picture] : figures) {
    results::make_folder((place / name).parent_path());
    results::write_whole(place / name, picture);
  }
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
