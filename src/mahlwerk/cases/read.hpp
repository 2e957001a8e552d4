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

/// Source of a value that overrides the file's: --set, or the section that varies the key.
enum class ValueSource { command, sweep, optimise, match, fit, uncertainty };

/// One "key=value" of the command line, of a campaign's point or of a search. The value is written
/// as in TOML; quotes are optional.
struct Override {
  std::string key, value;
  ValueSource source = ValueSource::command;
};

/// A case file that is parsed once, for many runs with different overrides.
class CaseFile {
 public:
  /// Throws InputError if the file cannot be read or is not valid TOML.
  explicit CaseFile(const std::filesystem::path& file);
  CaseFile(const std::string& text, const std::filesystem::path& file);  ///< as read_text()

  Case read(const Catalogue& catalogue, const std::vector<Override>& overrides = {}) const;

 private:
  Node root_;
  std::filesystem::path file_;
};

/// Reads a case file, applies overrides, and fills in catalogue entries and defaults; [sweep] is
/// not expanded. Throws InputError with all faults found: file, line, what, remedy.
Case read(const std::filesystem::path& file, const Catalogue& catalogue,
          const std::vector<Override>& overrides = {});

/// Reads a case from text. Faults cite the name `file`; paths in the case are relative to its
/// folder.
Case read_text(const std::string& text, const std::filesystem::path& file,
               const Catalogue& catalogue, const std::vector<Override>& overrides = {});

/// The ranges of [fit] of a case file; empty without [fit]. Reads no other section, because the
/// fitted keys may have no value yet: to read the whole case, give each of them as an override.
/// Throws InputError.
std::map<std::string, FitRange> fit_ranges(const std::filesystem::path& file);

/// Whether a key of [fit] is one of [contact] or [mill], which decides how the balls move. Others
/// are numbers of powder models, which can be fitted to one run.
bool is_key_of_run(std::string_view key);

/// The resolved case as TOML: every value, followed by its origin as a comment.
/// read_text(write(c)) == c.
std::string write(const Case& c);

/// Fingerprint of the contents of the files that a case names: the jar's mesh and the measured
/// motion. Distinguishes cases whose files have equal names but different contents.
std::string input_files_fingerprint(const Case& c);

/// Faults of a complete case, read or constructed: values out of range, a ball that does not fit
/// its jar. Empty for a valid case. read() calls it; bindings and tests call it directly.
std::vector<Fault> faults(const Case& c);

/// File and line, or option, that gave the value of `key`; the key itself for a default. The key of
/// a search range is "optimise.over." followed by the key searched over.
std::string location_of(const Case& c, const std::string& key);

/// Faults of a valid case that the engines of this version cannot run. read() does not call it, so
/// that such a case can still be checked.
std::vector<Fault> engine_faults(const Case& c);

/// Whether the diameters of two balls sum to the width of the jar, to 1e-6 of it: hard spheres that
/// lie across the jar then have no room to bounce.
bool fits_exactly(const Case& c);
/// Whether the case has a liquid that only the soft engine takes: around the balls, or one that
/// resists the rebound.
bool liquid_needs_soft(const Case& c);

}  // namespace mahlwerk::cases
