// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What the engine knows, as the form needs it: keys of cases, and entries of the catalogue.

import { useUnits } from "./quantity.js";

const valueOf = (values, end) => (values[`frequency_${end}`] ?? values[`speed_${end}`])?.value;

/// An entry; `least` and `most` are the range of frequency or speed, `fixed` the keys that it gives, `fixedDrive` its
/// frequency or speed if it has only one.
const entryOf = ({ name, title, names = [], kind, jars = [], values = {} }) => ({ name, title, names, kind, jars,
  least: valueOf(values, "least"), most: valueOf(values, "most"), fixed: new Set(Object.keys(values)),
  fixedDrive: (values.frequency ?? values.speed)?.value, volume: values.volume?.value,
  unverified: Object.values(values).some(({ unverified, assumed }) => unverified || assumed) });

export function knownOf({ keys, units, catalogue }) {
  useUnits(units);
  const { mills, jars, materials } = catalogue;
  return { vocabulary: keys, catalogue: { mills: mills.map(entryOf), jars: jars.map(entryOf),
    materials: materials.map(entryOf) } };
}
