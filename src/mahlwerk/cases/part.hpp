// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/keys.hpp"

// A part of a run is what is evaluated beside the motion of the balls: wear, temperatures, a
// sensor. All that the stages of a run need to know of it is one record, Part; each stage calls the
// functions of its own stage for all parts(), and names none. The types of later stages are only
// declared here, so that the record of a part can stand below them all.
namespace mahlwerk::observe {
class Recorder;
}
namespace mahlwerk::results {
struct Measure;
struct NamedTable;
struct Outcome;
struct WallColumn;
}  // namespace mahlwerk::results

namespace mahlwerk::cases {

class KeyVisitor;
struct Findings;
struct Node;

/// A section of a case that belongs to a part.
struct PartSection {
  SectionSpec spec;
  bool (*present)(const Case& c);
  /// Adds it with default values; null for a section that comes with another one.
  void (*add)(Case& c);
  /// Visits its keys with their values in the case. A reader sets them; the case then has the
  /// section.
  void (*describe)(KeyVisitor& v, Case& c);
};

/// The tables of a case file, for sections that are read together.
class SectionTables {
 public:
  virtual ~SectionTables() = default;
  virtual const Node* table(std::string_view section) = 0;  ///< null if the file lacks it
};

/// One record of a part. A member is null where the part has nothing to say. Functions of a case or
/// an outcome are called for those that have a section of the part.
struct Part {
  std::string_view name;  ///< of its folder: "thermocouple"
  // The case.
  std::vector<PartSection> sections = {};
  /// Reads its sections together; null: each by its describe().
  void (*read)(SectionTables& tables, Case& c, Findings& findings) = nullptr;
  /// Adds what is wrong with valid values of its sections.
  void (*check)(const Case& c, std::vector<Fault>& found) = nullptr;
  /// Whether it needs the value of a key of another section, by the last part of the key
  /// ("hardness"), or the whole ("jar.wall").
  bool (*needs)(const Case& c, std::string_view key) = nullptr;
  // The run.
  /// What it records in a replicate; null if this case asks for no record.
  std::unique_ptr<observe::Recorder> (*recorder)(const Case& c) = nullptr;
  // The result.
  std::vector<results::Measure> (*quantities)() = nullptr;
  std::vector<results::NamedTable> (*tables)(const results::Outcome& outcome) = nullptr;
  std::vector<results::WallColumn> (*wall_columns)() = nullptr;  ///< of wall_map.csv
  Notices (*notices)(const results::Outcome& outcome) = nullptr;
  // The report.
  std::string_view heading = {};  ///< of its panel; parts that follow each other share one
  std::string (*panel)(const results::Outcome& outcome) = nullptr;  ///< HTML; may be empty
};

/// All parts, in the order of sections, quantities and panels (parts/parts.cpp).
std::span<const Part* const> parts();
/// Those of which the case has a section.
std::vector<const Part*> parts_of(const Case& c);

/// A section with values of type `Section`, which the case holds without knowing them.
template <class Section, void (*describe)(KeyVisitor&, Section&, const Case&)>
PartSection section_of(const SectionSpec& spec) {
  return {.spec = spec,
          .present = [](const Case& c) { return c.parts.find<Section>() != nullptr; },
          .add = [](Case& c) { c.parts.set(Section()); },
          .describe =
              [](KeyVisitor& v, Case& c) {
                const Section* now = c.parts.find<Section>();
                Section values = now != nullptr ? *now : Section();
                describe(v, values, c);
                c.parts.set(std::move(values));
              }};
}

/// A section with values in a member of Case, because the run itself reads them.
template <auto member, auto describe>
PartSection section_in_case(const SectionSpec& spec) {
  return {.spec = spec,
          .present = [](const Case& c) { return (c.*member).has_value(); },
          .add = [](Case& c) { (c.*member).emplace(); },
          .describe =
              [](KeyVisitor& v, Case& c) {
                auto values = (c.*member).value_or(std::decay_t<decltype(*(c.*member))>());
                describe(v, values, c);
                c.*member = std::move(values);
              }};
}

}  // namespace mahlwerk::cases
