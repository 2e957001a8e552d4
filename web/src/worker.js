// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Code of a worker: holds one engine. Messages {id, method, values} call a method of the engine and are
// answered with {id, result} or {id, error}. {compute} computes a replicate step by step and posts
// {event: "progress" | "picture" | "ended"}; {pause}, {resume} and {stop} steer it.

import { load } from "./engine.js";

const step = 40; // ms of one call of advance
const pictureShare = 0.06; // of the time may be spent on pictures

let engine = null;
let running = null;

// A message to itself lets other messages in between two steps, without the delay of timers.
const channel = new MessageChannel();
channel.port1.onmessage = () => running && !running.paused && advance();
const again = () => channel.port2.postMessage(0);

function picture({ film }) {
  const start = performance.now();
  const shown = { event: "picture", summary: engine.summary(),
    spectrum: engine.table("spectrum"), timeseries: engine.table("timeseries"),
    film: film ? engine.film() : null };
  postMessage(shown);
  return performance.now() - start;
}

function advance() {
  try {
    const progress = engine.advance(step);
    const now = performance.now();
    if (running.pictures && now > running.next && !progress.done) {
      const took = picture(running);
      running.period = Math.min(Math.max(running.period * 1.3, took / pictureShare), 3000);
      running.next = now + running.period;
    }
    if (progress.done) return end(progress);
    if (now > running.said + 80) {
      running.said = now;
      postMessage({ event: "progress", ...progress });
    }
    again();
  } catch (error) {
    running = null;
    postMessage({ event: "failed", message: String(error?.message ?? error) });
  }
}

function end(progress) {
  if (running.pictures) picture(running);
  running = null;
  const state = engine.state();
  postMessage({ event: "ended", ...progress, state });
}

function stop() {
  if (!running) return;
  end(engine.advance(0));
}

function compute({ toml, set, replicate, pictures, film }) {
  const checked = engine.open(toml, set, replicate);
  if (checked.faults.length > 0)
    return postMessage({ event: "failed", message: checked.faults[0].text });
  running = { pictures, film, paused: false, said: 0, period: 150, next: performance.now() + 150 };
  again();
}

async function call({ id, method, values }) {
  try {
    if (method === "load") {
      engine = await load(...values);
      return postMessage({ id, result: { version: engine.version } });
    }
    postMessage({ id, result: engine[method](...values) });
  } catch (error) {
    postMessage({ id, error: String(error?.message ?? error) });
  }
}

const orders = {
  compute,
  pause: () => running && (running.paused = true),
  resume: () => {
    if (running?.paused) {
      running.paused = false;
      again();
    }
  },
  stop,
};

onmessage = ({ data }) => {
  if (data.method) return call(data);
  try {
    orders[data.order](data);
  } catch (error) {
    running = null;
    postMessage({ event: "failed", message: String(error?.message ?? error) });
  }
};
