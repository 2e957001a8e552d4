// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Draws docs/images/one-ball.svg, the picture of the README: ninja -C build/release one_ball_picture, then
// build/release/bin/one_ball_picture > docs/images/one-ball.svg
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mahlwerk/event/engine.hpp"

using namespace mahlwerk;

namespace {

struct Seen final : scene::Observer {
  std::vector<scene::Collision> all;
  void collisions(std::span<const scene::Collision> finished) override {
    all.insert(all.end(), finished.begin(), finished.end());
  }
};

constexpr double scale = 9000, centre_x = 205, centre_y = 265;  // pixels a metre, of the vial's centre

std::string at(double x, double z) {
  return fmt::format("{:.1f},{:.1f}", centre_x + scale * x, centre_y - scale * z);
}

void text(double x, double y, const std::string& words, double size = 14, const char* fill = "#444") {
  fmt::print("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n", x, y, size, fill, words);
}

/// Bars of how often each energy occurs, two bars an octave.
void spectrum(const std::vector<scene::Collision>& all) {
  constexpr double left = 420, bottom = 430, width = 340, height = 260, least = 1e-5, octaves = 11;
  std::vector<double> bars(22, 0);
  for (const auto& c : all) {
    const double place = 2 * std::log2(c.energy_contact_point() / least);
    if (place >= 0 && place < 22) ++bars[static_cast<std::size_t>(place)];
  }
  const double most = *std::max_element(bars.begin(), bars.end());
  for (std::size_t i = 0; i < bars.size(); ++i)
    fmt::print("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#0b7285\"/>\n",
               left + width * static_cast<double>(i) / 22 + 1, bottom - height * bars[i] / most,
               width / 22 - 2, height * bars[i] / most);
  fmt::print("<path d=\"M{} {}h{}\" stroke=\"#444\"/>\n", left, bottom, width);
  for (const auto& [energy, label] : {std::pair{1e-5, "0.01"}, {1e-4, "0.1"}, {1e-3, "1"}, {1e-2, "10 mJ"}})
    text(left + width * std::log2(energy / least) / octaves - 8, bottom + 20, label, 13);
  text(left, bottom - height - 50, "How hard it hits", 18, "#111");
  text(left, bottom - height - 28, "collisions by energy at the contact point");
  text(left, bottom + 42, "one minute at 10 Hz, 25 mm");
}

}  // namespace

int main() {
  const double pi = 3.141592653589793, diameter = 0.012, radius = 0.004;
  const double height = (5e-6 - pi * std::pow(diameter, 3) / 6) / (pi * diameter * diameter / 4);
  kinematics::Vibration motion;
  motion.frequency = 10;
  motion.amplitude = 0.025;
  const scene::Chamber mill{geometry::Capsule{diameter, height}, motion, {}, {0, 0, -9.81}};
  event::Rules rules;
  rules.bounce = {0.9, 0.9, INFINITY};
  rules.rolling_friction = 0.01;
  const auto engine =
      event::one_ball(mill, {radius, 7850, {0.0005, 0, 0.002}, {0.08, 0.01, 0.05}, {}}, rules);
  Seen seen;
  constexpr double shown = 0.3;
  std::string path;
  for (double t = 0; t < shown; t += 2e-4) {
    engine->advance(t, seen);
    const Vec3 p = engine->balls().front().position;
    path += (path.empty() ? "M" : "L") + at(p.x, p.z);
  }
  fmt::print("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 780 520\" "
             "font-family=\"system-ui,Segoe UI,Helvetica,Arial,sans-serif\">\n"
             "<title>A ball in a vibrating vial: its way and its collisions</title>\n"
             "<rect width=\"780\" height=\"520\" fill=\"#fff\"/>\n");
  const double r = 0.5 * diameter, h = 0.5 * height;
  fmt::print("<path d=\"M{} L{} A{} {} 0 0 1 {} L{} A{} {} 0 0 1 {} Z\" fill=\"#f1f3f5\" stroke=\"#495057\" "
             "stroke-width=\"3\"/>\n",
             at(-r, -h), at(-r, h), scale * r, scale * r, at(r, h), at(r, -h), scale * r, scale * r, at(-r, -h));
  fmt::print("<path d=\"{}\" fill=\"none\" stroke=\"#0b7285\" stroke-opacity=\".55\" stroke-width=\"1.2\"/>\n", path);
  for (const auto& c : seen.all)
    fmt::print("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"#d9480f\" fill-opacity=\".65\"/>\n",
               centre_x + scale * c.where.x, centre_y - scale * c.where.z,
               1.5 + 110 * std::sqrt(c.energy_contact_point()));
  const Vec3 p = engine->balls().front().position;
  fmt::print("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"#adb5bd\" stroke=\"#495057\" "
             "stroke-width=\"1.5\" fill-opacity=\".8\"/>\n",
             centre_x + scale * p.x, centre_y - scale * p.z, scale * radius);
  fmt::print("<path d=\"M50 200v130m-7 -11l7 11l7 -11m-14 -108l7 -11l7 11\" fill=\"none\" stroke=\"#495057\" "
             "stroke-width=\"2\"/>\n");
  text(12, 180, "10 Hz, ±25 mm");
  text(285, 90, "the ball's way", 14, "#0b7285");
  text(285, 110, "in the vial, 0.3 s", 14, "#0b7285");
  text(285, 140, "its collisions,", 14, "#d9480f");
  text(285, 160, "larger: harder", 14, "#d9480f");
  engine->advance(60, seen);
  spectrum(seen.all);
  fmt::print("</svg>\n");
}
