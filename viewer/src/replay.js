// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The replay as a component: plays data inside an element, and takes newer data while it plays.

import { annotate } from "./annotations.js";
import { printTheme, themeOf } from "./colours.js";
import { apologize, build } from "./controls.js";
import { faultIn } from "./data.js";
import { listenTo } from "./input.js";
import { frameOf, timeOf, viewsOf } from "./motion.js";
import { linesOf } from "./picked.js";
import { film, savePicture, videoFault } from "./save.js";
import { Shown } from "./shown.js";
import { Stage } from "./stage.js";
import { en } from "./text/en.js";
import { captionOf, clockOf, factorsOf } from "./words.js";

export class Replay {
  constructor(root, data, text) {
    Object.assign(this, { root, text });
    this.take(data);
    this.seen = true;
    this.state = { frame: 0, playing: false, factor: this.factors.usual, loop: true,
      view: this.views[0].key, colour: "speed", hits: !this.still(), picked: null, recording: null, said: "" };
    this.elements = build(root, { ...this.offer(), videoFault: videoFault(text) },
      this.actions(), text);
    this.theme = themeOf(root);
    const context = this.elements.scene.getContext("webgl2",
      { antialias: true, preserveDrawingBuffer: true, powerPreference: "high-performance" });
    if (!context) throw Object.assign(new Error("no WebGL 2"), { name: "NoWebGL" });
    this.stage = new Stage(this.elements.scene, context, data);
    this.stage.paint(this.theme);
    this.fit();
    this.show();
    this.listen();
    if (data.frames > 1 && !this.still()) this.play(true);
  }

  take(data) {
    this.data = data;
    this.views = viewsOf(data, this.text);
    this.shown = new Shown(data, this.text);
    this.clock = clockOf(data.times);
    this.factors = factorsOf(this.duration());
  }

  /// What the controls offer for the current data.
  offer() {
    const { title, frames } = this.data;
    return { title, frames, views: this.views, colours: this.shown.colours, factors: this.factors.offered,
      hasHits: this.data.hits !== null };
  }

  /// Shows other data, at the same time, in the same view and from the same direction where the new
  /// data allow it. `restart`: from the start, as after mounting.
  renew(data, restart = false) {
    const { state } = this;
    const time = timeOf(this.data, state.frame);
    const resumes = data.frames > 1 && this.data.frames < 2 && !this.still();
    if (state.recording) this.play(false);
    if (restart || data.count !== this.data.count) state.picked = null;
    this.take(data);
    const sameView = this.views.some(({ key }) => key === state.view);
    if (!sameView) state.view = this.views[0].key;
    if (!this.shown.has(state.colour)) state.colour = "speed";
    if (restart || !this.factors.offered.includes(state.factor)) state.factor = this.factors.usual;
    state.frame = restart ? 0 : frameOf(data, time);
    this.elements.offer(this.offer());
    this.stage.renew(data);
    this.stage.paint(this.theme);
    this.stage.showPath(state.picked, state.view);
    if (this.size) this.stage.lookFrom(restart || !sameView ? "start" : this.stage.direction(),
      state.view);
    if (resumes || (restart && !this.still())) this.play(true);
    else if (data.frames < 2) this.play(false);
    else this.show();
  }

  still() {
    return matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  duration() {
    return this.data.times[this.data.frames - 1] - this.data.times[0];
  }

  actions() {
    return {
      toggle: () => this.play(!this.state.playing),
      scrub: (frame) => this.scrub(frame),
      step: (by) => this.step(by),
      view: (key) => this.view(key),
      colour: (key) => this.change({ colour: key }),
      hits: (hits) => this.change({ hits }),
      look: (direction) => this.look(direction),
      pace: (factor) => this.change({ factor }),
      loop: (loop) => this.change({ loop }),
      png: () => this.savePicture(),
      video: () => (this.state.recording ? this.play(false) : this.record()),
    };
  }

  listen() {
    const { scene } = this.elements;
    listenTo(this);
    scene.addEventListener("webglcontextrestored", () => this.want());
    new ResizeObserver(() => this.fit()).observe(scene);
    new IntersectionObserver(([{ isIntersecting }]) => this.appear(isIntersecting)).observe(scene);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.repaint());
    addEventListener("beforeprint", () => this.print());
  }

