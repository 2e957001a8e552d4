// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Ten colours of viridis, perceptually uniform, also for colour-blind readers (S. van der Walt and N. Smith,
// matplotlib, CC0): of the replay's speeds and of maps.
export const viridis = ["#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58",
  "#b5de2b", "#fde725"];
