// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sections/vector_key.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/cases/sections/fields.hpp"

namespace mahlwerk::cases {
namespace {

std::string text_of(const VectorKey& key, const Vec3& a) {
  if (key.component.unit.empty())
    return fmt::format("[{}, {}, {}]", shortest(a.x), shortest(a.y), shortest(a.z));
  const auto one = [&](double x) { return in_quotes(show(x, key.component.unit)); };
  return fmt::format("[{}, {}, {}]", one(a.x), one(a.y), one(a.z));
}

void read(SectionReader& in, const VectorKey& key, Vec3& value) {
  value = key.standard;
  const Node* at = in.find(key.component.key);
  if (at == nullptr && key.required)
    return in.missing(
        key.component.key, key.component.about,
        fmt::format("write x, y, z, for instance {} = [\"0 mm\", \"0 mm\", \"10 mm\"]",
                    key.component.key));
  if (at == nullptr) return in.record_default(key.component.key, text_of(key, value), key.source);
  std::array<double, 3> x{};
  const bool three = at->kind == Node::Kind::list && at->items.size() == x.size();
  for (std::size_t i = 0; three && i < x.size(); ++i)
    x[i] = in.quantity(at->items[i], key.component);
  const Vec3 given{x[0], x[1], x[2]};
  const double length = norm(given);
  if (std::isnan(length)) return;  // already reported
  if (!three || (key.direction && !(length > 0 && std::isfinite(length))))
    return in.fault(*at,
                    fmt::format("`{}` must be a list of three numbers{}", key.component.key,
                                key.direction ? ", not all 0" : ""),
                    fmt::format("write x, y, z, for instance {} = {}", key.component.key,
                                key.direction ? "[0, 0, 1]" : "[\"0 mm\", \"0 mm\", \"10 mm\"]"),
                    "wrong-type");
  constexpr double rounding = 1e-12;  // a written direction keeps its bits
  value = key.direction && !(std::abs(length - 1) < rounding) ? given / length : given;
  in.record_origin(key.component.key, text_of(key, value), at);
}

}  // namespace

void describe(KeyVisitor& v, const VectorKey& key, Vec3& value) {
  if (SectionReader* in = v.reader()) return read(*in, key, value);
  const bool sound = key.direction ? std::abs(norm(value) - 1) < 1e-9 : std::isfinite(norm(value));
  v.custom({.key = key.component.key,
            .about = key.component.about,
            .sound = sound,
            .required = key.required,
            .default_text = key.source},
           [&] { return text_of(key, value); });
}

}  // namespace mahlwerk::cases
