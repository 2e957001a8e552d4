// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/svg_element.hpp"

#include <fmt/format.h>

#include "mahlwerk/report/plot/colours.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {

std::string svg_head(double width, double height, std::string_view title, double font) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" "
      "aria-label=\"{2}\" width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"Helvetica,Arial,"
      "Liberation Sans,DejaVu Sans,sans-serif\" font-size=\"{3:g}\" fill=\"{4}\">\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"{5}\"/>\n",
      width, height, escaped(title), font, ink_colour, ground_colour);
}

}  // namespace mahlwerk::report
