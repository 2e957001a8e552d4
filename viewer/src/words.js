// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Numbers and captions as text.

/// At most three significant digits, without an exponent at usual sizes.
export const short = (number) => String(Number(number.toPrecision(3)));

/// Writes times of a run in one unit, with enough decimals to distinguish its frames.
export function clockOf(times) {
  const last = times[times.length - 1];
  const milli = last < 1;
  const step = times.length > 1 ? (last - times[0]) / (times.length - 1) : 1;
  const decimals = Math.min(6, Math.max(0, 1 - Math.floor(Math.log10(milli ? 1e3 * step : step))));
  return (time) => (milli ? `${(1e3 * time).toFixed(decimals)} ms` : `${time.toFixed(decimals)} s`);
}

/// Replay speeds: 1, 2 and 5 of each decade with a duration of one second to ten minutes. `usual`
/// is the speed with the duration nearest to twelve seconds.
export function factorsOf(duration) {
  const offered = [];
  for (let power = -6; power <= 4; ++power)
    for (const step of [1, 2, 5]) {
      const factor = Number(`${step}e${power}`);
      const lasts = duration / factor;
      if (lasts >= 1 && lasts <= 600) offered.push(factor);
    }
  if (offered.length === 0) offered.push(1);
  const distance = (factor) => Math.abs(Math.log(duration / factor / 12));
  const usual = offered.reduce((a, b) => (distance(b) < distance(a) ? b : a));
  return { offered, usual };
}

/// Which balls and times are shown, in the words `text`.
export function captionOf(data, view, clock, text) {
  const [first, last] = [data.times[0], data.times[data.frames - 1]].map(clock);
  return text.caption(data, first, last, view.about);
}
