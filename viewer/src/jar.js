// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The jar. The far wall, seen from inside, is solid; the near wall is transparent. Stripes and one
// mark along the axis show the rotation.

import {
  BackSide, BufferAttribute, BufferGeometry, Color, EdgesGeometry, FrontSide, Group, Mesh,
  MeshStandardMaterial, ShaderMaterial, Vector3,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";

const crease = 30; // degrees; smaller between facets of a round wall, larger at edges of parts

/// Volume times 6; positive if the front sides of the triangles point outwards.
function signedVolume({ vertices, triangles }) {
  const corner = (i) => new Vector3().fromArray(vertices, 3 * triangles[i]);
  let sum = 0;
  for (let i = 0; i < triangles.length; i += 3)
    sum += corner(i).dot(corner(i + 1).cross(corner(i + 2)));
  return sum;
}

/// The mesh with front sides outwards and smooth shading across edges below the crease angle.
export function geometryOf(mesh) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(mesh.vertices, 3));
  const triangles = mesh.triangles.slice();
  if (signedVolume(mesh) < 0)
    for (let i = 0; i < triangles.length; i += 3)
      [triangles[i], triangles[i + 1]] = [triangles[i + 1], triangles[i]];
  geometry.setIndex(new BufferAttribute(triangles, 1));
  return toCreasedNormals(geometry, (crease * Math.PI) / 180);
}

export function lines(points, width, opacity) {
  const geometry = new LineSegmentsGeometry().setPositions(points);
  const material = new LineMaterial({ linewidth: width, transparent: true, opacity });
  const drawn = new LineSegments2(geometry, material);
  drawn.renderOrder = 3;
  drawn.frustumCulled = false;
  return drawn;
}

export const edgesOf = (geometry, width, opacity) =>
  lines(new EdgesGeometry(geometry, crease).attributes.position.array, width, opacity);

/// Whether the wall is rotationally symmetric about the jar's axis. Only stripes show its rotation.
function isRound(vertices) {
  const reach = new Array(12).fill(0);
  for (let i = 0; i < vertices.length; i += 3) {
    const sector = Math.floor((Math.atan2(vertices[i + 1], vertices[i]) / Math.PI + 1) * 6) % 12;
    reach[sector] = Math.max(reach[sector], Math.hypot(vertices[i], vertices[i + 1]));
  }
  return Math.min(...reach) > 0.95 * Math.max(...reach);
}

const paintStripes = `
  float r = length(vJar.xy);
  float turns = atan(vJar.y, vJar.x) / 6.2831853;
  float pixel = length(vec2(length(dFdx(vJar)), length(dFdy(vJar))));
  float sector = abs(fract(8.0 * turns) - 0.5) - 0.25;
  float soft = 8.0 * pixel / (6.2831853 * r + 1e-9);
  diffuseColor.rgb = mix(diffuseColor.rgb, stripe,
    striped * smoothstep(-soft, soft, sector) * smoothstep(0.02, 0.1, r / reach));
  float off = abs(fract(turns + 0.5) - 0.5) * 6.2831853 * r - 0.018 * reach;
  diffuseColor.rgb = mix(diffuseColor.rgb, mark, marked * (1.0 - smoothstep(-pixel, pixel, off)));
`;

function wallMaterial(uniforms) {
  const material = new MeshStandardMaterial({
    side: BackSide, roughness: 0.75, metalness: 0, envMapIntensity: 0.4,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vJar;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nvJar = position;");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vJar;\n" +
        "uniform vec3 stripe, mark;\nuniform float striped, marked, reach;")
      .replace("#include <color_fragment>", `#include <color_fragment>\n${paintStripes}`);
  };
  return material;
}

/// Transparent at perpendicular view, denser towards the outline, like glass.
const glassMaterial = () => new ShaderMaterial({
  side: FrontSide,
  transparent: true,
  depthWrite: false,
  uniforms: { tint: { value: new Color() } },
  vertexShader: `
    varying vec3 vNormal, vToEye;
    void main() {
      vec4 seen = modelViewMatrix * vec4(position, 1.0);
      vNormal = normalMatrix * normal;
      vToEye = -seen.xyz;
      gl_Position = projectionMatrix * seen;
    }`,
  fragmentShader: `
    uniform vec3 tint;
    varying vec3 vNormal, vToEye;
    void main() {
      float facing = abs(dot(normalize(vNormal), normalize(vToEye)));
      gl_FragColor = vec4(tint, 0.03 + 0.5 * pow(1.0 - facing, 3.0));
      #include <colorspace_fragment>
    }`,
});

/// The vessel around the balls. `turning`: whether it has marks of rotation.
export function vesselOf(mesh, turning) {
  const geometry = geometryOf(mesh);
  geometry.computeBoundingSphere();
  const uniforms = {
    stripe: { value: new Color() }, mark: { value: new Color() },
    striped: { value: turning && isRound(mesh.vertices) ? 1 : 0 },
    marked: { value: turning ? 1 : 0 },
    reach: { value: geometry.boundingSphere.radius },
  };
  const wall = new Mesh(geometry, wallMaterial(uniforms));
  wall.receiveShadow = true;
  const glass = new Mesh(geometry, glassMaterial());
  glass.renderOrder = 2;
  const rim = edgesOf(geometry, 1.4, 0.75);
  const group = new Group().add(wall, glass, rim);
  const paint = (theme) => {
    wall.material.color.set(theme.wall);
    uniforms.stripe.value.set(theme.stripe);
    uniforms.mark.value.set(theme.mark);
    glass.material.uniforms.tint.value.set(theme.glass);
    rim.material.color.set(theme.line);
  };
  return { group, paint };
}

/// A solid body, such as a stirrer.
export function partOf(mesh) {
  const geometry = geometryOf(mesh);
  const body = new Mesh(geometry, new MeshStandardMaterial({ roughness: 0.45, metalness: 0.3 }));
  body.castShadow = body.receiveShadow = true;
  const edges = edgesOf(geometry, 1, 0.5);
  const paint = (theme) => {
    body.material.color.set(theme.part);
    edges.material.color.set(theme.line);
  };
  return { group: new Group().add(body, edges), paint };
}
