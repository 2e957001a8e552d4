// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/ro_crate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "mahlwerk/report/record/property_values.hpp"
#include "mahlwerk/report/record/reference_text.hpp"

namespace mahlwerk::report {
namespace {

using results::Json;
using Texts = std::pair<std::string_view, std::string_view>;

std::string_view looked_up(std::span<const Texts> table, std::string_view key,
                           std::string_view otherwise) {
  const auto found = std::ranges::find(table, key, &Texts::first);
  return found == table.end() ? otherwise : found->second;
}

constexpr std::array formats{Texts{"json", "application/json"}, Texts{"toml", "application/toml"},
                             Texts{"html", "text/html"},        Texts{"csv", "text/csv"},
                             Texts{"h5", "application/x-hdf5"}, Texts{"stl", "model/stl"},
                             Texts{"xyz", "chemical/x-xyz"}};

constexpr std::array contents{
    Texts{"summary.json", "every quantity with value, interval, unit and meaning"},
    Texts{"case.resolved.toml", "the case: every value that was used, with its source"},
    Texts{"report.html", "report with plots and a replay"},
    Texts{"result.h5", "quantities, tables and maps in one file"},
    Texts{"collisions.h5", "every collision"}};

Json id(std::string_view of) {
  return Json::object({{"@id", of}});
}

/// One value instead of a list of one, as the specification asks for.
Json compact(std::vector<Json> list) {
  return list.size() == 1 ? std::move(list.front()) : Json(list);
}

/// A path as a URI: blanks, percent signs and other special characters escaped.
std::string uri(std::string_view path) {
  constexpr std::string_view special = " %\"<>\\^`{|}#?[]";
  std::string made;
  for (const char c : path)
    if (special.find(c) == std::string_view::npos && static_cast<unsigned char>(c) >= 0x20)
      made += c;
    else
      made += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return made;
}

/// The graph of a crate, entity by entity.
class Crate {
 public:
  explicit Crate(const CrateContent& content) : c_(content) {}

  Json made() {
    Json root = Json::object({{"@id", "./"}, {"@type", "Dataset"}});
    root["name"] = c_.mill_case.title.empty() ? "Run of a ball mill" : c_.mill_case.title;
    root["description"] = c_.methods;
    root["datePublished"] = c_.date;
    root["license"] = license();
    if (!c_.authors.empty()) root["author"] = compact(authors());
    root["hasPart"] = compact(parts());
    root["variableMeasured"] = compact(ids_of(result_values(c_.summary)));
    root["citation"] = compact(publications());
    if (auto found = warnings(); !found.empty()) root["comment"] = compact(std::move(found));
    root["mentions"] = action();
    Json graph = Json::array({descriptor(), std::move(root)});
    for (Json& entity : entities_) graph.push_back(std::move(entity));
    return Json::object(
        {{"@context", "https://w3id.org/ro/crate/1.1/context"}, {"@graph", std::move(graph)}});
  }

 private:
  /// Adds an entity to the graph and refers to it.
  Json add(Json entity) {
    Json reference = Json::object({{"@id", entity["@id"]}});
    entities_.push_back(std::move(entity));
    return reference;
  }
  std::vector<Json> ids_of(std::vector<Json> entities) {
    std::vector<Json> ids;
    for (Json& one : entities) ids.push_back(add(std::move(one)));
    return ids;
  }

  static Json descriptor() {
    return Json::object({{"@id", crate_file},
                         {"@type", "CreativeWork"},
                         {"conformsTo", id("https://w3id.org/ro/crate/1.1")},
                         {"about", id("./")}});
  }

  Json license() {
    if (c_.license.empty()) return "No license is given: ask the authors before you use the data.";
    const bool address = c_.license.find("://") != std::string::npos;
    return add(
        Json::object({{"@id", address ? c_.license : "https://spdx.org/licenses/" + c_.license},
                      {"@type", "CreativeWork"},
                      {"name", c_.license},
                      {"description", fmt::format("The data may be used under {}.", c_.license)}}));
  }

