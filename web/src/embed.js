// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The page in a frame of another page: replay, run bar and key numbers, and a link to the whole page. The address says
// so, by "?embed" or by "#embed&case=...", with "&run" if the case is to run at once.

import { element } from "./dom.js";
import { text } from "./text/text.js";

const words = () => [...location.hash.replace(/^#/, "").split("&"), ...location.search.replace(/^\?/, "").split("&")];

export const isEmbedded = () => words().includes("embed");

/// Whether the case of the address runs at once.
export const runsAtOnce = () => isEmbedded() && words().includes("run");

/// Hides what a frame does not show, and adds the link. `runBar`: its element.
export function embed(runBar) {
  document.body.dataset.embed = "true";
  const shared = words().find((word) => word.startsWith("case="));
  const page = location.href.replace(/[?#].*$/, "");
  runBar.append(element("a", { className: "in-full", href: shared ? `${page}#${shared}` : page, target: "_blank",
    rel: "noopener", textContent: text.openInFull }));
}

const escaped = (words) => words.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

/// The HTML of a frame with a case. `fragment`: the case, as in the address.
export function frameOf(title, fragment) {
  const page = location.href.replace(/[?#].*$/, "");
  return `<iframe src="${page}#embed&amp;${fragment}" title="${escaped(title)}" loading="lazy" ` +
    'style="width:100%;height:46rem;border:0"></iframe>';
}
