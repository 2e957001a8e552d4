// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The carrier (disc) of a planetary mill, drawn as a plate below the jar: its rim, the path of the
// jar's centre, and spokes that show the rotation. The axis of the plate is its z axis through the
// origin of the laboratory.

import { CircleGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";
import { lines } from "./jar.js";

/// Radius and height of the plate [m], from the position and the size of the jar.
export function plateOf(data) {
  const orbit = Math.hypot(data.jarCentre[0], data.jarCentre[1]);
  let reach = 0;
  let bottom = 0;
  for (const { vertices } of data.meshes)
    for (let i = 0; i < vertices.length; i += 3) {
      reach = Math.max(reach, Math.hypot(vertices[i], vertices[i + 1]));
      bottom = Math.min(bottom, vertices[i + 2]);
    }
  return { radius: orbit + 1.12 * reach, orbit, height: data.jarCentre[2] + 1.02 * bottom };
}

export function rimOf({ radius, height }) {
  return Array.from({ length: 48 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 48;
    return new Vector3(radius * Math.cos(angle), radius * Math.sin(angle), height);
  });
}

function circle(radius, height, points) {
  const steps = 180;
  for (let i = 0; i < steps; ++i)
    for (const angle of [(2 * Math.PI * i) / steps, (2 * Math.PI * (i + 1)) / steps])
      points.push(radius * Math.cos(angle), radius * Math.sin(angle), height);
}

export function carrierOf(data) {
  const { radius, orbit, height } = plateOf(data);
  const plate = new Mesh(new CircleGeometry(radius, 128),
    new MeshBasicMaterial({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 2,
      polygonOffsetUnits: 2 }));
  plate.position.z = height;
  const rim = [];
  circle(radius, height, rim);
  circle(0.03 * radius, height, rim);
  const faint = [];
  circle(orbit, height, faint);
  for (let k = 0; k < 6; ++k) {
    const [x, y] = [Math.cos((k * Math.PI) / 3), Math.sin((k * Math.PI) / 3)];
    faint.push(0.03 * radius * x, 0.03 * radius * y, height, radius * x, radius * y, height);
  }
  const strong = lines(rim, 1.4, 0.8);
  const weak = lines(faint, 1, 0.35);
  strong.renderOrder = weak.renderOrder = 0;
  const paint = (theme) => {
    plate.material.color.set(theme.disc);
    strong.material.color.set(theme.line);
    weak.material.color.set(theme.line);
  };
  return { group: new Group().add(plate, strong, weak), paint };
}
