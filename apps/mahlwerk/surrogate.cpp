// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// surrogate: writes the surrogate of a campaign to a file, which ask evaluates.
#include "surrogate.hpp"

#include <fmt/format.h>

#include <array>

#include "campaign_pages.hpp"
#include "command.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/surrogate/campaign_surrogate.hpp"
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "output.hpp"

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;

/// The quantities that the page of a campaign shows and that vary over its settings.
std::vector<std::string> usual_varying_quantities(const campaign::Store& store) {
  const std::vector<results::Quantity> all = store.quantities();
  std::vector<std::string> known;
  for (const std::string& name : report::usual_quantities())
    if (std::ranges::find(all, name, &results::Quantity::name) != all.end()) known.push_back(name);
  std::vector<double> least(known.size(), INFINITY), most(known.size(), -INFINITY);
  std::vector<bool> complete(known.size(), true);
  store.read(known, [&](const campaign::StoredPoint& point) {
    if (point.state != campaign::RunState::done) return;
    for (std::size_t i = 0; i < known.size(); ++i) {
      complete[i] = complete[i] && std::isfinite(point.value[i]);
      least[i] = std::fmin(least[i], point.value[i]);
      most[i] = std::fmax(most[i], point.value[i]);
    }
  });
  std::vector<std::string> varying;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (complete[i] && most[i] > least[i]) varying.push_back(known[i]);
  return varying;
}

/// Writes the file under another name and renames it: nobody sees a part of it.
void write_whole(const fs::path& file, const std::string& text, bool replace) {
  std::error_code failed;
  if (fs::exists(file, failed) && !replace)
    throw InputError(Fault{file.string(), "the file already exists",
                           "choose another name, or replace it with --force", "result-exists"});
  if (fs::is_directory(file, failed))
    throw InputError(
        Fault{file.string(), "this is a folder", "give the name of a file", "cannot-write"});
  if (!file.parent_path().empty()) results::make_folder(file.parent_path());
  const fs::path aside = file.string() + ".part";
  results::write_text(aside, text);
  fs::rename(aside, file, failed);
  if (failed) throw results::cannot_write(file, failed.message());
}

int surrogate(const Request& request) {
  const fs::path place = request.target;
  const campaign::Store store = campaign::open_store(place);
  const std::vector<std::string> names =
      request.quantities.empty() ? usual_varying_quantities(store) : request.quantities;
  const campaign::CampaignSurrogate made =
      campaign::surrogate_of(store, place.string(), names, version());
  write_whole(*request.out, campaign::surrogate_text(made), request.force);
  if (request.json)
    json_to_stdout(surrogate_json(made));
  else if (!request.quiet)
    to_stdout(surrogate_words(made) + fmt::format("\nsurrogate:  {}\n", request.out->string()));
  return success;
}

}  // namespace

Command surrogate_command() {
  return {"surrogate",
          "write a small file that tells the results between the settings of a campaign",
          {{.name = "FOLDER",
            .target = &Request::target,
            .about = "the campaign's folder",
            .required = true},
           {.name = "--out",
            .target = &Request::out,
            .about = "file to write: mill.json",
            .required = true},
           {.name = "--quantity",
            .target = &Request::quantities,
            .about = "a quantity of summary.json; may be repeated (default: those that the page of "
                     "the campaign shows)"},
           {"--force", &Request::force, "replace an existing file"},
           quiet(),
           json()},
          surrogate};
}

}  // namespace mahlwerk::app
