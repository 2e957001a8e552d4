// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the lessons and of the choice of a language.

import { existsSync, readFileSync } from "node:fs";
import { execFile } from "node:child_process";
import { promisify } from "node:util";
import { lessons } from "../src/learn/lessons.js";
import { languages } from "../src/text/text.js";
import { expect, Skip } from "./check.js";
import { caseText, ended, limit, writeCase } from "./steps.js";
import { cutOff, laidOut, seriousFindings } from "./test_outside.js";

const call = promisify(execFile);
const { en, de } = languages;

/// Opens a lesson by its link and waits for the end of the run that this starts.
async function openLesson(page, url, number, query = "") {
  await page.goto(`${url}${query}#lesson=${number}`);
  await ended(page);
}

async function a_lesson_explains_each_answer_and_keeps_the_right_one({ page, url }) {
  await openLesson(page, url, 2);
  expect("its title", await page.textContent(".lesson h3"), en.lessons[1].title);
  expect("its case", (await caseText(page)).includes("lifter-cylinder"));
  for (const [i, [, why]] of en.lessons[1].answers.entries()) {
    await page.locator(".question input").nth(i).check();
    const said = (await page.textContent(".feedback")).replaceAll("\u00a0", " ");
    expect(`the answer ${i}`, said, `${i === lessons[1].right ? en.lessonRight : en.lessonWrong} ${why}`);
  }
  expect("answered", await page.locator(".lesson-list .done").count(), 1);
  await page.click(".lesson-list li:nth-child(4) button");
  await page.waitForFunction((title) => document.querySelector(".lesson h3")?.textContent === title, en.lessons[3].title);
  expect("the address", new URL(page.url()).hash, "#lesson=4");
  await page.reload();
  await page.waitForSelector(".lesson h3");
  expect("kept", await page.locator(".lesson-list .done").count(), 1);
  await page.click("#learn");
  expect("closed", await page.locator(".learn").isVisible(), false);
}

async function a_lesson_computes_its_cases({ page, url }) {
  await openLesson(page, url, 3);
  await page.click(".chips button >> nth=1");
  await page.waitForFunction(() => document.querySelector("#case-text").value.includes("count = 24"));
  await page.click(".lesson-check .primary");
  await page.waitForSelector(".conclusion:not([hidden])", { timeout: limit });
  expect("numbers with intervals", (await page.locator(".lesson-check td").allTextContents())
    .map((told) => told.includes("±")), Array.from({ length: 6 }, () => true));
}

async function lessons_need_no_storage({ page, url }) {
  await page.addInitScript(() => Object.defineProperty(window, "localStorage",
    { get: () => { throw new DOMException("denied", "SecurityError"); } }));
  await openLesson(page, url, 1);
  await page.locator(".question input").nth(lessons[0].right).check();
  expect("answered", await page.locator(".lesson-list .done").count(), 1);
  await page.click('#language [data-key="de"]');
  await page.waitForSelector('html[lang="de"]');
  expect("the language is in the address", new URL(page.url()).search, "?lang=de");
}

async function another_language_keeps_the_case({ page, url }) {
  await page.goto(url);
  await ended(page);
  const changed = `${await caseText(page)}# mine\n`;
  await writeCase(page, changed);
  await page.click('#language [data-key="zh"]');
  await page.waitForSelector('html[lang="zh"] body[data-case="fine"]');
  expect("the case", await caseText(page), changed);
  expect("a word", await page.textContent("#run"), languages.zh.run);
  await page.goto(`${url}?lang=de`);
  await page.waitForSelector('html[lang="de"] #run');
  expect("the language of the address comes first", await page.textContent("#run"), de.run);
}

async function lessons_fit_and_are_accessible_in_each_language({ page, url }) {
  for (const language of Object.keys(languages)) {
    await openLesson(page, url, 5, `?lang=${language}`);
    await page.locator(".question input").first().check();
    expect(`findings in ${language}`, await seriousFindings(page), []);
    for (const width of [320, 420, 1280]) {
      await page.setViewportSize({ width, height: 800 });
      for (const region of width < 900 ? ["case", "result"] : [""]) {
        if (region) await page.click(`.regions [data-key="${region}"]`);
        await page.evaluate(laidOut);
        expect(`overflow at ${width} in ${language}`,
          await page.evaluate(() => document.documentElement.scrollWidth - innerWidth) <= 0);
        expect(`beyond the edge at ${width} in ${language}`, await page.evaluate(cutOff), []);
      }
    }
  }
}

/// The program computes the cases of each lesson: their numbers say what the lesson says.
async function what_lessons_say_is_true({ native, folder }) {
  if (!native || !existsSync(native)) throw new Skip("no program is named by --native");
  for (const { name, points, holds } of lessons) {
    const found = [];
    for (const [i, { set }] of points.entries()) {
      const out = `${folder}/${name}-${i}`;
      const path = new URL(`../lessons/${name}.toml`, import.meta.url).pathname;
      await call(native, ["run", path, "--out", out, "--quiet", ...set.flatMap(([key, value]) => ["--set", `${key}=${value}`])]);
      found.push(JSON.parse(readFileSync(`${out}/summary.json`, "utf8")));
    }
    expect(`what the lesson "${name}" says`, holds(found));
  }
}

export const lessonTests = [a_lesson_explains_each_answer_and_keeps_the_right_one, a_lesson_computes_its_cases,
  lessons_need_no_storage, another_language_keeps_the_case, lessons_fit_and_are_accessible_in_each_language,
  what_lessons_say_is_true];
