// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Neighbour lists: balls are sorted along a space-filling curve and divided into chunks, and
// contacts move with them. Each chunk builds its Verlet list: the pairs whose gap is within the
// skin.
namespace mahlwerk::soft {
namespace {

/// Sorts pairs into bins of `width` by their gaps.
void bin_by_gap(VerletList& w, const std::vector<NeighbourPair>& found,
                const std::vector<double>& gaps, double width) {
  std::array<std::int32_t, VerletList::bins + 1> count{};
  constexpr double most = VerletList::bins - 1;
  std::vector<std::uint8_t> bins(found.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    bins[k] = static_cast<std::uint8_t>(std::min(std::max(0.0, gaps[k] / width), most));
    ++count[bins[k] + 1U];
  }
  for (std::size_t b = 1; b < count.size(); ++b) count[b] += count[b - 1];
  w.end = count;
  if (w.pairs.capacity() < found.size()) w.pairs = {};  // otherwise its memory would double
  w.pairs.resize(found.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    w.pairs[static_cast<std::size_t>(count[bins[k]]++)] = found[k];
  w.separated.clear();
}

}  // namespace

void ManyBodySolver::rebuild() {
  flush_sums();
  collect_records();
  tune_skin();
  sort_into_chunks();
  std::vector<BallError> errors(chunks_.size());
  team_.run_items(share_, [&](int, std::int32_t c, std::int32_t) {
    Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
    find_ball_pairs(chunk);
    errors[static_cast<std::size_t>(c)] = find_wall_pairs(chunk);
  });
  grids_.clear();
  used_skin_ = 0;
  set_reference_positions();
  for (const BallError& w : errors)
    if (w.why != nullptr) stop(w.row, w.why);
}

/// Stores the positions from which displacements are measured.
void ManyBodySolver::set_reference_positions() {
  largest_coordinate_ = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const BallRecord& row = rows_[k];
    largest_coordinate_ =
        std::max({largest_coordinate_, std::abs(row.x), std::abs(row.y), std::abs(row.z)});
    reference_positions_[k] = {static_cast<float>(row.x), static_cast<float>(row.y),
                               static_cast<float>(row.z)};
  }
  reference_step_ = step_;
  tests_at_rebin_ = test_count();
  displacements_.assign(chunks_.size(), {});
  predicted_means_.assign(chunks_.size(), {});
  for (Chunk& chunk : chunks_) chunk.max_gap_decrease = chunk.max_wall_gap_decrease = 0;
}

std::int64_t ManyBodySolver::test_count() const {
  std::int64_t all = energy_balance_.search_steps;
  for (const Chunk& chunk : chunks_) all += chunk.sums.tests;
  return all;
}

/// Whether the distance tests since the last binning have cost more than another one, after which
/// fewer pairs are due. (The factor 7 was found by trial; 4 to 12 make no difference.)
bool ManyBodySolver::rebin_is_due() const {
  std::int64_t pairs = 0;
  for (const Chunk& c : chunks_)
    pairs += std::ssize(c.ball_pairs.pairs) + std::ssize(c.ball_pairs.separated) +
             std::ssize(c.wall_pairs.pairs);
  return test_count() - tests_at_rebin_ > 7 * pairs;
}

/// Bins the pairs of the Verlet lists by their present gaps.
void ManyBodySolver::rebin_pairs() {
  double most = 0;
  for (const Chunk& c : chunks_)
    most = std::max({most, c.max_gap_decrease, c.max_wall_gap_decrease});
  used_skin_ += most;
  team_.run_items(share_, [&](int, std::int32_t c, std::int32_t) {
    Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
    std::vector<double> gaps;
    for (VerletList* w : {&chunk.ball_pairs, &chunk.wall_pairs}) {
      std::vector<NeighbourPair> pairs = w->pairs;
      pairs.insert(pairs.end(), w->separated.begin(), w->separated.end());
      gaps.resize(pairs.size());
      if (w == &chunk.ball_pairs)
        find_gaps(rows_.data(), pairs, jar_->periods(), gaps);
      else
        std::ranges::transform(pairs, gaps.begin(),
                               [&](const NeighbourPair& p) { return wall_gap(p); });
      bin_by_gap(*w, pairs, gaps, skin_ * VerletList::width);
    }
  });
  for (const Chunk& c : chunks_)
    pairs_rebinned_ += std::ssize(c.ball_pairs.pairs) + std::ssize(c.wall_pairs.pairs);
  set_reference_positions();
}

double ManyBodySolver::wall_gap(const NeighbourPair& pair) const {
  const BallRecord& a = rows_[static_cast<std::size_t>(pair.ball)];
  return jar_->distance(~pair.other, a.position(), wall_axes_, a.radius + 2 * skin_) - a.radius;
}

/// Tunes the skin to the least cost of rebuilds and distance tests. The cost is estimated from
/// counts, not measured, so that every machine chooses the same skin.
void ManyBodySolver::tune_skin() {
  const auto steps = static_cast<double>(step_ - tuning_.step);
  tuning_.step = step_;
  if (steps < 2) return;
  // [ns] distance test of a pair; binning of a pair; search of the neighbours of a ball.
  constexpr double test_cost = 2, rebin_cost = 6, find_cost = 700;
  const auto all = static_cast<double>(energy_balance_.search_steps);
  const double cost =
      (test_cost * (all - tuning_.tests) + rebin_cost * static_cast<double>(pairs_rebinned_) +
       find_cost * static_cast<double>(rows_.size())) /
      steps;
  pairs_rebinned_ = 0;
  if (tuning_.last_cost > 0 && cost > tuning_.last_cost) tuning_.growth = 1 / tuning_.growth;
  tuning_.last_cost = cost;
  tuning_.tests = all;
  double smallest = geometry::never;
  if (settings_.breakage)  // fragments of most sizes come later
    for (const BallRecord& row : rows_) smallest = std::min(smallest, row.radius);
  else
    for (const Species& s : pairs_.all_species()) smallest = std::min(smallest, s.radius);
  skin_ = std::clamp(skin_ * tuning_.growth, 0.1 * smallest, 2 * smallest);
}

/// Collects the candidates for neighbours of a run of balls: those from row `from` on that share a
/// cell. Leaves out earlier balls of the chunk, whose pairs are already found. Returns the end of
/// the run.
std::int32_t ManyBodySolver::gather_candidates(const Chunk& chunk, std::int32_t from,
                                               Candidates& candidates) const {
  const BallRecord& first = rows_[static_cast<std::size_t>(from)];
  const std::size_t size_class = class_of(static_cast<std::size_t>(from));
  const Grid& own = grids_[size_class];
  const auto cell_of = [&](std::int32_t row) {
    return own.cell(grid_position(static_cast<std::size_t>(row)));
  };
  const std::size_t cell = cell_of(from);
  Vec3 low = first.position(), high = low;
  std::int32_t to = from + 1;
  for (; to < chunk.last; ++to) {
    const Vec3 x = rows_[static_cast<std::size_t>(to)].position();
    if (cell_of(to) != cell) break;
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  candidates.clear();
  for (const Grid& grid : grids_) {
    const double far = class_row_radius_[size_class] + grid.radius() + skin_ + pull_off_distance_;
    grid.for_each_near(0.5 * (low + high), 0.5 * (high - low) + Vec3{far, far, far},
                       [&](std::int32_t a, std::int32_t b) {
                         if (a < chunk.first || b > from) candidates.add(rows_.data(), a, b);
                       });
  }
  return to;
}

/// Finds the neighbour pairs of a chunk that are not in contact. A pair of balls in two chunks is
/// found by both chunks.
void ManyBodySolver::find_ball_pairs(Chunk& chunk) {
  std::vector<std::pair<std::int32_t, std::int32_t>> touching;
  for (const ContactPackets* list : {&chunk.own, &chunk.halo})
    for (std::size_t n = 0; n < list->packets.size(); ++n)
      for (std::size_t l = 0; l < lanes; ++l) {
        const ContactPacket& g = list->packets[n];
        if (!g.touches(l)) continue;
        const bool own = list == &chunk.own;
        touching.emplace_back(own ? std::min(g.i[l], g.j[l]) : g.i[l],
                              own ? std::max(g.i[l], g.j[l]) : g.j[l]);
      }
  std::ranges::sort(touching);
  std::vector<NeighbourPair> found;
  std::vector<double> gaps;
  auto at = touching.begin();
  std::vector<bool> is_neighbour(chunks_.size());
  const auto outside = [&](std::int32_t j) { return j < chunk.first || j >= chunk.last; };
  Candidates candidates(jar_->periods());
  for (std::int32_t from = chunk.first, to = from; from < chunk.last; from = to) {
    to = gather_candidates(chunk, from, candidates);
    for (std::int32_t i = from; i < to; ++i) {
      const BallRecord& ball = rows_[static_cast<std::size_t>(i)];
      const auto begin = at;
      while (at != touching.end() && at->first == i) ++at;
      const Candidates::Query query{ball.position(), ball.radius + skin_ + pull_off_distance_, i,
                                    chunk.first};
      for (const auto& [j, gap] : candidates.find_near(query)) {
        if (outside(j)) is_neighbour[static_cast<std::size_t>(chunk_of(j))] = true;
        if (std::find(begin, at, std::pair(i, j)) != at) continue;
        if (is_member(static_cast<std::size_t>(i)) &&
            bodies_.body_of[static_cast<std::size_t>(i)] ==
                bodies_.body_of[static_cast<std::size_t>(j)])
          continue;
        found.push_back({i, j});
        gaps.push_back(gap - ball.radius);
      }
    }
  }
  for (const auto& [i, j] : touching)
    if (outside(j)) is_neighbour[static_cast<std::size_t>(chunk_of(j))] = true;
  chunk.neighbour_chunks.clear();
  for (std::size_t c = 0; c < is_neighbour.size(); ++c)
    if (is_neighbour[c]) chunk.neighbour_chunks.push_back(static_cast<std::int32_t>(c));
  bin_by_gap(chunk.ball_pairs, found, gaps, skin_ * VerletList::width);
}

/// Finds the wall pairs of a chunk that are not in contact. Returns the first ball outside the jar,
/// if any.
ManyBodySolver::BallError ManyBodySolver::find_wall_pairs(Chunk& chunk) {
  std::vector<std::pair<std::int32_t, std::int32_t>> touching;
  for (std::size_t n = 0; n < chunk.wall.packets.size(); ++n)
    for (std::size_t l = 0; l < lanes; ++l)
      if (const ContactPacket& g = chunk.wall.packets[n]; g.touches(l))
        touching.emplace_back(g.i[l], g.j[l]);
  std::ranges::sort(touching);
  std::vector<NeighbourPair> found;
  std::vector<double> gaps, all(static_cast<std::size_t>(jar_->faces()));
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const BallRecord& ball = rows_[static_cast<std::size_t>(i)];
    const BodySpecies* rounded = rounded_species(i);
    const double touching_radius = rounded != nullptr ? rounded->rounding : ball.radius;
    jar_->distances(ball.position(), wall_axes_, ball.radius + skin_ + pull_off_distance_, all);
    for (int face = 0; face < jar_->faces(); ++face) {
      const double gap = all[static_cast<std::size_t>(face)] - ball.radius;
      if (gap > skin_ + pull_off_distance_ || !jar_->can_touch(face, touching_radius)) continue;
      if (!(gap > -ball.radius)) return {static_cast<std::size_t>(i), outside_message};
      if (std::ranges::binary_search(touching, std::pair(i, face))) continue;
      found.push_back({i, ~face});
      gaps.push_back(gap);
    }
  }
  bin_by_gap(chunk.wall_pairs, found, gaps, skin_ * VerletList::width);
  return {};
}

/// Calls `f` with each listed pair of a chunk, its spheres, and its weight: 1/2 where another chunk
/// lists it, too.
template <class F>
void ManyBodySolver::each_overlap(const F& f) const {
  for (const Chunk& chunk : chunks_)
    for (const VerletList* w : {&chunk.ball_pairs, &chunk.wall_pairs})
      for (const NeighbourPair& pair : w->pairs) {
        const bool halo = pair.other >= 0 && (pair.other < chunk.first || pair.other >= chunk.last);
        f(pair, touching_spheres(pair.ball, pair.other), halo ? 0.5 : 1.0);
      }
}

/// Throws InputError if balls overlap by more than the limit: a large overlap would eject them at
/// high speed.
void ManyBodySolver::refuse_overlaps() const {
  each_overlap([&](const NeighbourPair& pair, const TouchingSpheres& touch, double) {
    const auto row = static_cast<std::size_t>(pair.ball),
               other = static_cast<std::size_t>(std::max(pair.other, 0));
    const bool wall = pair.other < 0;
    const double overlap =
        touch.overlap() / (wall ? touch.radius_i : std::min(touch.radius_i, touch.radius_j));
    if (overlap > settings_.max_initial_overlap)
      throw overlap_error(static_cast<std::size_t>(id_[row]),
                          wall ? "the jar" : fmt::format("ball {}", id_[other] + 1), overlap,
                          wall ? "its radius" : "the smaller radius");
  });
}

double ManyBodySolver::energy_at_start() const {
  double energy = 0;
  each_overlap([&](const NeighbourPair& pair, const TouchingSpheres& touch, double weight) {
    const double overlap = touch.overlap();
    if (!(overlap > 0)) return;
    const auto row = static_cast<std::size_t>(pair.ball);
    const bool wall = pair.other < 0;
    const std::int32_t mine = species_[row],
                       of_pair = wall ? pairs_.wall_pair_index(mine, ~pair.other)
                                      : pairs_.ball_pair_index(
                                            mine, species_[static_cast<std::size_t>(pair.other)]);
    PairParameters parameters = parameters_[static_cast<std::size_t>(of_pair)];
    if (wall && settings_.model.curved_walls)
      apply_wall_curvature(parameters, 0, *jar_, ~pair.other, rows_[row].position(), mill_time(0),
                           pairs_[of_pair], settings_.model);
    if (body_species_.has_rounded()) apply_contact_mass(parameters, 0, pair, of_pair);
    energy += weight * soft::energy_at_start(parameters, overlap, *settings_.model.law);
  });
  return energy;
}

}  // namespace mahlwerk::soft
