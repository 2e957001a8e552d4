// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The file of a surrogate.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

#include "mahlwerk/campaign/surrogate/campaign_surrogate.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::campaign {
namespace {

using results::Json;

constexpr std::int64_t format = 1;

Json json_of(const SurrogateQuantity& q) {
  const OutcomeModel& model = q.emulator.model;
  const Kernel& kernel = model.process.kernel();
  Json values = Json::array(), variances = Json::array(), points = Json::array();
  for (const Observation& one : model.process.observations()) {
    values.push_back(one.value);
    variances.push_back(one.variance);
    points.push_back(one.point);
  }
  return Json::object({{"unit", q.unit},
                       {"about", q.about},
                       {"hold_out_error", q.hold_out.error},
                       {"widening", q.hold_out.widening},
                       {"hold_out_coverage", q.hold_out.coverage},
                       {"logarithm", q.emulator.logarithmic},
                       {"centre", model.centre},
                       {"scale", model.scale},
                       {"noise", model.noise},
                       {"amplitude", kernel.amplitude},
                       {"constant", kernel.constant},
                       {"length_scales", kernel.length_scales},
                       {"points", std::move(points)},
                       {"values", std::move(values)},
                       {"variances", std::move(variances)}});
}

/// Reads values of the file; each throws InputError if it is missing or of another kind.
class FileReader {
 public:
  explicit FileReader(const std::filesystem::path& file) : file_(file) {}

  InputError damaged(const std::string& what) const {
    return InputError(Fault{file_.generic_string(), what,
                            "make the surrogate again: mahlwerk surrogate FOLDER --out FILE",
                            "cannot-read"});
  }
  const Json& at(const Json& in, const std::string& key) const {
    const Json* there = in.find(key);
    if (there == nullptr) throw damaged(fmt::format("this is no surrogate: it has no `{}`", key));
    return *there;
  }
  template <class T>
  const T& as(const Json& value, const std::string& key) const {
    const T* held = std::get_if<T>(&value.value());
    if (held == nullptr) throw damaged(fmt::format("`{}` has a value of the wrong kind", key));
    return *held;
  }
  template <class T>
  const T& as_member(const Json& in, const std::string& key) const {
    return as<T>(at(in, key), key);
  }
  std::string text(const Json& in, const std::string& key) const {
    return as_member<std::string>(in, key);
  }
  double number(const Json& value, const std::string& key) const {
    if (const auto* whole = std::get_if<std::uint64_t>(&value.value()))
      return static_cast<double>(*whole);
    if (const auto* whole = std::get_if<std::int64_t>(&value.value()))
      return static_cast<double>(*whole);
    return as<double>(value, key);
  }
  double number_at(const Json& in, const std::string& key) const {
    return number(at(in, key), key);
  }
  std::size_t count(const Json& in, const std::string& key) const {
    return static_cast<std::size_t>(as_member<std::uint64_t>(in, key));
  }
  std::vector<double> numbers(const Json& value, const std::string& key) const {
    std::vector<double> made;
    for (const Json& one : as<Json::Array>(value, key)) made.push_back(number(one, key));
    return made;
  }
  std::vector<std::string> texts(const Json& in, const std::string& key) const {
    std::vector<std::string> made;
    for (const Json& one : as_member<Json::Array>(in, key))
      made.push_back(as<std::string>(one, key));
    return made;
  }

