// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
// Scores of the search: pages for users stand before those about the code. A page has the score of its best word, 15 in a
// title and 5 in the text, so that errors.md, whose headings have most words, stood first. The other numbers are Sphinx's.
var Scorer = {
  score: result => {
    const [name, , , , score] = result;
    if (/^(howto|tutorial|install|examples)\b/.test(name)) return score + 11;  // more than a word in a title
    if (/^(source|developers|changelog|architecture|performance|reference\/cpp|publications|errors)\b/.test(name)) return score - 4;
    return score;
  },
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: {0: 15, 1: 5, 2: -5},
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
