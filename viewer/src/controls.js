// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Elements of the component. `actions` are their event handlers; `show` updates them.

const icons = {
  play: "M3 1.5v13l11-6.5z",
  pause: "M3 2h3.6v12H3zm6.4 0H13v12H9.4z",
  back: "M12 2v12L4.5 8zM2.5 2h2v12h-2z",
  forward: "M4 2v12l7.5-6zm7.5 0h2v12h-2z",
};

function element(name, properties = {}, children = []) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    if (key.startsWith("aria-") || key === "role") made.setAttribute(key, value);
    else made[key] = value;
  made.append(...children);
  return made;
}

function draw(button, icon) {
  button.innerHTML = `<svg viewBox="0 0 16 16" aria-hidden="true"><path d="${icons[icon]}"/></svg>`;
}

function iconButton(icon, label, onclick, extra = "") {
  const button = element("button",
    { type: "button", className: `icon ${extra}`, title: label, "aria-label": label, onclick });
  draw(button, icon);
  return button;
}

const textButton = (text, title, onclick) =>
  element("button", { type: "button", textContent: text, title, onclick });

const group = (label, ...children) => element("div",
  { className: "group", role: "group", "aria-label": label },
  [element("span", { textContent: label, "aria-hidden": "true" }), ...children]);

/// A group of buttons; exactly one is pressed.
function choice(label, options, pick) {
  const box = element("div", { className: "choice" });
  const offer = (offered) => box.replaceChildren(...offered.map(({ key, name, about }) => {
    const button = textButton(name, about ?? "", () => pick(key));
    button.dataset.key = key;
    return button;
  }));
  const show = (chosen) => [...box.children].forEach((button) =>
    button.setAttribute("aria-pressed", String(button.dataset.key === chosen)));
  offer(options);
  return { group: group(label, box), offer, show };
}

const pictureLabel = (title) =>
  `Balls in the moving jar: ${title}. Drag to rotate, shift and drag to pan, ` +
  "wheel or two fingers to zoom. Keys: space plays or pauses, arrows step, v changes the " +
  "view, c changes the colours, plus and minus zoom, shift and arrows rotate.";

const pictureOf = (title) => {
  const scene = element("canvas", { className: "scene", tabIndex: 0, role: "img",
    "aria-label": pictureLabel(title) });
  const written = element("canvas", { className: "written", "aria-hidden": "true" });
  const print = element("canvas", { className: "print", "aria-hidden": "true" });
  return { scene, written, print };
};

function keysHint() {
  const hint = element("span", { className: "keys" });
  hint.innerHTML = " Drag rotates, <kbd>space</kbd> plays, <kbd>\u2190</kbd> " +
    "<kbd>\u2192</kbd> step, <kbd>v</kbd> view, <kbd>c</kbd> colour. A click picks a ball, <kbd>b</kbd> the next one.";
  return hint;
}

function playRow(actions) {
  const play = iconButton("play", "Play", actions.toggle, "go");
  const slider = element("input", { type: "range", min: 0,
    step: "any", value: 0, "aria-label": "Time", oninput: () => actions.scrub(+slider.value) });
  const clock = element("output", { "aria-label": "Simulated time", "aria-live": "off" });
  const back = iconButton("back", "One frame back", () => actions.step(-1));
  const forward = iconButton("forward", "One frame forward", () => actions.step(1));
  const offer = (frames) => {
    slider.max = Math.max(frames - 1, 0);
    for (const input of [play, slider, back, forward]) input.disabled = frames < 2;
  };
  const row = element("div", { className: "row" }, [play, back, forward, slider, clock]);
  return { row, play, slider, clock, offer };
}

function paceGroup(actions) {
  const pace = element("select", { "aria-label": "Speed of the replay",
    title: "Simulated time per real time", onchange: () => actions.pace(+pace.value) });
  const offer = (factors) => pace.replaceChildren(...factors.map((factor) =>
    element("option", { value: factor, textContent: `${factor}x` })));
  const loop = element("input", { type: "checkbox", onchange: () => actions.loop(loop.checked) });
  const label = element("label", { className: "loop" }, [loop, "Loop"]);
  return { group: group("Replay speed", pace, label), pace, loop, offer };
}

function saveGroup(videoFault, actions) {
  const about = videoFault ?? "Save the whole replay as a video";
  const video = textButton("Video", about, actions.video);
  video.disabled = videoFault !== null;
  const png = textButton("Picture", "Save this picture as PNG, at twice the resolution",
    actions.png);
  const both = group("Save", element("div", { className: "choice" }, [png, video]));
  both.classList.add("push");
  return { group: both, video };
}

/// Builds the component below `root`. `options`: title, frames, views, colours, factors, videoFault
/// (reason why video is not available, or null). `actions`: toggle, scrub, step, view, colour,
/// look, pace, loop, png, video.
export function build(root, options, actions) {
  const picture = pictureOf(options.title);
  const playing = playRow(actions);
  const view = choice("View", options.views, actions.view);
  const colour = choice("Colour", options.colours, actions.colour);
  const pace = paceGroup(actions);
  const camera = group("Camera", element("div", { className: "choice" }, [
    textButton("Start", "Initial view", () => actions.look("start")),
    textButton("Along axis", "View along the jar's axis", () => actions.look("axis")),
    textButton("Side", "View from the side", () => actions.look("side")),
  ]));
  const save = saveGroup(options.videoFault, actions);
  const caption = element("span");
  const said = element("div", { className: "said", role: "status" });
  const figure = element("figure", { role: "group", "aria-label": `Replay: ${options.title}` }, [
    element("div", { className: "picture" }, [picture.scene, picture.written, picture.print]),
    element("div", { className: "panel" }, [
      playing.row,
      element("div", { className: "row" }, [view.group, colour.group, camera]),
      element("div", { className: "row" }, [pace.group, save.group]),
      said,
      element("figcaption", {}, [caption, keysHint()]),
    ]),
  ]);
  root.append(figure);

  /// Adapts the controls to other data: title, frames, views, factors.
  function offer({ title, frames, views, factors }) {
    picture.scene.setAttribute("aria-label", pictureLabel(title));
    figure.setAttribute("aria-label", `Replay: ${title}`);
    playing.offer(frames);
    view.offer(views);
    pace.offer(factors);
  }
  offer(options);

  /// Updates the elements to the state of the replay.
  function show(state) {
    draw(playing.play, state.playing ? "pause" : "play");
    playing.play.title = state.playing ? "Pause" : "Play";
    playing.play.setAttribute("aria-label", playing.play.title);
    view.show(state.view);
    colour.show(state.colour);
    pace.pace.value = state.factor;
    pace.loop.checked = state.loop;
    save.video.textContent = state.recording ? "Stop" : "Video";
    caption.textContent = state.caption;
    said.textContent = state.said;
  }

  /// Updates the elements that change with every frame.
  function showTime(frame, time) {
    playing.slider.value = frame;
    playing.slider.setAttribute("aria-valuetext", time);
    playing.clock.textContent = time;
  }

  return { ...picture, figure, slider: playing.slider, offer, show, showTime };
}

/// Replaces the component by an error message.
export function apologize(root, sentence) {
  root.replaceChildren(element("figure", {},
    [element("p", { className: "sorry", role: "alert", textContent: sentence })]));
}
