// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A case as part of an address: deflated, base64, in the fragment, which browsers never send.

import { deflate, fromBase64Url, inflate, toBase64Url } from "../base64.js";

const name = "case=";
const longest = 1 << 20; // bytes of a case

export async function fragmentOf(text) {
  return name + toBase64Url(await deflate(new TextEncoder().encode(text)));
}

/// The case of a fragment; null if it has none. Throws if the fragment is damaged.
export async function caseOf(fragment) {
  const given = fragment.replace(/^#/, "").split("&").find((word) => word.startsWith(name));
  if (!given) return null;
  const bytes = await inflate(fromBase64Url(given.slice(name.length)), longest);
  return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
}