  change(some) {
    Object.assign(this.state, some);
    this.show();
  }

  play(on) {
    if (on && this.state.frame >= this.data.frames - 1) this.state.frame = 0;
    if (!on) this.endRecording();
    this.before = null;
    this.change({ playing: on && this.data.frames > 1 });
  }

  scrub(frame) {
    this.play(false);
    this.change({ frame });
  }

  step(by) {
    const { frame } = this.state;
    const whole = by > 0 ? Math.floor(frame + 1e-6) + 1 : Math.ceil(frame - 1e-6) - 1;
    const count = this.data.frames;
    this.scrub(this.state.loop ? (whole + count) % count
      : Math.min(Math.max(whole, 0), count - 1));
  }

  view(key) {
    this.state.view = key;
    this.stage.lookFrom(this.stage.direction(), key);
    this.stage.showPath(this.state.picked, key);
    this.show();
  }

  /// Shows the path and the speed of a ball; null: of none.
  pick(ball) {
    this.state.picked = ball;
    this.stage.showPath(ball, this.state.view);
    this.show();
  }

  nextBall() {
    const { picked } = this.state;
    return this.data.count === 0 ? null : picked === null ? 0 : (picked + 1) % this.data.count;
  }

  look(direction) {
    this.stage.lookFrom(direction, this.state.view);
    this.want();
  }

  /// Rotates the camera by steps of 7.5 degrees.
  orbit(right, up) {
    this.stage.orbit((right * Math.PI) / 24, (up * Math.PI) / 24);
    this.want();
  }

  nearer(by) {
    this.stage.nearer(by);
    this.want();
  }

  /// While the component is not visible, nothing is drawn and the replay stands still.
  appear(seen) {
    this.seen = seen;
    this.before = null;
    this.want();
  }

  fit() {
    const { scene, written } = this.elements;
    const [width, height] = [scene.clientWidth, scene.clientHeight];
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const old = this.size;
    if (width === 0 || height === 0) return;
    if (old && width === old.width && height === old.height && ratio === old.ratio) return;
    this.size = { width, height, ratio };
    this.stage.resize(width, height, ratio);
    written.width = width * ratio;
    written.height = height * ratio;
    this.stage.lookFrom(old ? this.stage.direction() : "start", this.state.view);
    if (old) this.draw(); // immediately, because resizing clears the picture
    else this.want();
  }

  repaint() {
    this.theme = themeOf(this.root);
    this.stage.paint(this.theme);
    this.want();
  }

  /// Updates the elements to the state and requests a picture.
  show() {
    const view = this.views.find(({ key }) => key === this.state.view);
    this.elements.show({ ...this.state, caption: captionOf(this.data, view, this.clock, this.text) });
    this.want();
  }

  /// Requests one picture; repeated requests before it is drawn have no effect.
  want() {
    this.wanted ??= requestAnimationFrame((now) => {
      this.wanted = null;
      if (this.state.playing && (this.seen || this.state.recording)) this.advance(now);
      this.draw();
    });
  }

  advance(now) {
    const { state, data } = this;
    const passed = this.before === null ? 0 : (now - this.before) / 1000;
    this.before = now;
    const time = timeOf(data, state.frame) + Math.min(passed, 0.25) * state.factor;
    const over = time - data.times[data.frames - 1];
    if (over < 0) {
      state.frame = frameOf(data, time);
    } else if (state.loop && !state.recording) {
      state.frame = frameOf(data, data.times[0] + (over % this.duration()));
    } else {
      state.frame = data.frames - 1;
      this.draw();
      this.play(false);
      return;
    }
    this.want();
  }