 private:
  std::filesystem::path file_;
};

SurrogateKey key_of(const FileReader& read, const Json& in) {
  SurrogateKey made{read.text(in, "key"), read.text(in, "from"), read.text(in, "to"),
                    read.as_member<bool>(in, "logarithm")};
  try {
    if (!(parse_quantity(made.least).value < parse_quantity(made.most).value) ||
        made.position(made.least) != 0.0 || made.position(made.most) != 1.0)
      throw read.damaged(fmt::format("the range of {} is empty", made.key));
  } catch (const UnitError& error) {
    throw read.damaged(fmt::format("the range of {}: {}", made.key, error.what()));
  }
  return made;
}

std::vector<Observation> observations_of(const FileReader& read, const Json& in, std::size_t keys) {
  const auto& points = read.as_member<Json::Array>(in, "points");
  const std::vector<double> values = read.numbers(read.at(in, "values"), "values"),
                            variances = read.numbers(read.at(in, "variances"), "variances");
  if (points.size() > CampaignSurrogate::most_settings)
    throw read.damaged(
        fmt::format("it has more than {} settings", CampaignSurrogate::most_settings));
  if (points.empty() || points.size() != values.size() || points.size() != variances.size())
    throw read.damaged("`points`, `values` and `variances` have different lengths");
  std::vector<Observation> made;
  for (std::size_t i = 0; i < points.size(); ++i) {
    made.push_back({read.numbers(points[i], "points"), values[i], variances[i]});
    if (made.back().point.size() != keys) throw read.damaged("a point has too few or many numbers");
    for (const double place : made.back().point)
      if (!(place >= 0 && place <= 1))
        throw read.damaged("a point lies outside the range of its keys");
    if (!(variances[i] > 0)) throw read.damaged("a variance is not above 0");
  }
  return made;
}

SurrogateQuantity quantity_of(const FileReader& read, const Json::Member& in, std::size_t keys) {
  const Json& q = in.value;
  const Kernel kernel{read.number_at(q, "amplitude"),
                      read.numbers(read.at(q, "length_scales"), "length_scales"),
                      read.number_at(q, "constant")};
  if (kernel.length_scales.size() != keys)
    throw read.damaged("`length_scales` has too few or many numbers");
  for (const double length : kernel.length_scales)
    if (!(length > 0)) throw read.damaged("a length scale is not above 0");
  const HoldOut others{read.number_at(q, "hold_out_error"), read.number_at(q, "widening"),
                       read.number_at(q, "hold_out_coverage")};
  if (!(others.error >= 0 && others.widening >= 1 && others.coverage >= 0 &&
        others.coverage <= 1 + 1e-9))
    throw read.damaged("`hold_out_error`, `widening` or `hold_out_coverage` is out of range");
  SurrogateQuantity made{
      in.key,
      read.text(q, "unit"),
      read.text(q, "about"),
      {{GaussianProcess(kernel, observations_of(read, q, keys)), read.number_at(q, "centre"),
        read.number_at(q, "scale"), read.number_at(q, "noise")},
       read.as_member<bool>(q, "logarithm")},
      others};
  const OutcomeModel& model = made.emulator.model;
  const observe::IntervalEstimate middle = predict(made, DesignPoint(keys, 0.5));
  if (!(model.scale > 0 && kernel.amplitude > 0 && std::isfinite(middle.low) &&
        std::isfinite(middle.high)))
    throw read.damaged(fmt::format("the numbers of {} give no result", in.key));
  return made;
}

results::NoticeCounts notices_of(const FileReader& read, const Json& in) {
  results::NoticeCounts made;
  for (const Json& one : read.as_member<Json::Array>(in, "notices"))
    made.push_back(
        {{read.text(one, "code"), severity_of(read.text(one, "severity")), read.text(one, "text")},
         read.count(one, "count")});
  return made;
}

Json parsed(const FileReader& read, const std::filesystem::path& file) {
  std::error_code none;
  std::string text;
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, none)) {
    stream.open(file, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(stream), {});
  }
  if (!stream.is_open() || stream.bad())
    throw InputError(Fault{file.generic_string(), "there is no such file, or it cannot be read",
                           "name the file that `mahlwerk surrogate FOLDER --out FILE` wrote",
                           "no-such-file"});
  try {
    return Json::parse(text);
  } catch (const std::invalid_argument&) {
    throw read.damaged("this is no surrogate: it is not JSON, or a part is missing");
  }
}

}  // namespace

std::string surrogate_text(const CampaignSurrogate& s) {
  Json keys = Json::array(), quantities = Json::object();
  for (const SurrogateKey& key : s.keys)
    keys.push_back(Json::object(
        {{"key", key.key}, {"from", key.least}, {"to", key.most}, {"logarithm", key.logarithmic}}));
  for (const SurrogateQuantity& q : s.quantities) quantities[q.name] = json_of(q);
  return Json::object({{"surrogate", format},
                       {"mahlwerk", s.version},
                       {"title", s.title},
                       {"digest", s.digest},
                       {"settings", s.settings},
                       {"failed", s.failed},
                       {"engines", s.engines},
                       {"keys", std::move(keys)},
                       {"following", s.following},
                       {"notices", results::notices_json(s.notices)},
                       {"quantities", std::move(quantities)}})
             .text() +
         '\n';
}

CampaignSurrogate read_surrogate(const std::filesystem::path& file) {
  const FileReader read(file);
  const Json all = parsed(read, file);
  const double written = read.number_at(all, "surrogate");
  if (written != static_cast<double>(format))
    throw InputError(
        Fault{file.generic_string(),
              fmt::format("the surrogate has format {}, this program reads {}", written, format),
              "use the version of Mahlwerk that made it, or make it again", "cannot-read"});
  CampaignSurrogate made{.title = read.text(all, "title"),
                         .version = read.text(all, "mahlwerk"),
                         .digest = read.text(all, "digest"),
                         .settings = read.count(all, "settings"),
                         .failed = read.count(all, "failed"),
                         .engines = read.texts(all, "engines")};
  for (const Json& key : read.as_member<Json::Array>(all, "keys"))
    made.keys.push_back(key_of(read, key));
  if (made.keys.empty()) throw read.damaged("`keys` is empty");
  made.following = read.texts(all, "following");
  made.notices = notices_of(read, all);
  for (const Json::Member& q : read.as_member<Json::Object>(all, "quantities"))
    made.quantities.push_back(quantity_of(read, q, made.keys.size()));
  if (made.quantities.empty()) throw read.damaged("`quantities` is empty");
  return made;
}

}  // namespace mahlwerk::campaign
