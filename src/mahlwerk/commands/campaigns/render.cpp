// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/campaigns/render.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "mahlwerk/commands/campaigns/child_process.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::optional<Fault> render_figures(const std::vector<fs::path>& svg_files) {
  constexpr double zoom = 300.0 / 96;  // px per inch of the PNG over those of SVG
  constexpr const char* code = "figures-not-converted";
  for (const fs::path& svg : svg_files)
    for (const std::string format : {"pdf", "png"}) {
      const fs::path file = fs::path(svg).replace_extension(format);
      std::vector<std::string> words{"rsvg-convert", "--format", format, "--output", file.string()};
      if (format == "png") words.insert(words.end(), {"--zoom", fmt::format("{}", zoom)});
      words.push_back(svg.string());
      // With a fixed date in the PDF files, equal figures are equal files.
      const ProgramEnd end = run_program(std::move(words), "SOURCE_DATE_EPOCH=0");
      if (end.start_error == ENOENT)
        return Fault{"figures", "there are no PDF and PNG files: rsvg-convert is not installed",
                     "install it (apt install librsvg2-bin) and run the command again with --force",
                     code};
      if (end.start_error == 0 && end.status == 0) continue;
      std::error_code ignored;
      fs::remove(file, ignored);
      const std::string why = end.start_error != 0 ? std::string(std::strerror(end.start_error))
                                                   : end.errors.substr(0, end.errors.find('\n'));
      return Fault{"figures/" + file.filename().string(),
                   fmt::format("rsvg-convert failed{}{}; PDF and PNG files are missing",
                               why.empty() ? "" : ": ", why),
                   "convert the SVG files with another program", code};
    }
  return std::nullopt;
}

}  // namespace mahlwerk::commands
