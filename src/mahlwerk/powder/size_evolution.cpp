// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/size_evolution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mahlwerk/powder/population_balance.hpp"
#include "mahlwerk/powder/sample.hpp"

namespace mahlwerk::powder {
namespace {

constexpr int doublings = 12, steps = 16;  // of the output times, and within each doubling

}  // namespace

std::vector<double> output_times(double time) {
  std::vector<double> times{0};
  const double first = std::ldexp(time, -doublings);
  for (int i = 1; i <= steps; ++i) times.push_back(first * i / steps);
  for (int k = 0; k < doublings; ++k)
    for (int i = 1; i <= steps; ++i)
      times.push_back(std::ldexp(first, k) * (1 + static_cast<double>(i) / steps));
  return times;
}

SizeEvolution grind_by_balance(const Process& process, const StressSpectrum& stresses,
                               const SizeGrid& grid, const Feed& feed, double time,
                               const CaptureTable* known) {
  SizeEvolution evolution{grid, output_times(time), {}};
  PopulationBalance balance(process, stresses, grid, grid.shares(feed), known);
  // All steps are the first step times a power of two, so that the transition matrix of each
  // doubling is the square of the previous one.
  const double first = std::ldexp(time, -doublings) / steps;
  evolution.shares.push_back(balance.shares());
  for (int k = -1; k < doublings; ++k)
    for (int i = 0; i < steps; ++i) {
      balance.advance(std::ldexp(first, std::max(k, 0)));
      evolution.shares.push_back(balance.shares());
    }
  return evolution;
}

std::vector<double> SizeEvolution::at(double when) const {
  const auto next = std::ranges::upper_bound(time, when);
  if (next == time.begin()) return shares.front();
  if (next == time.end()) return shares.back();
  const auto i = static_cast<std::size_t>(next - time.begin());
  const double part = (when - time[i - 1]) / (time[i] - time[i - 1]);
  std::vector<double> found;
  for (std::size_t c = 0; c < shares[i].size(); ++c)
    found.push_back(std::lerp(shares[i - 1][c], shares[i][c], part));
  return found;
}

SizeEvolution grind_sample(const Process& process, const std::vector<Nip>& nips,
                           const Stream& stream, const SizeGrid& grid, const Feed& feed,
                           double time, int grains, std::uint64_t start) {
  SizeEvolution evolution{grid, output_times(time), {}};
  Sample sample(process, nips, grid, feed, grains, start);
  struct Event {
    double time, energy;
    int kind;
  };
  std::vector<Event> events;  // events of one span that have an effect
  for (std::size_t i = 0; i < stream.hits.size(); ++i) {
    const StreamHit& h = stream.hits[i];
    const double when =
        stream.span * (static_cast<double>(i) + 0.5) / static_cast<double>(stream.hits.size());
    if (const int kind = sample.kind(h.nip, h.energy); sample.has_effect(kind))
      events.push_back({when, h.energy, kind});
  }
  constexpr double most = 1e7;
  const double wanted = static_cast<double>(events.size()) * time / stream.span;
  auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(wanted / most)));
  while (!events.empty() && std::gcd(stride, events.size()) != 1)
    ++stride;  // coprime: every event is applied in turn
  evolution.shares.push_back(sample.shares());
  std::size_t recorded = 1, at = 0;
  double began = 0;  // [s] start of the current repetition of the stream
  while (recorded < evolution.time.size()) {
    const bool over = events.empty() || sample.finished();
    const double when = over ? time * 2 : began + events[at].time;
    while (recorded < evolution.time.size() && evolution.time[recorded] <= when) {
      evolution.shares.push_back(sample.shares());
      ++recorded;
    }
    if (over) continue;
    sample.hit(events[at].kind, events[at].energy, stream.weight * static_cast<double>(stride));
    for (at += stride; at >= events.size(); at -= events.size()) began += stream.span;
  }
  return evolution;
}

}  // namespace mahlwerk::powder
