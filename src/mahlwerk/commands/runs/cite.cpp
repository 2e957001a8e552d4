// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// cite: methods paragraph and references of the models that a run uses.
#include <fmt/format.h>

#include <memory>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/runs/recorded_run.hpp"
#include "mahlwerk/report/record/citation.hpp"
#include "mahlwerk/report/record/reference_text.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

struct CiteArguments {
  std::string target;
  Changes changes;
  bool bibtex = false, json = false;
};

/// Cites what the program would use if it ran the case.
report::Citation cite_case(const fs::path& file, const CiteArguments& given) {
  cases::Case c = cases::read(file, catalogue(), given.changes.overrides());
  if (!c.sweep.empty())
    throw InputError(Fault{file.string(), "the case has a [sweep]: its runs may use other models",
                           "give the result folder of one of its runs, or a case without [sweep]",
                           "one-case"});
  c = campaign::decided_case(c, campaign::choose_engine(c));
  const report::CountedRuns counted{
      .replicates = static_cast<std::size_t>(c.run.replicates),
      .time = cases::counted_time(c),
      .settling = cases::settles(c) ? std::nullopt : std::optional(cases::least_settling(c))};
  return report::citation(c, {.engine = c.run.engine}, counted, version());
}

report::Citation cite_folder(const fs::path& folder, const CiteArguments& given) {
  if (!given.changes.overrides().empty())
    throw InputError(Fault{"--set", "a result cannot be changed",
                           "give the case to cite it with other values", "changed-result"});
  const RecordedRun run = recorded_run(folder);
  return report::citation(run.mill_case, run.state, run.counted, run.version);
}

/// A folder that is no case is meant as a result.
bool means_result(const fs::path& target) {
  std::error_code none;
  if (!fs::is_directory(target, none)) return false;
  return holds_run(target) || holds_run(target / "event") ||
         fs::exists(target / "campaign.sqlite", none);
}

results::Json json_of(const report::Citation& cited) {
  using results::Json;
  Json models = Json::array(), references = Json::array();
  for (const report::CitedUse& one : cited.models) {
    Json keys = Json::array();
    for (const std::size_t number : one.numbers) keys.push_back(cited.references[number - 1].key);
    models.push_back(Json::object(
        {{"subject", one.subject}, {"model", one.model}, {"references", std::move(keys)}}));
  }
  for (const report::Reference& one : cited.references)
    references.push_back(Json::object({{"key", one.key},
                                       {"text", report::reference_text(one)},
                                       {"doi", one.doi.empty() ? Json() : Json(one.doi)}}));
  return Json::object({{"text", report::citation_text(cited)},
                       {"bibtex", report::citation_bibtex(cited)},
                       {"paragraph", cited.paragraph},
                       {"models", std::move(models)},
                       {"references", std::move(references)}});
}

int cite(const CiteArguments& given) {
  const report::Citation cited = means_result(given.target)
                                     ? cite_folder(given.target, given)
                                     : cite_case(one_case_file(given.target, "cite"), given);
  if (given.json)
    json_to_stdout(json_of(cited));
  else
    given.bibtex ? verbatim_to_stdout(report::citation_bibtex(cited))
                 : to_stdout(report::citation_text(cited));
  return success;
}

}  // namespace

Command cite_command() {
  const auto given = std::make_shared<CiteArguments>();
  return {"cite",
          "methods paragraph and references of the models that a run uses, as text or BibTeX",
          joined({{{.name = "CASE",
                    .target = &given->target,
                    .about = "a case, or the result folder of a run",
                    .required = true}},
                  options_of(given->changes),
                  {{"--bibtex", &given->bibtex, "print the references as entries of BibTeX"},
                   json(given->json)}}),
          [given] { return cite(*given); }};
}

}  // namespace mahlwerk::commands
