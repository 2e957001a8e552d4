// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Marks of hits: rings that open and fade at the point of contact. Size and colour say the energy.

import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from "three";

const decades = 3; // of energy below the largest hit; weaker ones have the smallest mark
const seconds = 0.3; // that a mark is seen
const stillFrames = 1.2; // that it is seen while the replay stands: each frame shows the hits since the one before
const [smallest, largest] = [7, 40]; // px, diameters

/// Of the weakest and the strongest hit.
const hitColours = ["#ffb000", "#e8112d"];

/// The colour of a mark, as CSS.
export function hitColour(strength) {
  const [weak, strong] = hitColours.map((colour) => new Color(colour));
  return `#${weak.lerp(strong, strength).getHexString()}`;
}

/// From 0 for a thousandth of the largest energy to 1.
const strengthOf = (energy, top) => Math.min(Math.max(1 + Math.log10(energy / top) / decades, 0), 1);

/// [J] Energies for a legend, each with the diameter [px] and the strength of its mark.
export function legendOf({ hits }) {
  const top = Math.max(...hits.energies);
  return [1e-2, 1e-1, 1].map((part) => {
    const strength = strengthOf(part, 1);
    return { energy: part * top, strength, size: sizeOf(strength) };
  });
}
const sizeOf = (strength) => smallest + (largest - smallest) * strength ** 2;

/// How many frames a mark is seen. `factor`: simulated time over real time.
export function lifeOf(data, { factor, playing }) {
  const interval = (data.times[data.frames - 1] - data.times[0]) / Math.max(data.frames - 1, 1);
  return Math.max((seconds * factor) / interval || 0, playing ? 0.1 : stillFrames);
}

/// The number of marks at a frame.
export function markedAt({ hits }, frame, life) {
  return hits.frames.reduce((sum, at) => sum + (at <= frame && at > frame - life ? 1 : 0), 0);
}

const vertexShader = `
  attribute float at, strength;
  uniform float frame, life, ratio;
  varying float vAge, vStrength, vSize;
  void main() {
    float age = (frame - at) / life;
    bool seen = age >= 0.0 && age < 1.0;
    gl_Position = seen ? projectionMatrix * modelViewMatrix * vec4(position, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
    vSize = ratio * mix(${smallest}.0, ${largest}.0, strength * strength) * mix(0.55, 1.0, sqrt(max(age, 0.0)));
    gl_PointSize = vSize + 2.0;
    vAge = age;
    vStrength = strength;
  }`;

const fragmentShader = `
  uniform vec3 weak, strong;
  uniform float ratio;
  varying float vAge, vStrength, vSize;
  void main() {
    float radius = 0.5 * vSize;
    float far = length((gl_PointCoord - 0.5) * (vSize + 2.0));
    float line = mix(1.0, 3.2, vStrength) * ratio;
    float ring = smoothstep(radius + 0.5, radius - 0.5, far) * smoothstep(radius - line - 0.5, radius - line + 0.5, far);
    float flash = (1.0 - smoothstep(0.0, 0.35, vAge)) * smoothstep(radius, 0.0, far);
    float alpha = max(ring * (1.0 - vAge * vAge), 0.9 * flash);
    if (alpha < 0.01) discard;
    gl_FragColor = vec4(mix(weak, strong, vStrength), alpha);
    #include <colorspace_fragment>
  }`;

/// The marks of all hits, in the jar's own axes. They are drawn over the balls, because a point of contact lies
/// between them.
export class Hits {
  constructor({ hits, positionScale }) {
    const top = Math.max(...hits.energies);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from(hits.places, (p) => p * positionScale), 3));
    geometry.setAttribute("at", new BufferAttribute(hits.frames, 1));
    geometry.setAttribute("strength",
      new BufferAttribute(hits.energies.map((energy) => strengthOf(energy, top)), 1));
    this.uniforms = { frame: { value: 0 }, life: { value: 1 }, ratio: { value: 1 },
      weak: { value: new Color(hitColours[0]) }, strong: { value: new Color(hitColours[1]) } };
    this.points = new Points(geometry, new ShaderMaterial({ uniforms: this.uniforms, vertexShader, fragmentShader,
      transparent: true, depthTest: false, depthWrite: false }));
    this.points.frustumCulled = false;
    this.points.renderOrder = 4;
  }

  /// `life`: frames that a mark is seen, or null: none. `ratio`: device pixels of a CSS pixel.
  show(frame, life, ratio) {
    this.points.visible = life !== null;
    this.uniforms.frame.value = frame;
    this.uniforms.life.value = life ?? 1;
    this.uniforms.ratio.value = ratio;
  }
}
