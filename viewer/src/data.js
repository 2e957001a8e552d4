// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The data of the replay as typed arrays, checked against the format in viewer/README.md. Typed
// arrays have the byte order of the machine. The format is little endian, as are all machines with
// browsers.

import { en } from "./text/en.js";

/// An error about the data; `kind` and `values` say it in any language (faultIn).
const fault = (kind, ...values) => Object.assign(new Error(faultIn(en, { kind, values })), { kind, values });

/// What an error says, in the words `text`.
export const faultIn = (text, { kind, values, message }) =>
  kind ? text.dataFault(text.dataFaults[kind](...values)) : message;

function decoded(Kind, text, length, name) {
  if (typeof text !== "string") throw fault("missing", name);
  let raw;
  try {
    raw = atob(text);
  } catch {
    throw fault("notBase64", name);
  }
  const expected = length * Kind.BYTES_PER_ELEMENT;
  if (raw.length !== expected)
    throw fault("length", name, raw.length, expected);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return new Kind(bytes.buffer);
}

/// All elements of the text. Their number must be a multiple of `group`.
function decodedGroups(Kind, text, group, name) {
  if (typeof text !== "string") throw fault("missing", name);
  const bytes = (text.length / 4) * 3 - (text.match(/=*$/)[0].length);
  const size = group * Kind.BYTES_PER_ELEMENT;
  if (!(bytes > 0) || bytes % size !== 0)
    throw fault("multiple", name, bytes, size);
  return decoded(Kind, text, bytes / Kind.BYTES_PER_ELEMENT, name);
}

function positive(value, name) {
  if (!(Number.isFinite(value) && value > 0))
    throw fault("notPositive", name, value);
  return value;
}

function readMesh(mesh, frames, i) {
  const at = `meshes[${i}]`;
  const vertices = decodedGroups(Float32Array, mesh.vertices, 3, `${at}.vertices`);
  const triangles = decodedGroups(Uint32Array, mesh.triangles, 3, `${at}.triangles`);
  if (triangles.some((v) => 3 * v >= vertices.length))
    throw fault("corners", at);
  const turn =
    mesh.turn == null ? null : decoded(Float32Array, mesh.turn, 4 * frames, `${at}.turn`);
  const shift =
    mesh.shift == null ? null : decoded(Float32Array, mesh.shift, 3 * frames, `${at}.shift`);
  return { name: String(mesh.name ?? ""), vertices, triangles, turn, shift };
}

/// Bodies of one kind, drawn by their surface in place of their spheres.
function readBody(body, spheres, i) {
  const at = `bodies[${i}]`;
  const places = decodedGroups(Float32Array, body.places, 3, `${at}.places`);
  const vertices = decodedGroups(Float32Array, body.vertices, 3, `${at}.vertices`);
  const normals = decoded(Float32Array, body.normals, vertices.length, `${at}.normals`);
  const triangles = decodedGroups(Uint32Array, body.triangles, 3, `${at}.triangles`);
  if (triangles.some((v) => 3 * v >= vertices.length))
    throw fault("corners", at);
  const { first, count } = body;
  const each = places.length / 3;
  if (!Number.isInteger(first) || !Number.isInteger(count) || first < 0 || count < 1 ||
      first + count * each > spheres)
    throw fault("bodies", at, count, first, spheres);
  return { first, count, each, places, vertices, normals, triangles,
    radius: positive(body.radius, `${at}.radius`) };
}

/// Masses of the balls [kg] from the densities of their kinds, or null if one is not known.
function massesOf(densities, radius, species) {
  if (!Array.isArray(densities)) return null;
  const masses = radius.map((r, i) => (4 / 3) * Math.PI * r ** 3 * (densities[species[i]] ?? Number.NaN));
  return masses.every((mass) => mass > 0) ? masses : null;
}

/// The strongest hits, or null.
function readHits(hits, balls) {
  if (!hits) return null;
  const H = hits.count;
  if (!Number.isInteger(H) || H < 0) throw fault("count", H);
  const array = (Kind, name, length) => decoded(Kind, hits[name], length, `hits.${name}`);
  return { count: H, frames: array(Float32Array, "frames", H), places: array(Int16Array, "places", 3 * H),
    energies: array(Float32Array, "energies", H), balls: array(Uint16Array, "balls", 2 * H),
    ofBalls: hits.of_balls == null ? null : array(Uint32Array, "of_balls", balls) };
}

function readTimes(times) {
  if (!Array.isArray(times) || times.length === 0) throw fault("noTimes");
  if (times.some((t, f) => !Number.isFinite(t) || (f > 0 && t <= times[f - 1])))
    throw fault("times");
  return times;
}

/// Whether the ball whose position begins at `at` is in the jar: others have the lowest number.
export const isInJar = (positions, at) => positions[at] !== -32768;

/// Reads the JSON text `text`. Lengths in m, times in s, speeds in m/s. Throws an Error with a
/// message for the reader if the text violates the format.
export function read(text) {
  let json;
  try {
    json = JSON.parse(text);
  } catch (error) {
    throw fault("notJson", error.message);
  }
  return readObject(json);
}

/// The same for JSON that is already parsed.
export function readObject(json) {
  if (json.version !== 1)
    throw fault("version", json.version);
  const times = readTimes(json.times);
  const F = times.length;
  const N = json.count;
  if (!Number.isInteger(N) || N < 0) throw fault("count", N);
  if (!Array.isArray(json.meshes)) throw fault("missing", "meshes");
  const array = (Kind, name, length) => decoded(Kind, json[name], length, name);
  const [radius, species] = [array(Float32Array, "radius", N), array(Uint8Array, "species", N)];
  return {
    title: String(json.title ?? ""),
    times,
    frames: F,
    count: N,
    of: json.of ?? N,
    radius,
    species,
    masses: massesOf(json.densities, radius, species),
    speciesNames: json.species_names ?? [],
    positionScale: positive(json.position_scale, "position_scale"),
    positions: array(Int16Array, "positions", 3 * F * N),
    speedScale: positive(json.speed_scale, "speed_scale"),
    speeds: array(Uint16Array, "speeds", F * N),
    spinScale: json.spins == null ? 0 : positive(json.spin_scale, "spin_scale"),
    spins: json.spins == null ? null : array(Uint16Array, "spins", F * N),
    hits: readHits(json.hits, N),
    jarCentre: array(Float32Array, "jar_centre", 3 * F),
    jarTurn: array(Float32Array, "jar_turn", 4 * F),
    carrierTurn: array(Float32Array, "carrier_turn", 4 * F),
    carrier: json.carrier ?? null,
    bodies: (json.bodies ?? []).map((body, i) => readBody(body, N, i)),
    meshes: json.meshes.map((mesh, i) => readMesh(mesh, F, i)),
  };
}
