// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// English names of words, and the sentences of the examples.

export const words = {
  auto: "chosen by the program", event: "event engine", soft: "soft engine (contact forces)",
  still: "At rest", vibration: "Vibrating vial", planetary: "Planetary mill", tumbling: "Tumbling drum",
  "arc-shaker": "Mixer mill (arc)", "figure-eight": "Shaker mill (figure of eight)",
  circular: "Circular motion", capsule: "Capsule (half spheres)", cylinder: "Cylinder",
  "rounded-cylinder": "Rounded cylinder", sphere: "Sphere", box: "Box",
};

export const examples = {
  "vibrating-vial": { name: "Vibrating vial (Chen et al. 2016)",
    hint: "One ball bounces in a shaken capsule. Try a frequency of 14 Hz: does the power grow as its " +
      "cube?" },
  "mixer-mill": { name: "Retsch MM 400",
    hint: "Two balls in a jar that swings in an arc. Try one ball instead of two, and compare the " +
      "spectra." },
  "planetary-mill": { name: "Fritsch Pulverisette 7 (planetary)",
    hint: "Seven balls in a planetary mill. Try a sweep of the speed from 200 to 800 rpm." },
  "tumbling-drum": { name: "Tumbling drum",
    hint: "Balls climb the wall and fall. Try 100 % of the critical speed, and watch the balls stay on " +
      "the wall." },
  "shaker-mill": { name: "SPEX 8000M",
    hint: "Large and small balls in a figure of eight. Try it without the small balls: which hits " +
      "vanish?" },
  quartz: { name: "How fine quartz gets",
    hint: "From impacts to grain sizes, after an hour of milling. Try 300 rpm, and look at the tab " +
      "Powder." },
};