  draw() {
    const { state, data, elements } = this;
    if (!this.size) return; // the component is hidden
    const time = this.clock(timeOf(data, state.frame));
    this.weight = this.stage.draw(this.shown.drawn(state));
    const { width, height, ratio } = this.size;
    const pen = elements.written.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    annotate(pen, width, height, this.annotations(this.theme, null));
    elements.showTime(state.frame, time);
    if (state.recording) this.compose(state.recording.canvas, this.theme);
    Object.assign(this.root.dataset, { state: "drawn", frame: Math.round(state.frame),
      view: state.view, colour: state.colour, playing: state.playing,
      picked: state.picked ?? "none", hits: this.shown.marks(state) });
  }

  annotations(theme, title) {
    const { state, data, weight } = this;
    const span = this.clock(this.duration());
    return { theme, title, time: this.clock(timeOf(data, state.frame)),
      factor: this.text.realTime(state.factor), words: this.text, weight,
      colour: state.colour, scale: this.shown.scale(state.colour),
      speciesNames: data.speciesNames, pixelsOfMetre: this.stage.pixelsOfMetre(this.size.height),
      hits: this.shown.hitLegend(state),
      picked: state.picked === null ? [] : linesOf(data, state.picked, state.frame, span, this.text) };
  }

  /// Picture and annotations on one canvas, at the current size of the picture.
  compose(canvas, theme) {
    const { scene } = this.elements;
    const { width, height } = this.size;
    if (canvas.width !== scene.width || canvas.height !== scene.height)
      Object.assign(canvas, { width: scene.width, height: scene.height });
    const pen = canvas.getContext("2d");
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.drawImage(scene, 0, 0);
    pen.setTransform(scene.width / width, 0, 0, scene.height / height, 0, 0);
    annotate(pen, width, height, this.annotations(theme, this.data.title));
    return canvas;
  }

  /// The picture at `ratio` pixels per CSS pixel, in the colours of `theme`.
  finely(canvas, ratio, theme) {
    const { width, height } = this.size;
    this.stage.paint(theme);
    this.stage.resize(width, height, ratio);
    this.stage.draw(this.shown.drawn(this.state));
    this.compose(canvas, theme);
    this.stage.paint(this.theme);
    this.stage.resize(width, height, this.size.ratio);
    this.draw();
    return canvas;
  }

  savePicture() {
    const canvas = this.finely(document.createElement("canvas"), 2, this.theme);
    const time = this.clock(timeOf(this.data, this.state.frame));
    savePicture(canvas, `${this.data.title} ${time}`);
  }

  print() {
    this.play(false);
    if (this.size) this.finely(this.elements.print, 2, printTheme);
  }

  /// Plays once from the beginning and saves it as a video.
  record() {
    const canvas = this.compose(document.createElement("canvas"), this.theme);
    const failed = (why) => this.change({ said: this.text.videoFailed(why) });
    this.play(false);
    this.state.frame = 0;
    try {
      this.state.recording = { canvas, film: film(canvas, this.data.title, this.text, failed) };
    } catch (error) {
      failed(error.message);
      return;
    }
    const seconds = Math.ceil(this.duration() / this.state.factor);
    this.state.said = this.text.recording(seconds);
    this.play(true);
  }

  endRecording() {
    this.state.recording?.film.stop();
    if (this.state.recording) Object.assign(this.state, { recording: null, said: "" });
  }
}

/// Mounts a replay of the data that the function `data` returns below `root`. If it cannot be shown,
/// `root` shows the reason instead, and the result is null. `text`: the words, an object of the shape of text/en.js.
export function mount(root, data, text = en) {
  try {
    return new Replay(root, data(), text);
  } catch (error) {
    const plain = error.name === "NoWebGL";
    root.dataset.state = plain ? "no-webgl" : "failed";
    root.dataset.error = error.message;
    apologize(root, plain ? text.noWebGL : faultIn(text, error));
    return null;
  }
}
