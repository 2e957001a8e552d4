// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/many/body_step.hpp"

#include "mahlwerk/soft/kernel/force_rows.hpp"
#include "mahlwerk/soft/kernel/rigid_body.hpp"

namespace mahlwerk::soft {
namespace {

/// a x b of the first three numbers, where the fourth of b is 0.
[[gnu::always_inline]] inline Register<4> cross(const Register<4>& a, const Register<4>& b) {
  const auto turned = [](const Register<4>& v) __attribute__((always_inline)) {
    return __builtin_shufflevector(v, v, 1, 2, 0, 3);
  };
  return turned(a * turned(b) - turned(a) * b);
}

/// Force [N] and torque [N m] about the centre of mass of a body: the sum over its rows (bod.11).
/// In registers throughout: a register that is read after its parts were written stalls.
template <class V>
[[gnu::always_inline]] inline void load_on(const BodyRecord& body, std::size_t count,
                                           const BallRecord* rows, const VectorPair* on_rows,
                                           V (&sum)[8 / width_of<V>]) {
  if constexpr (width_of<V> == 2) {
    Vec3 force, torque;
    for (std::size_t k = 0; k < count; ++k) {
      const VectorPair& f = on_rows[k];
      const Vec3 on_row = first_vector(f);
      force += on_row;
      torque += second_vector(f) + mahlwerk::cross(rows[k].position() - body.centre, on_row);
    }
    sum[0] = V{force.x, force.y}, sum[1] = V{force.z, 0};
    sum[2] = V{torque.x, torque.y}, sum[3] = V{torque.z, 0};
  } else {
    using Four = Register<4>;
    const Four centre = load_part<Four>(body);
    Four force{}, torque{};
    for (std::size_t k = 0; k < count; ++k) {
      const Four on_row = load_part<Four>(on_rows[k]);
      force += on_row;
      torque += load_part<Four>(on_rows[k], 4) + cross(load_part<Four>(rows[k]) - centre, on_row);
    }
    if constexpr (width_of<V> == 8)
      sum[0] = __builtin_shufflevector(force, torque, 0, 1, 2, 3, 4, 5, 6, 7);
    else
      sum[0] = force, sum[1] = torque;
  }
}

/// Kicks of gravity and of the accelerated frame for all bodies: half a step back and forth, and
/// half a step on.
struct BodyKicks {
  VectorPair before, after;
  explicit BodyKicks(const ChunkStep& s) {
    const Vec3 b = s.constants.dt * s.drive.body_acceleration,
               a = 0.5 * s.constants.dt * s.next_drive.body_acceleration;
    before = {b.x, b.y, b.z}, after = {a.x, a.y, a.z};
  }
};

/// Kicks a body by the forces on its rows (bod.8).
template <class V>
[[gnu::always_inline]] inline void kick_body(const BodyStep& b, std::size_t body,
                                             const BodyKicks& kicks) {
  const BodyRows& at = b.bodies.rows[body];
  const auto species = static_cast<std::size_t>(at.species);
  const std::int32_t first = b.bodies.rows[b.first].first;
  V load[8 / width_of<V>];
  load_on<V>(b.bodies.now[body], b.species[at.species].offsets.size(), b.step.rows + at.first,
             b.forces + (at.first - first), load);
  BodyMotion& m = b.bodies.motion[body];
  unrolled<8 / width_of<V>>([&](std::size_t n) __attribute__((always_inline)) {
    const std::size_t part = n * width_of<V>;
    const V half_kick = load_part<V>(b.factors[species].half_kick, part) * load[n];
    const V half =
        load_part<V>(m.half_step, part) + (2.0 * half_kick + load_part<V>(kicks.before, part));
    store_part<V>(m.half_step, part, half);
    store_part<V>(m.predicted, part, half + half_kick + load_part<V>(kicks.after, part));
  });
}

template <class V>
[[gnu::always_inline]] inline Vec<V> vector_of(const V (&columns)[4]) {
  return {columns[0], columns[1], columns[2]};
}

/// Bodies at the next step, one for each lane: what their rows are made of.
struct NextBodies {
  alignas(64) double centre[lanes][8];   ///< position and predicted velocity of the centre
  alignas(64) double axes[3][lanes][8];  ///< images of the principal axes, and their rates
  alignas(64) double spin[lanes][8];     ///< predicted spin [rad/s]
};

/// Moves and turns the bodies from `block` on, one for each lane; lanes beyond the last body
/// repeat it.
template <class V>
[[gnu::always_inline]] inline void turn_bodies(const BodyStep& b, std::size_t block, int first,
                                               NextBodies& next) {
  const auto body = [&](std::size_t l) __attribute__((always_inline)) {
    return std::min(block + static_cast<std::size_t>(first) + l, b.last - 1);
  };
  const auto now = [&](std::size_t l) -> const BodyRecord& { return b.bodies.now[body(l)]; };
  const auto half = [&](std::size_t l) -> const VectorPair& {
    return b.bodies.motion[body(l)].half_step;
  };
  const auto ahead = [&](std::size_t l) -> const VectorPair& {
    return b.bodies.motion[body(l)].predicted;
  };
  const auto inverse = [&](std::size_t l) -> const VectorPair& {
    return b.factors[static_cast<std::size_t>(b.bodies.rows[body(l)].species)].inverse_inertia;
  };
  V centre[4], q[4], velocity[4], momentum[4], factors[4], velocity_ahead[4], momentum_ahead[4];
  load_columns<V>(now, 0, centre), load_columns<V>(now, 4, q);
  load_columns<V>(half, 0, velocity), load_columns<V>(half, 4, momentum);
  load_columns<V>(ahead, 0, velocity_ahead), load_columns<V>(ahead, 4, momentum_ahead);
  load_columns<V>(inverse, 0, factors);
  const double dt = b.step.constants.dt;
  const Vec<V> to = vector_of<V>(centre) + dt * vector_of<V>(velocity);
  const OrientationOf<V> turned = turned_freely<V>({q[0], q[1], q[2], q[3]}, vector_of<V>(momentum),
                                                   dt * vector_of<V>(factors));
  Vec<V> ex, ey, ez;
  axes_of(turned, ex, ey, ez);
  const Vec<V> along = vector_of<V>(momentum_ahead);
  const Vec<V> spin = factors[0] * dot(ex, along) * ex + factors[1] * dot(ey, along) * ey +
                      factors[2] * dot(ez, along) * ez;
  const ForceRows<V> centres(to, vector_of<V>(velocity_ahead)), x(ex, cross(spin, ex)),
      y(ey, cross(spin, ey)), z(ez, cross(spin, ez)), spins(spin, Vec<V>{});
  for (std::size_t l = 0; l < width_of<V>; ++l) {
    const std::size_t lane = static_cast<std::size_t>(first) + l;
    centres.put(l, next.centre[lane]), spins.put(l, next.spin[lane]);
    x.put(l, next.axes[0][lane]), y.put(l, next.axes[1][lane]), z.put(l, next.axes[2][lane]);
    if (block + lane >= b.last) continue;
    b.bodies.next[block + lane] = {{to.x[l], to.y[l], to.z[l]},
                                   {turned.w[l], turned.x[l], turned.y[l], turned.z[l]}};
  }
}

/// The first four numbers of a row that is in registers.
template <class V>
using Quarter = Register<std::min(width_of<V>, 4)>;
template <class V>
[[gnu::always_inline]] inline Quarter<V> position_part(const V (&row)[8 / width_of<V>],
                                                       std::size_t p) {
  if constexpr (width_of<V> == 8)
    return __builtin_shufflevector(row[0], row[0], 0, 1, 2, 3);
  else
    return row[p];
}

/// Displacements of the rows of a chunk, as integrate_balls() finds them (dem.34).
template <class V>
class DisplacementSum {
 public:
  explicit DisplacementSum(const Vec3& predicted_mean)
      : mean_{predicted_mean.x, predicted_mean.y, predicted_mean.z, 0} {}
  [[gnu::always_inline]] void add(const V (&row)[8 / width_of<V>], const FloatPosition& reference) {
    unrolled<parts>([&](std::size_t p) __attribute__((always_inline)) {
      const Part way = position_part<V>(row, p) - reference_part<Part>(reference, p * width);
      const Part off = way - load<Part>(mean_ + p * width);
      sum_[p] += way;
      most_[p] = max(most_[p], max(off, -off));
    });
  }
  void put(std::int32_t rows, ChunkDisplacement& out) const {
    const auto number = [](const Part(&a)[parts], std::size_t k) {
      return a[k / width][k % width];
    };
    out.spread = norm(Vec3{number(most_, 0), number(most_, 1), number(most_, 2)});
    out.mean = Vec3{number(sum_, 0), number(sum_, 1), number(sum_, 2)} / rows;
  }

