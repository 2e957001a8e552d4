// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sections/writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/geometry/mesh.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/kinematics/tabulated.hpp"

namespace mahlwerk::cases {
namespace {

/// Replaces control characters, so that a comment stays on one line.
std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return text;
}

}  // namespace

void Writer::section(std::string_view name, std::size_t number) {
  text_ += number > 0 ? fmt::format("\n[[{}]]\n", name) : fmt::format("\n[{}]\n", name);
  prefix_ = number > 0 ? fmt::format("{}.{}.", name, number) : fmt::format("{}.", name);
}

void Writer::line(std::string_view key, std::string_view value) {
  const auto origin = std::ranges::find(c_.origins, prefix_ + std::string(key), &Origin::key);
  const std::string said = fmt::format("{} = {}", key, value);
  if (origin == c_.origins.end() || origin->source.empty()) {
    text_ += said + "\n";
    return;
  }
  text_ += fmt::format("{:<36} # {}{}\n", said, one_line(origin->source),
                       origin->unverified ? " (unverified)" : "");
}

void Writer::plain(std::string_view key, std::string_view value) {
  text_ += fmt::format("{} = {}\n", key, value);
}

void Writer::number(const NumberSpec& spec, double& value) {
  line(spec.key, spec.unit.empty() ? shortest(value) : in_quotes(show(value, spec.unit)));
}

void Writer::text(const TextSpec& spec, std::string& value) {
  if (!value.empty()) line(spec.key, in_quotes(value));
}

bool Writer::choose(const Choice& choice, std::size_t& word_index) {
  if (word_index < choice.words.size()) line(choice.key, in_quotes(choice.words[word_index]));
  return true;
}

std::string write(const Case& c) {
  Writer out(c);
  Case copy = c;  // describe() needs a mutable case; Writer does not change it
  describe(out, copy);
  if (!c.sweep.empty()) write(out, c.sweep);
  if (c.optimise) write(out, *c.optimise);
  if (c.match) write(out, *c.match);
  if (!c.fit.empty()) write(out, c.fit);
  if (c.uncertainty) write(out, *c.uncertainty);
  return out.text();
}

std::string input_files_fingerprint(const Case& c) {
  std::string bytes;
  const auto add = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  if (const auto* mesh = geometry::as<geometry::Mesh>(*c.jar.shape)) {
    for (const Vec3& point : mesh->surface().points) add(point);
    for (const auto& triangle : mesh->surface().triangles) add(triangle);
  }
  if (const auto* measured = kinematics::as<kinematics::Tabulated>(*c.mill.motion))
    for (const kinematics::Sample& sample : measured->samples()) add(sample);
  for (const MachinePart& part : c.machine_parts) {
    if (const auto* mesh = std::get_if<geometry::MeshSolid>(&*part.body.solid)) {
      for (const Vec3& point : mesh->surface().points) add(point);
      for (const auto& triangle : mesh->surface().triangles) add(triangle);
    }
    for (const kinematics::Tabulated* path : {&part.body.motion.path, &part.body.motion.lean})
      for (const kinematics::Sample& sample : path->samples()) add(sample);
  }
  if (c.run.start_from.states)
    for (const auto& state : *c.run.start_from.states)
      for (const BallState& ball : state) {
        add(ball.radius), add(ball.kind);
        add(ball.position), add(ball.velocity), add(ball.spin);
      }
  return fmt::format("# files {:016x}\n", fingerprint(bytes));
}

}  // namespace mahlwerk::cases
