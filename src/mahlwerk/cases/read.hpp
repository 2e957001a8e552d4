// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/catalogue.hpp"

namespace mahlwerk::cases {

struct Node;

/// Source of a value that overrides the file's: --set, or the section that varies the key.
enum class ValueSource { command, sweep, optimise, match, fit, uncertainty };

/// One "key=value" of the command line, of a campaign's point or of a search. The value is written
/// as in TOML; quotes are optional.
struct Override {
  std::string key, value;
  ValueSource source = ValueSource::command;
  bool unset = false;  ///< --unset: takes the key, or a whole section, from the case; no `value`
};

/// Whether one of them gives the key a value.
bool gives_value(const std::vector<Override>& overrides, std::string_view key);

/// A case file that is parsed once, for many runs with different overrides.
class CaseFile {
 public:
  /// Throws InputError if the file cannot be read or is not valid TOML.
  explicit CaseFile(const std::filesystem::path& file);
  CaseFile(const std::string& text, const std::filesystem::path& file);  ///< as read_text()

  Case read(const Catalogue& catalogue, const std::vector<Override>& overrides = {}) const;

 private:
  std::shared_ptr<const Node> root_;
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

/// Whether a key of [fit] is one of the mill: of [contact], [mill], [jar], [[balls]] or
/// [power_meter], for which the mill is run. Others are numbers of powder models, which can be
/// fitted to one run.
bool is_key_of_run(std::string_view key);

/// Whether a key may vary from replicate to replicate, in [uncertainty]: one of [contact] or
/// [mill].
bool is_key_of_draw(std::string_view key);

}  // namespace mahlwerk::cases
