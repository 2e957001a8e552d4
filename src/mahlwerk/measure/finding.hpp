// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::measure {

/// A measured number with its 95 % half-width.
struct Finding {
  std::string key;    ///< of a case, "mill.arm"; empty: none
  std::string label;  ///< "length of the arm"
  std::string unit;   ///< SI
  observe::Estimate value;
};

/// What an analysis found.
struct Findings {
  std::vector<Finding> list;
  /// Products of half-widths of list[i] and list[j] at i n + j; empty: independent.
  std::vector<double> covariance;
  std::vector<std::string> remarks;  ///< what the user should know, full sentences
};

}  // namespace mahlwerk::measure