  std::string author_id(std::size_t i) const {
    const std::string& orcid = c_.authors[i].orcid;
    return orcid.empty() ? fmt::format("#author-{}", i + 1) : "https://orcid.org/" + orcid;
  }
  std::vector<Json> authors() {
    std::vector<Json> list;
    for (std::size_t i = 0; i < c_.authors.size(); ++i)
      list.push_back(add(Json::object(
          {{"@id", author_id(i)}, {"@type", "Person"}, {"name", c_.authors[i].name}})));
    return list;
  }

  std::vector<Json> parts() {
    std::vector<Json> list;
    for (const CratePart& part : c_.parts) {
      const bool folder = part.path.ends_with('/');
      const std::string extension = part.path.substr(part.path.rfind('.') + 1);
      Json entity = Json::object(
          {{"@id", uri(part.path)}, {"@type", folder ? "Dataset" : "File"}, {"name", part.path}});
      if (const auto about = looked_up(contents, part.path, extension == "csv" ? "table" : "");
          !about.empty())
        entity["description"] = about;
      if (!folder) {
        entity["encodingFormat"] = looked_up(formats, extension, "application/octet-stream");
        entity["contentSize"] = fmt::format("{}", part.bytes);
      }
      list.push_back(add(std::move(entity)));
    }
    return list;
  }

  std::vector<Json> publications() {
    std::vector<Json> list;
    for (const Reference& one : c_.cited.references) {
      if (one.key == program_reference("").key) continue;  // the instrument of the action
      const bool in_journal = one.kind == Reference::Kind::article;
      list.push_back(
          add(Json::object({{"@id", one.doi.empty() ? "#" + one.key : "https://doi.org/" + one.doi},
                            {"@type", in_journal ? "ScholarlyArticle" : "CreativeWork"},
                            {"name", one.title},
                            {"description", reference_text(one)}})));
    }
    return list;
  }

  std::vector<Json> warnings() {
    std::vector<Json> list;
    const Json* about = c_.summary.find("_about");
    const Json* found = about == nullptr ? nullptr : about->find("warnings");
    if (found == nullptr || !std::holds_alternative<Json::Array>(found->value())) return list;
    for (const Json& text : std::get<Json::Array>(found->value()))
      list.push_back(add(Json::object({{"@id", fmt::format("#warning-{}", list.size() + 1)},
                                       {"@type", "Comment"},
                                       {"name", "Warning of the program"},
                                       {"text", text}})));
    return list;
  }

  Json instrument() {
    return add(Json::object({{"@id", "#mahlwerk"},
                             {"@type", "SoftwareApplication"},
                             {"name", "Mahlwerk"},
                             {"version", c_.version},
                             {"description", reference_text(program_reference(c_.version))}}));
  }

  /// The run: what made the files from the case and the conditions.
  Json action() {
    std::vector<Json> inputs{id(uri(c_.case_file))}, outputs;
    for (Json& one : ids_of(condition_values(c_.mill_case))) inputs.push_back(std::move(one));
    for (const CratePart& part : c_.parts)
      if (part.path != c_.case_file) outputs.push_back(id(uri(part.path)));
    Json made = Json::object(
        {{"@id", "#run"}, {"@type", "CreateAction"}, {"name", "Simulation of the mill"}});
    made["instrument"] = instrument();
    if (!c_.authors.empty()) made["agent"] = id(author_id(0));
    made["object"] = compact(std::move(inputs));
    made["result"] = compact(std::move(outputs));
    made["actionStatus"] = id(c_.failure.empty() ? "http://schema.org/CompletedActionStatus"
                                                 : "http://schema.org/FailedActionStatus");
    if (!c_.failure.empty()) made["error"] = c_.failure;
    return add(std::move(made));
  }

  const CrateContent& c_;
  std::vector<Json> entities_;
};

}  // namespace

Json ro_crate(const CrateContent& content) {
  return Crate(content).made();
}

}  // namespace mahlwerk::report
