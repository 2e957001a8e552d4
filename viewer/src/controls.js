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

const pictureOf = (label) => {
  const scene = element("canvas", { className: "scene", tabIndex: 0, role: "img", "aria-label": label });
  const written = element("canvas", { className: "written", "aria-hidden": "true" });
  const print = element("canvas", { className: "print", "aria-hidden": "true" });
  return { scene, written, print };
};

/// Every second piece is a key.
const keysHint = (pieces) => element("span", { className: "keys" }, pieces.map((piece, i) =>
  i % 2 ? element("kbd", { textContent: piece }) : piece));

function playRow(actions, text) {
  const play = iconButton("play", text.play, actions.toggle, "go");
  const slider = element("input", { type: "range", min: 0,
    step: "any", value: 0, "aria-label": text.time, oninput: () => actions.scrub(+slider.value) });
  const clock = element("output", { "aria-label": text.simulatedTime, "aria-live": "off" });
  const back = iconButton("back", text.back, () => actions.step(-1));
  const forward = iconButton("forward", text.forward, () => actions.step(1));
  const offer = (frames) => {
    slider.max = Math.max(frames - 1, 0);
    for (const input of [play, slider, back, forward]) input.disabled = frames < 2;
  };
  const row = element("div", { className: "row" }, [play, back, forward, slider, clock]);
  return { row, play, slider, clock, offer };
}

function paceGroup(actions, text) {
  const pace = element("select", { "aria-label": text.paceLabel,
    title: text.paceAbout, onchange: () => actions.pace(+pace.value) });
  const offer = (factors) => pace.replaceChildren(...factors.map((factor) =>
    element("option", { value: factor, textContent: `${factor}x` })));
  const loop = element("input", { type: "checkbox", onchange: () => actions.loop(loop.checked) });
  const label = element("label", { className: "loop" }, [loop, text.loop]);
  return { group: group(text.pace, pace, label), pace, loop, offer };
}

function saveGroup(videoFault, actions, text) {
  const about = videoFault ?? text.saveVideoAbout;
  const video = textButton(text.saveVideo, about, actions.video);
  video.disabled = videoFault !== null;
  const png = textButton(text.savePicture, text.savePictureAbout, actions.png);
  const both = group(text.save, element("div", { className: "choice" }, [png, video]));
  both.classList.add("push");
  return { group: both, video };
}

/// The switch of the marks of hits; hidden where the data have none.
function hitsSwitch(actions, text) {
  const input = element("input", { type: "checkbox", onchange: () => actions.hits(input.checked) });
  const label = element("label", { className: "loop", title: text.hitsAbout }, [input, text.hits]);
  return { input, label };
}

/// Builds the component below `root`. `options`: title, frames, views, colours, factors, videoFault
/// (reason why video is not available, or null). `actions`: toggle, scrub, step, view, colour,
/// hits, look, pace, loop, png, video. `text`: the words.
export function build(root, options, actions, text) {
  const picture = pictureOf(text.picture(options.title));
  const playing = playRow(actions, text);
  const view = choice(text.view, options.views, actions.view);
  const colour = choice(text.colour, options.colours, actions.colour);
  const hits = hitsSwitch(actions, text);
  const pace = paceGroup(actions, text);
  const camera = group(text.camera, element("div", { className: "choice" },
    Object.entries(text.directions).map(([key, { name, about }]) => textButton(name, about, () => actions.look(key)))));
  const save = saveGroup(options.videoFault, actions, text);
  const caption = element("span");
  const said = element("div", { className: "said", role: "status" });
  const figure = element("figure", { role: "group", "aria-label": text.replay(options.title) }, [
    element("div", { className: "picture" }, [picture.scene, picture.written, picture.print]),
    element("div", { className: "panel" }, [
      playing.row,
      element("div", { className: "row" }, [view.group, colour.group, hits.label]),
      element("div", { className: "row" }, [pace.group, camera, save.group]),
      said,
      element("figcaption", {}, [caption, keysHint(text.keys)]),
    ]),
  ]);
  root.append(figure);

  /// Adapts the controls to other data: title, frames, views, colours, factors, hasHits.
  function offer({ title, frames, views, colours, factors, hasHits }) {
    picture.scene.setAttribute("aria-label", text.picture(title));
    figure.setAttribute("aria-label", text.replay(title));
    playing.offer(frames);
    view.offer(views);
    colour.offer(colours);
    hits.label.hidden = !hasHits;
    pace.offer(factors);
  }
  offer(options);

  /// Updates the elements to the state of the replay.
  function show(state) {
    draw(playing.play, state.playing ? "pause" : "play");
    playing.play.title = state.playing ? text.pause : text.play;
    playing.play.setAttribute("aria-label", playing.play.title);
    view.show(state.view);
    colour.show(state.colour);
    hits.input.checked = state.hits;
    pace.pace.value = state.factor;
    pace.loop.checked = state.loop;
    save.video.textContent = state.recording ? text.stop : text.saveVideo;
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
