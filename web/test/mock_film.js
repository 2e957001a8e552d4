// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Invented frames of a replay: balls that circle in a cylinder, which is shaken or carried by a disc.

function base64(array) {
  const bytes = new Uint8Array(array.buffer);
  let raw = "";
  for (const byte of bytes) raw += String.fromCharCode(byte);
  return btoa(raw);
}

function cylinder(radius, half) {
  const count = 48;
  const [vertices, triangles] = [[], []];
  for (let i = 0; i < count; ++i)
    for (const z of [-half, half])
      vertices.push(radius * Math.cos((2 * Math.PI * i) / count),
        radius * Math.sin((2 * Math.PI * i) / count), z);
  vertices.push(0, 0, -half, 0, 0, half);
  for (let i = 0; i < count; ++i) {
    const [a, b] = [2 * i, 2 * ((i + 1) % count)];
    triangles.push(a, b, a + 1, b, b + 1, a + 1, a, 2 * count, b, a + 1, b + 1, 2 * count + 1);
  }
  return { name: "jar", vertices: base64(new Float32Array(vertices)),
    triangles: base64(new Uint32Array(triangles)), turn: null };
}

/// A hit at the wall between each two frames, of the balls in turn.
function hitsOf(frames, N, reach, scale) {
  const count = Math.max(frames - 1, 0);
  const each = Array.from({ length: count }, (_, f) => f);
  const ofBalls = new Uint32Array(N);
  for (const f of each) ++ofBalls[f % N];
  return { count, frames: base64(new Float32Array(each.map((f) => f + 0.5))),
    places: base64(new Int16Array(each.flatMap((f) =>
      [reach * Math.cos(2.4 * f) / scale, reach * Math.sin(2.4 * f) / scale, 0]))),
    energies: base64(new Float32Array(each.map((f) => 1e-3 * 10 ** -(f % 4)))),
    balls: base64(new Uint16Array(each.flatMap((f) => [f % N, 65535]))), of_balls: base64(ofBalls) };
}

export function filmOf({ title, counts, radii, planetary, drive }, frames, last) {
  const N = Math.min(counts.reduce((a, b) => a + b, 0), 500);
  const species = counts.flatMap((count, set) => new Array(count).fill(set)).slice(0, N);
  const ball = Math.max(...radii);
  const reach = ball * (2 + 1.2 * Math.cbrt(N));
  const scale = reach / 32000;
  const positions = new Int16Array(3 * frames * N);
  const speeds = new Uint16Array(frames * N);
  const spins = new Uint16Array(frames * N);
  const centre = new Float32Array(3 * frames);
  const turn = new Float32Array(4 * frames);
  for (let f = 0; f < frames; ++f) {
    const phase = f * 0.2;
    for (let i = 0; i < N; ++i) {
      const far = (reach - radii[species[i]]) * Math.sqrt((i + 0.7) / (N + 1)) / scale;
      const angle = 2.4 * i + phase * (1 + 0.3 * (i % 3));
      positions.set([far * Math.cos(angle), far * Math.sin(angle),
        (0.6 * reach * Math.sin(i + 0.7 * phase)) / scale], 3 * (f * N + i));
      speeds[f * N + i] = 20000 + 20000 * Math.sin(angle);
      spins[f * N + i] = 30000 + 30000 * Math.cos(angle);
    }
    const disc = phase * 0.5;
    centre.set(planetary ? [3 * reach * Math.cos(disc), 3 * reach * Math.sin(disc), 0]
      : [0, 0, reach * Math.sin(phase)], 3 * f);
    const half = planetary ? disc / 2 : 0;
    turn.set([0, 0, Math.sin(half), Math.cos(half)], 4 * f);
  }
  const still = new Float32Array(4 * frames).map((_, i) => (i % 4 === 3 ? 1 : 0));
  return { version: 1, title, times: Array.from({ length: frames }, (_, f) =>
    (frames > 1 ? (Math.max(last, 1e-3) * f) / (frames - 1) : 0)), count: N, of: N,
  radius: base64(new Float32Array(species.map((set) => radii[set]))),
  species: base64(new Uint8Array(species)), species_names: counts.map((_, i) => `balls.${i + 1}`),
  position_scale: scale, positions: base64(positions), speed_scale: (1e-5 * drive) / 10,
  speeds: base64(speeds), spin_scale: (1e-3 * drive) / 10, spins: base64(spins), densities: counts.map(() => 7850),
  hits: hitsOf(frames, N, reach, scale), jar_centre: base64(centre), jar_turn: base64(turn),
  carrier_turn: base64(planetary ? turn : still), carrier: planetary ? "disc" : null,
  meshes: [cylinder(reach * 1.05, reach)] };
}
