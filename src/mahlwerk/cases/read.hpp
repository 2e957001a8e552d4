// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/cases/file/table.hpp"

namespace mahlwerk::cases {

/// Who gives a value that is not the file's: --set, or the section that varies its key.
enum class ValueSource { command, sweep, optimise, match };

/// One "key=value" of the command line, of a campaign's point or of a search; the value is text as
/// in TOML, quotes optional.
struct Override {
  std::string key, value;
  ValueSource source = ValueSource::command;
};

/// A case file read from disk once, for many runs that differ in some of its values.
class CaseFile {
 public:
  /// Throws InputError where the file cannot be read or is no TOML.
  explicit CaseFile(const std::filesystem::path& file);
  CaseFile(const std::string& text, const std::filesystem::path& file);  ///< as read_text()

  Case read(const Catalogue& catalogue, const std::vector<Override>& overrides = {}) const;

 private:
  Node root_;
  std::filesystem::path file_;
};

/// Reads a case file, overrides applied, catalogue entries and defaults filled in, [sweep] kept as
/// it is. Throws InputError with every fault found: file, line, what, remedy.
Case read(const std::filesystem::path& file, const Catalogue& catalogue,
          const std::vector<Override>& overrides = {});

/// The same from text; `file` is the name faults cite and the folder other files are relative to.
Case read_text(const std::string& text, const std::filesystem::path& file,
               const Catalogue& catalogue, const std::vector<Override>& overrides = {});

/// What [fit] of a case file says, nothing else of it read; empty without [fit]. Throws InputError.
/// To read the whole case before these have values, give each one as an override.
std::map<std::string, FitRange> fit_ranges(const std::filesystem::path& file);

/// The resolved case as TOML: every value, its origin as a comment behind it. read_text(write(c))
/// == c.
std::string write(const Case& c);

/// What the files a case names hold, the jar's mesh and the measured motion, as a fingerprint:
/// another file under the same name is another case.
std::string input_files_fingerprint(const Case& c);

/// Faults of a case as a whole, wherever it came from: values out of range, a ball that does not
/// fit its jar. Empty if it makes sense. Called by read(); bindings and tests call it too.
std::vector<Fault> faults(const Case& c);

/// Where the value under `key` was said; the key itself if that is no place in a file. A key that
/// is searched over is "optimise.over." and its name.
std::string location_of(const Case& c, const std::string& key);

/// What keeps the engines of this version from running a case that makes sense otherwise. Not
/// called by read(), so that such a case can be checked.
std::vector<Fault> engine_faults(const Case& c);

/// Whether two balls of the case are together as wide as the jar, to a millionth: hard spheres that
/// lie across it have no room to bounce.
bool fits_exactly(const Case& c);

}  // namespace mahlwerk::cases