 private:
  using Part = Quarter<V>;
  static constexpr std::size_t width = width_of<Part>, parts = 4 / width;
  alignas(64) double mean_[4];
  Part sum_[parts]{}, most_[parts]{};
};

/// Writes the rows of a body's spheres (bod.7). The velocity of a sphere is linear in its offset,
/// as its position is.
template <class V>
[[gnu::always_inline]] inline void write_rows(const BodyStep& b, std::size_t body,
                                              const NextBodies& next, std::size_t lane,
                                              DisplacementSum<V>& displacements) {
  constexpr std::size_t parts = 8 / width_of<V>, width = width_of<V>;
  V centre[parts], x[parts], y[parts], z[parts];
  unrolled<parts>([&](std::size_t p) __attribute__((always_inline)) {
    centre[p] = load<V>(next.centre[lane] + p * width);
    x[p] = load<V>(next.axes[0][lane] + p * width), y[p] = load<V>(next.axes[1][lane] + p * width);
    z[p] = load<V>(next.axes[2][lane] + p * width);
  });
  const BodyRows& at = b.bodies.rows[body];
  const BodySpecies& of = b.species[at.species];
  BallRecord* rows = b.step.next_rows + at.first;
  SpinRecord* spins = b.step.next_spins + at.first;
  const SpinRecord spin{next.spin[lane][0], next.spin[lane][1], next.spin[lane][2]};
  for (std::size_t k = 0; k < of.offsets.size(); ++k) {
    const Vec3& o = of.offsets[k];
    V row[parts];
    unrolled<parts>([&](std::size_t p) __attribute__((always_inline)) {
      row[p] = centre[p] + o.x * x[p] + o.y * y[p] + o.z * z[p];
      store_part<V>(rows[k], p * width, row[p]);
    });
    rows[k].radius = of.radii[k];
    spins[k] = spin;
    displacements.add(row, b.step.reference_positions[at.first + static_cast<std::int32_t>(k)]);
  }
}

struct BodyLoop {
  template <int width>
  [[gnu::always_inline]] static void run(const BodyStep& b, ChunkDisplacement& displacement) {
    using V = Register<width>;
    const BodyKicks kicks(b.step);
    DisplacementSum<V> displacements(displacement.predicted_mean);
    std::int32_t rows = 0;
    NextBodies next;
    for (std::size_t block = b.first; block < b.last; block += lanes) {
      const std::size_t count = std::min<std::size_t>(lanes, b.last - block);
      for (std::size_t l = 0; l < count; ++l) kick_body<V>(b, block + l, kicks);
      for (int first = 0; first < static_cast<int>(count); first += width)
        turn_bodies<V>(b, block, first, next);
      for (std::size_t l = 0; l < count; ++l) {
        write_rows<V>(b, block + l, next, l, displacements);
        rows +=
            static_cast<std::int32_t>(b.species[b.bodies.rows[block + l].species].offsets.size());
      }
    }
    displacements.put(rows, displacement);
  }
};

}  // namespace

std::vector<BodyFactors> body_factors(const BodySpeciesTable& species, double time_step) {
  std::vector<BodyFactors> all;
  const double half = 0.5 * time_step;
  for (const BodySpecies& of : species.all()) {
    const double kick = half / of.mass;
    all.push_back(
        {{kick, kick, kick, 0, half, half, half, 0}, vector_pair(of.inverse_inertia, {})});
  }
  return all;
}

BodyStepper body_stepper() {
  return Multiversioned<BodyLoop, BodyStepper>::best();
}

}  // namespace mahlwerk::soft
