// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// surrogate: writes the surrogate of a campaign to a file, which ask evaluates.
#include "mahlwerk/commands/campaigns/surrogate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/surrogate/campaign_surrogate.hpp"
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

/// Those of the quantities `names` that vary over the settings.
std::vector<std::string> varying(const campaign::Store& store,
                                 const std::vector<std::string>& names) {
  std::vector<double> least(names.size(), INFINITY), most(names.size(), -INFINITY);
  store.read(names, [&](const campaign::Point& point) {
    if (point.state != campaign::RunState::done) return;
    for (std::size_t i = 0; i < names.size(); ++i) {
      least[i] = std::fmin(least[i], point.value[i]);
      most[i] = std::fmax(most[i], point.value[i]);
    }
  });
  std::vector<std::string> found;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (most[i] > least[i]) found.push_back(names[i]);
  return found;
}

/// The varying quantities among those that the page of a campaign shows. Throws InputError, with
/// others that vary, if there is none.
std::vector<std::string> usual_quantities(const campaign::Store& store, const std::string& folder) {
  std::vector<std::string> all, usual;
  for (const results::Quantity& q : store.quantities()) {
    all.push_back(q.name);
    if (std::ranges::find(results::usual_columns(), q.name) != results::usual_columns().end())
      usual.push_back(q.name);
  }
  if (std::vector<std::string> found = varying(store, usual); !found.empty()) return found;
  const std::vector<std::string> others = varying(store, all);
  throw InputError(
      Fault{folder,
            "none of the quantities that the page of the campaign shows varies over the "
            "settings that have ended",
            others.empty() ? "finish the campaign, or sweep a key that has an effect"
                           : fmt::format("choose with --quantity: {}", fmt::join(others, ", ")),
            "no-surrogate"});
}

/// Writes the file, unless there is one that `replace` does not allow to be replaced.
void write_surrogate(const fs::path& name, const std::string& text, bool replace) {
  const auto refuse = [&](const char* what, const char* remedy, const char* code) {
    throw InputError(Fault{name.string(), what, remedy, code});
  };
  if (name.empty())
    refuse("--out gives no name", "write for instance --out mill.json", "cannot-write");
  std::error_code failed;
  const bool there = fs::exists(fs::symlink_status(name, failed));
  if (there && !replace)
    refuse("the file already exists", "choose another name, or replace it with --force",
           "result-exists");
  const fs::path file = fs::is_symlink(name, failed) ? fs::weakly_canonical(name, failed) : name;
  if (fs::exists(file, failed) && !fs::is_regular_file(file, failed))
    refuse("this is no file but a folder or device", "give the name of a file", "cannot-write");
  if (!file.parent_path().empty()) results::make_folder(file.parent_path());
  results::write_whole(file, text);
}

struct SurrogateArguments {
  std::string folder;
  std::optional<fs::path> out;
  std::vector<std::string> quantities;  ///< empty: the usual ones
  bool force = false, quiet = false, json = false;
};

int surrogate(const SurrogateArguments& given) {
  const campaign::Store store = campaign::open_store(given.folder);
  const std::vector<std::string> names =
      given.quantities.empty() ? usual_quantities(store, given.folder) : given.quantities;
  const campaign::CampaignSurrogate made =
      campaign::surrogate_of(store, given.folder, names, version());
  write_surrogate(*given.out, campaign::surrogate_text(made), given.force);
  if (given.json) json_to_stdout(surrogate_json(made));
  if (given.json || given.quiet) return success;
  to_stdout(surrogate_words(made) + '\n');
  places_to_stdout({{"surrogate", *given.out}});
  return success;
}

}  // namespace

Command surrogate_command() {
  const auto given = std::make_shared<SurrogateArguments>();
  return {"surrogate",
          "write a small file that tells the results between the settings of a campaign",
          {{.name = "FOLDER",
            .target = &given->folder,
            .about = "the campaign's folder",
            .required = true},
           {.name = "--out",
            .target = &given->out,
            .about = "file to write: mill.json",
            .required = true},
           {.name = "--quantity",
            .target = &given->quantities,
            .about = "a quantity of summary.json; may be repeated (default: those that the page of "
                     "the campaign shows)"},
           {"--force", &given->force, "replace an existing file"},
           quiet(given->quiet),
           json(given->json)},
          [given] { return surrogate(*given); }};
}

}  // namespace mahlwerk::commands
