// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Pointer and keys on a replay.

const orbitKeys = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const next = (options, key) =>
  options[(options.findIndex((option) => option.key === key) + 1) % options.length].key;

/// A click that does not drag picks the ball below it.
function listenToClicks(replay, scene) {
  let pressed = null;
  scene.addEventListener("pointerdown", (event) => {
    scene.focus({ preventScroll: true });
    pressed = event.button === 0 ? [event.offsetX, event.offsetY] : null;
  });
  scene.addEventListener("pointerup", ({ offsetX, offsetY }) => {
    if (pressed && Math.hypot(offsetX - pressed[0], offsetY - pressed[1]) < 4)
      replay.pick(replay.stage.ballAt((2 * offsetX) / scene.clientWidth - 1,
        1 - (2 * offsetY) / scene.clientHeight));
  });
}

function key(replay, event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const { state } = replay;
  const name = event.target.localName;
  const orbit = orbitKeys[event.key];
  if (orbit && event.shiftKey) replay.orbit(...orbit);
  else if (event.key === " " && !["button", "select"].includes(name) &&
           event.target.type !== "checkbox") replay.play(!state.playing);
  else if (orbit?.[0] && name !== "select") replay.step(orbit[0]);
  else if (event.key === "v" && name !== "select") replay.view(next(replay.views, state.view));
  else if (event.key === "c" && name !== "select")
    replay.change({ colour: next(replay.shown.colours, state.colour) });
  else if (event.key === "h" && name !== "select") replay.change({ hits: !state.hits });
  else if (event.key === "b" && name !== "select") replay.pick(replay.nextBall());
  else if (event.key === "Escape" && state.picked !== null) replay.pick(null);
  else if (event.key === "+" || event.key === "-") replay.nearer(event.key === "+" ? 0.87 : 1.15);
  else return;
  event.preventDefault();
}

export function listenTo(replay) {
  const { scene } = replay.elements;
  const { controls } = replay.stage;
  controls.addEventListener("change", () => replay.want());
  // The wheel zooms only while the picture has the focus; otherwise it scrolls the page.
  controls.enableZoom = false;
  scene.addEventListener("focus", () => (controls.enableZoom = true));
  scene.addEventListener("blur", () => (controls.enableZoom = false));
  listenToClicks(replay, scene);
  replay.root.addEventListener("keydown", (event) => key(replay, event));
}
