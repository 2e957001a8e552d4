// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

// Where the data that Mahlwerk reads are: catalogue, papers, validation, examples.
namespace mahlwerk {

/// The folder `part` ("catalogue", "papers", "validation", "examples") of the data. It is in the
/// folder of set_data_folder() if there is one, else in share/mahlwerk beside the folder of the
/// running program, so that an installation can be moved as a whole. For the catalogue the
/// environment variable MAHLWERK_CATALOGUE goes first. Throws InputError if the folder does not
/// exist.
std::filesystem::path data_folder(std::string_view part);

/// The path of a document that messages name, "docs/errors.md#unknown-key": that of the
/// installation, beside the data, or of the sources; else as given.
std::string document(std::string_view name);

/// Sets the folder of the data, for programs that are not installed beside it: a Python module, a
/// user's own program. Call it before other threads start.
void set_data_folder(std::filesystem::path folder);

}  // namespace mahlwerk
