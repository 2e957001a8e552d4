// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tables of a result: CSV text with a header.

/// `{ names, rows }`; cells that are numbers become numbers.
export function parseCsv(text) {
  const lines = text.split("\n").filter((line) => line !== "");
  if (lines.length === 0) return { names: [], rows: [] };
  const rows = lines.slice(1).map((line) => line.split(",").map((cell) => {
    const number = Number(cell);
    return cell !== "" && Number.isFinite(number) ? number : cell;
  }));
  return { names: lines[0].split(","), rows };
}

export function columnOf({ names, rows }, name) {
  const at = names.indexOf(name);
  return at < 0 ? null : rows.map((row) => row[at]);
}

const cell = (value) => /[",\n]/.test(String(value ?? ""))
  ? `"${String(value).replaceAll('"', '""')}"` : String(value ?? "");

export const writeCsv = (names, rows) =>
  `${[names, ...rows].map((row) => row.map(cell).join(",")).join("\n")}\n`;
