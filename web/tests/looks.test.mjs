// Every room of questions on a phone, a desk and a projector, light and dark: nothing sticks out, axe finds nothing, and keys reach everything.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { after, test } from "node:test";
import { close, DESK, page, PHONE, PROJECTOR, visit } from "./harness.mjs";

after(close);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const SOON = "points=300&intervals=20&until=10";
const ROOMS = ["pendulum?angle=150deg&small-angle=yes", "pendulum?view=learn&arrows=yes&gate=yes&stopwatch=yes&ruler=yes&protractor=yes&second=yes&secret=planet-1&trials=10:1:10:20.1", "pendulum?view=lecture&hide=yes", "embed?t=0", "about", "formulas", "perturbation", "derivations?steps=all&amplitude=40deg", "derivations?road=paper", "laboratory?example=yes&length=0.56m", `chaos?over=A%3D1:1.5:0.05&each=10&motions=200&${SOON}`, `chaos?system=kapitza&set=c%3D0.1&initial=theta%3D170deg&over=&value=&map=omega%3D5:30,a%3D0.02:0.6&rest=theta%3D180deg&lines=0&thresholds=a%3D0.01:0.6&${SOON}`, `chaos?system=spring_pendulum&set=kappa%3D3&initial=r%3D1.3733,theta%3D0.04&over=&value=&at=theta&order=3&${SOON}`];

/** Nothing sticks out, and axe finds nothing. */
async function check(room, what) {
  assert.equal(await room.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, `${what}: the page scrolls sideways`);
  const { violations } = await room.evaluate(() => axe.run());
  // Axe does not read formulas: a heading that is one seems empty to it. A room that is scrolled out of sight seems a skip link to it.
  const isKnown = (id, html) => (id === "empty-table-header" && html.includes("<math")) || (id === "skip-link" && !html.includes('class="skip"'));
  const found = violations.flatMap(({ id, nodes }) => nodes.filter(({ html }) => !isKnown(id, html)).map(({ html }) => `${id}: ${html.slice(0, 160)}`));
  assert.deepEqual(found, [], what);
}

/** Each control is reached by the Tab key, and shows that it is. */
async function tab(room) {
  const wanted = await room.evaluate(() => {
    const all = [...document.querySelectorAll("main :is(input, select, textarea, button, summary, [tabindex='0'])")];
    const visible = all.filter((it) => it.checkVisibility() && !it.disabled && it.closest("details:not([open])")?.querySelector("summary") !== it.closest("details:not([open])") && (it.localName === "summary" || it.closest("details:not([open])") === null));
    visible.forEach((it, place) => (it.dataset.place = String(place)));
    return visible.length;
  });
  const reached = new Set();
  await room.locator("main").evaluate((it) => it.focus());
  for (let press = 0; press < wanted + 400 && reached.size < wanted; press += 1) {
    await room.keyboard.press("Tab");
    const [place, outline] = await room.evaluate(() => [document.activeElement?.dataset.place, getComputedStyle(document.activeElement).outlineStyle]);
    if (place === undefined) continue;
    assert.notEqual(outline, "none");
    reached.add(place);
  }
  assert.equal(reached.size, wanted);
}

for (const fragment of ROOMS) {
  test(`${fragment} on a phone`, () =>
    visit(fragment, async (room) => {
      await room.evaluate(axe);
      await check(room, "phone");
    }, { viewport: PHONE, bypassCSP: true }));

  test(`${fragment} at a desk, on a projector in the dark, and by the Tab key`, () =>
    visit(fragment, async (room) => {
      await room.evaluate(axe);
      for (const [viewport, colorScheme] of [[DESK, "light"], [PROJECTOR, "dark"]]) {
        await room.setViewportSize(viewport);
        await room.emulateMedia({ colorScheme });
        await room.waitForTimeout(200);
        await check(room, `${viewport.width} px, ${colorScheme}`);
      }
      await tab(room);
    }, { viewport: DESK, bypassCSP: true }));
}

test("the page has at most three megabytes", () => {
  const { size } = statSync(page);
  assert.ok(size <= 3e6, `${size} bytes`);
});

test("the works in the page are named, with the texts of their licences", () =>
  visit("about", async (room) => {
    await room.getByText("the texts of their licences").click();
    const list = room.locator("pre.licences");
    await list.filter({ hasText: "STIX Two Math (OFL-1.1)" }).waitFor();
    const all = await list.textContent();
    const named = /library, (.*) among them/.exec(await room.textContent("main"))[1].split(/, | and /).map((name) => name.replace("dashu", "dashu-int"));
    assert.ok(named.length > 5, named.join());
    for (const name of named) assert.match(all, new RegExp(`^${name} \\d+\\.\\S+ \\((MIT|Apache-2.0)`, "m"));
    for (const text of [/Permission is hereby granted, free of charge/, /TERMS AND CONDITIONS FOR USE, REPRODUCTION, AND DISTRIBUTION/, /SIL OPEN FONT LICENSE/]) assert.match(all, text);
  }));

test("what moves by itself stands still where the reader wants that", () =>
  visit(`chaos?over=&set=c%3D1/2,A%3D1.5&value=&${SOON}`, async (room) => {
    assert.equal(await room.evaluate(() => document.getAnimations().length), 0);
  }, { reducedMotion: "reduce" }));

test("on paper there are results, and nothing to press", () =>
  visit("formulas", async (room) => {
    await room.emulateMedia({ media: "print" });
    // A term, which explains itself on the screen, is a word of its sentence there.
    assert.equal(await room.locator("main button:not(.term):visible, main input:visible").count(), 0);
    assert.ok(await room.locator("main table").first().isVisible());
  }));
