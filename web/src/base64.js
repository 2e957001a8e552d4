// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Bytes as text, and deflated bytes.

export function fromBase64(text) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

/// base64 with the alphabet for addresses, without padding.
export function toBase64Url(bytes) {
  let raw = "";
  for (const byte of bytes) raw += String.fromCharCode(byte);
  return btoa(raw).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export const fromBase64Url = (text) =>
  fromBase64(text.replaceAll("-", "+").replaceAll("_", "/"));

async function collect(stream, most) {
  const pieces = [];
  let length = 0;
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > most) {
      await reader.cancel();
      throw new Error("too long");
    }
    pieces.push(value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}

const through = (bytes, transform, most) =>
  collect(new Blob([bytes]).stream().pipeThrough(transform), most);

export const deflate = (bytes) =>
  through(bytes, new CompressionStream("deflate-raw"), Infinity);

/// Throws if the result is longer than `most` bytes.
export const inflate = (bytes, most = Infinity) =>
  through(bytes, new DecompressionStream("deflate-raw"), most);
