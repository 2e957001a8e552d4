// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The lessons: a case of web/lessons, the cases that show the answer, and which answer is right. Their words stand in
// text/, in the same order. What a lesson says must be true of these cases: `holds` says it of their summaries, and
// test/test_native.js asks the program. The numbers below are the program's:
//
//   mahlwerk run web/lessons/collision.toml --set "mill.frequency=20 Hz"
//
// with the interval of 95 %; hits and their mean energy are those above the threshold.

const power = "dissipated_power", rate = "collision_rate_above_threshold", energy = "energy_normal_mean_above_threshold";

/// Whether `a` is below `b`, and their intervals do not touch.
const below = (a, b) => a.value + a.ci95 < b.value - b.ci95;
const ratio = (a, b) => b.value / a.value;
const within = (value, least, most) => value >= least && value <= most;

const point = (value, set) => ({ value, set: Object.entries(set) });

export const lessons = [
  // 10 Hz: 40.10 ± 0.27 mW, 142.6 ± 3.8 /s, 1.012 ± 0.029 mJ
  // 14 Hz: 111.69 ± 0.66 mW, 211.7 ± 3.2 /s, 1.968 ± 0.022 mJ
  // 20 Hz: 322.2 ± 9.9 mW, 300.1 ± 8.4 /s, 3.992 ± 0.070 mJ
  { name: "collision", right: 2, quantities: [power, rate, energy],
    points: ["10 Hz", "14 Hz", "20 Hz"].map((value) => point(value, { "mill.frequency": value })),
    holds: ([slow, , fast]) => within(ratio(slow[power], fast[power]), 7.6, 8.4) &&
      within(ratio(slow[rate], fast[rate]), 2, 2.2) && within(ratio(slow[energy], fast[energy]), 3.8, 4.1) },
  // 50 %: 1.51 ± 0.22 W, 16.1 ± 5.1 mJ
  // 75 %: 1.67 ± 0.14 W, 21.9 ± 2.3 mJ
  // 125 %: 0.48 ± 0.27 W, 6.45 ± 0.48 mJ
  { name: "speed", right: 1, quantities: [power, energy],
    points: ["50 %", "75 %", "125 %"].map((value) => point(value, { "mill.speed": value })),
    holds: ([slow, usual, fast]) => below(fast[power], usual[power]) && below(fast[power], slow[power]) &&
      below(fast[energy], usual[energy]) && within(ratio(fast[energy], usual[energy]), 2.5, 3.8) },
  // 7 x 15 mm: 2390 ± 230 /s, 1.42 ± 0.19 mJ, 4.10 ± 0.20 W
  // 24 x 10 mm: 15240 ± 720 /s, 0.204 ± 0.030 mJ, 5.261 ± 0.080 W
  { name: "size", right: 1, quantities: [rate, energy, power],
    points: [[7, 15], [24, 10]].map(([count, diameter]) => point(`${count} × ${diameter} mm`,
      { "balls.1.count": String(count), "balls.1.diameter": `${diameter} mm` })),
    holds: ([large, small]) => below(large[rate], small[rate]) && below(small[energy], large[energy]) &&
      within(ratio(large[rate], small[rate]), 5, 7.5) && within(ratio(small[energy], large[energy]), 5.5, 8.5) },
  // 1: 77.3 ± 5.8 mW, 0.93 ± 0.14 mJ; 2: 142 ± 11 mW, 0.71 ± 0.22 mJ
  // 4: 201.3 ± 6.0 mW, 0.467 ± 0.061 mJ; 6: 59.3 ± 4.1 mW, 0.0327 ± 0.0064 mJ
  { name: "filling", right: 2, quantities: [power, energy],
    points: ["1", "2", "4", "6"].map((value) => point(value, { "balls.1.count": value })),
    holds: ([one, two, four, six]) => below(six[power], one[power]) && below(one[power], two[power]) &&
      below(two[power], four[power]) && below(six[energy], four[energy]) && below(four[energy], one[energy]) },
  // 2 s: 10 Hz 39.8 ± 6.8 mW; 11 Hz 51 ± 15 mW
  // 200 s: 10 Hz 39.9 ± 1.1 mW, 139.1 ± 8.5 /s; 11 Hz 52.5 ± 2.5 mW, 152 ± 13 /s
  // 200 s, e = 0.8: 10 Hz 36.1 ± 1.3 mW, 46.2 ± 6.1 /s; 11 Hz 48.5 ± 2.2 mW, 60.8 ± 6.6 /s
  { name: "trust", right: 2, quantities: [power, rate],
    points: [["2 s", "0.9"], ["200 s", "0.9"], ["200 s", "0.8"]].flatMap(([time, restitution]) =>
      ["10 Hz", "11 Hz"].map((frequency) => point(`${frequency}, ${time}, e\u00a0=\u00a0${restitution}`,
        { "mill.frequency": frequency, "run.time": time, "contact.restitution": restitution }))),
    holds: ([a, b, longA, longB, otherA, otherB]) => !below(a[power], b[power]) && below(longA[power], longB[power]) &&
      below(otherA[rate], longA[rate]) && within(ratio(otherA[rate], longA[rate]), 2.5, 3.5) &&
      [[longA, longB], [otherA, otherB]].every(([one, two]) => within(ratio(one[power], two[power]), 1.25, 1.4)) },
];

/// The number of the lesson that an address names, "#lesson=2"; 0 if none.
export function lessonOf(fragment) {
  const number = Number(/^#lesson=(\d+)$/.exec(fragment)?.[1]);
  return number >= 1 && number <= lessons.length ? number : 0;
}
