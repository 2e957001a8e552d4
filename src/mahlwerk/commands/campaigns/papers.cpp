// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// papers: hands over to the Python package, which runs the campaigns of a paper, draws its figures
// and judges its checks (docs/papers.md).
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/campaigns/child_process.hpp"
#include "mahlwerk/commands/reporting/listener.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

struct PapersArguments : CaseArguments {
  bool quick = false;  ///< without those that take long
  std::vector<std::string> leave_out;
  std::optional<double> checkpoint;  ///< [s]
};

/// Ends with the names of what is missing on stderr.
constexpr const char* probe = R"(import sys
from importlib.util import find_spec
missing = [one for one in ('mahlwerk', 'numpy', 'matplotlib') if find_spec(one) is None]
if missing:
    sys.exit(' and '.join(missing))
try:
    import mahlwerk
except ImportError as error:
    sys.exit(f'a module mahlwerk for this Python: {error}')
)";

/// PYTHONPATH: first the package of the build folder that the program belongs to, if it is in one.
std::string python_path() {
  const char* before = std::getenv("PYTHONPATH");
  std::string path = before == nullptr ? "" : before;
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const fs::path built = program.parent_path().parent_path() / "python";
  if (!failed && fs::exists(built / "mahlwerk" / "__init__.py", failed))
    path = built.string() + (path.empty() ? "" : ":") + path;
  return path;
}

/// A Python that has all that papers need: MAHLWERK_PYTHON, that of the search path, or that of the
/// system. Throws InputError that says what to install.
std::string python_for_papers(const std::string& path) {
  std::vector<std::string> candidates{"python3", "/usr/bin/python3"};
  if (const char* named = std::getenv("MAHLWERK_PYTHON")) candidates = {named};
  std::string why = "Python is not installed";
  for (const std::string& python : candidates) {
    const ProgramEnd end = run_program({python, "-c", probe}, "PYTHONPATH=" + path);
    if (end.start_error == 0 && end.status == 0) return python;
    if (end.start_error != 0) continue;
    const std::string missing = end.errors.substr(0, end.errors.find('\n'));
    why = fmt::format("{} lacks {}", python, missing.empty() ? "the packages" : missing);
  }
  throw InputError(Fault{"mahlwerk papers", "papers are judged and drawn in Python: " + why,
                         "install python3-mahlwerk, python3-numpy and python3-matplotlib, or name "
                         "a Python that has them by MAHLWERK_PYTHON",
                         "no-python"});
}

std::vector<std::string> words_of(const PapersArguments& given) {
  std::vector<std::string> words;
  const auto add = [&](const char* option, std::string value) {
    words.push_back(fmt::format("{}={}", option, value));
  };
  for (const cases::Override& one : given.changes.set)
    add("--set", fmt::format("{}={}", one.key, one.value));
  for (const std::string& key : given.changes.unset) add("--unset", key);
  if (given.changes.seed) add("--seed", std::to_string(*given.changes.seed));
  if (given.running.out) add("--out", given.running.out->string());
  if (given.running.threads > 0) add("--jobs", std::to_string(given.running.threads));
  if (given.checkpoint) add("--checkpoint", fmt::format("{:.6g}", *given.checkpoint));
  for (const std::string& campaign : given.leave_out) add("--leave-out", campaign);
  for (const auto& [is, flag] :
       {std::pair{given.quick, "--quick"}, std::pair{given.running.force, "--force"},
        std::pair{given.running.quiet, "--quiet"}, std::pair{given.running.json, "--json"}})
    if (is) words.emplace_back(flag);
  words.insert(words.end(), {"--", given.target});
  return words;
}

/// Becomes the Python program: signals and the exit code are its own.
int papers(const PapersArguments& given) {
  if (listener() != nullptr)
    throw InputError(Fault{"papers", "this command runs in Python itself",
                           "call mahlwerk.papers.run_paper(folder, out)", "bad-command-line"});
  const std::string path = python_path(), python = python_for_papers(path);
  std::vector<std::string> words{python, "-m", "mahlwerk.papers"};
  for (std::string& word : words_of(given)) words.push_back(std::move(word));
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  if (!path.empty()) ::setenv("PYTHONPATH", path.c_str(), 1);
  ::setenv("PYTHONSAFEPATH", "1", 1);  // files of the current folder are no modules
  ::execvp(python.c_str(), arguments.data());
  throw std::system_error(errno, std::generic_category(), python);
}

}  // namespace

Command papers_command() {
  const auto given = std::make_shared<PapersArguments>();
  return {"papers", "regenerate every figure of a paper and test its claims",
          joined({{{"PAPER", &given->target,
                    "a folder of papers/ or validation/, any folder with a paper.py, or "
                    "\"validation\": all sets of measured data (default: all papers)"}},
                  options_of(given->changes),
                  {{"--quick", &given->quick, "leave out the papers whose file says quick=False"},
                   {.name = "--leave-out",
                    .target = &given->leave_out,
                    .about = "leave out the figures, checks and tables of a campaign; may be "
                             "repeated",
                    .type = "CAMPAIGN"}},
                  options_of(given->running, "; papers in results/papers"),
                  {checkpoint(given->checkpoint,
                              "seconds between two checkpoints of a run, from which the same "
                              "command resumes (default 60)"),
                   json(given->running.json)}}),
          [given] { return papers(*given); }};
}

}  // namespace mahlwerk::commands
