// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// All words of the replay, in English. Another language is another module of the same shape.

/// "12 345" with a narrow no-break space between thousands.
export const grouped = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, "\u202f");

/// "20th".
function ordinal(number) {
  const tens = number % 100;
  const end = tens >= 11 && tens <= 13 ? "th" : ["th", "st", "nd", "rd"][number % 10] ?? "th";
  return `${number}${end}`;
}

const ballsShown = ({ count, of }) => of > count
  ? `${grouped(count)} of ${grouped(of)} balls (${Math.round(of / count) > 1
    ? `every ${ordinal(Math.round(of / count))} ball is shown` : "not all balls are shown"})`
  : `${grouped(count)} ${count === 1 ? "ball" : "balls"}`;

export const en = {
  replay: (title) => `Replay: ${title}`,
  picture: (title) => `Balls in the moving jar: ${title}. Drag to rotate, shift and drag to pan, ` +
    "wheel or two fingers to zoom. Keys: space plays or pauses, arrows step, v changes the " +
    "view, c changes the colours, h shows or hides hits, plus and minus zoom, shift and arrows rotate.",
  /// A text, then pairs of a key to press and what follows.
  keys: [" Drag rotates, ", "space", " plays, ", "\u2190", " ", "\u2192", " step, ", "v", " view, ", "c",
    " colour, ", "h", " hits. A click picks a ball, ", "b", " the next one."],

  play: "Play",
  pause: "Pause",
  back: "One frame back",
  forward: "One frame forward",
  time: "Time",
  simulatedTime: "Simulated time",
  pace: "Replay speed",
  paceLabel: "Speed of the replay",
  paceAbout: "Simulated time per real time",
  loop: "Loop",
  realTime: (factor) => `${factor}x real time`,

  view: "View",
  views: {
    laboratory: { name: "Laboratory", about: "in the frame of the laboratory" },
    centre: { name: "Jar centre", about: "in the frame of the jar's centre, not rotating" },
    fixed: { name: "Jar fixed", about: "in the frame of the jar, rotating with it" },
  },
  /// `name`: that of the data, "disc".
  carrier: (name) => ({ name: name[0].toUpperCase() + name.slice(1),
    about: `in the frame of the ${name}, rotating with it about the mill's axis` }),

  colour: "Colour",
  colours: {
    speed: { name: "Speed", about: "Speed relative to the jar's centre",
      scale: (unit) => `Speed relative to jar centre (${unit})` },
    spin: { name: "Spin", about: "Angular speed of the ball about its own centre",
      scale: (unit) => `Spin (${unit})` },
    energy: { name: "Energy", about: "Kinetic energy of translation, by the speed relative to the jar's centre; without " +
      "the energy of the spin", scale: (unit) => `Kinetic energy of translation (${unit})` },
    species: { name: "Kind", about: "One colour for each kind of ball" },
  },

  hits: "Hits",
  hitsAbout: "Flash the strongest hits. A larger and redder ring has more impact energy (normal motion)",
  hitsScale: "Hits, impact energy",

  camera: "Camera",
  directions: {
    start: { name: "Start", about: "Initial view" },
    axis: { name: "Along axis", about: "View along the jar's axis" },
    side: { name: "Side", about: "View from the side" },
  },

  save: "Save",
  savePicture: "Picture",
  savePictureAbout: "Save this picture as PNG, at twice the resolution",
  saveVideo: "Video",
  saveVideoAbout: "Save the whole replay as a video",
  stop: "Stop",
  recording: (seconds) => `Recording: the replay plays once, ${seconds} s. Keep this page visible.`,
  videoFailed: (why) => `The video could not be recorded: ${why}.`,
  recorderStopped: "the recorder stopped",
  noFrames: "the browser recorded no picture; a slower replay may help",
  noRecorder: "This browser cannot record videos",
  noVideoFormat: "This browser supports no video format for recording",

  /// `from`, `to`: times as text. `view`: the `about` of a view.
  caption: (data, from, to, view) => `${ballsShown(data)}, ${data.frames > 1
    ? `${grouped(data.frames)} frames from ${from} to ${to}` : `one frame at ${from}`}, ${view}.`,
  /// Of the picked ball. `body`: it is a sphere of a body.
  picked: ({ number, body, kind }) => `${body ? "Sphere" : "Ball"} ${grouped(number)}${kind ? `, ${kind}` : ""}`,
  /// Of the picked ball, above the threshold of the case, in the time of the replay.
  hitsOf: (count, span) => `${grouped(count)} ${count === 1 ? "hit" : "hits"} in ${span}`,
  weight: "g",

  noWebGL: "The replay needs WebGL 2, which this browser does not support or has disabled. All numbers of this report " +
    "are complete without the replay.",
  dataFault: (what) => `The replay's data cannot be shown: ${what}; write the report again with the version of ` +
    "mahlwerk that wrote this page.",
  dataFaults: {
    missing: (name) => `"${name}" is missing`,
    notBase64: (name) => `"${name}" is not base64`,
    length: (name, found, expected) => `"${name}" holds ${found} bytes instead of ${expected}`,
    multiple: (name, found, size) => `"${name}" holds ${found} bytes, not a multiple of ${size}`,
    notPositive: (name, value) => `"${name}" must be above 0, not ${value}`,
    corners: (name) => `"${name}.triangles" refers to a vertex that "${name}.vertices" does not contain`,
    bodies: (name, count, first, spheres) =>
      `"${name}" has ${count} bodies from sphere ${first} on, of ${spheres} spheres`,
    noTimes: () => '"times" is missing or empty',
    times: () => 'the numbers in "times" must increase',
    notJson: (why) => `they are not JSON (${why})`,
    version: (found) => `they have version ${found}, but this page reads version 1`,
    count: (found) => `"count" must be a whole number, not ${found}`,
  },
};
