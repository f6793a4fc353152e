// Every room of questions on a phone, a desk and a projector, light and dark: nothing sticks out, axe finds nothing, and keys reach everything.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, test } from "node:test";
import { close, DESK, PHONE, PROJECTOR, visit } from "./harness.mjs";

after(close);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const ROOMS = ["pendulum?angle=150deg&small-angle=yes", "about", "formulas", "perturbation", "derivations?steps=all&amplitude=40deg", "derivations?road=paper", "laboratory?example=yes&length=0.56m", "chaos?over=A%3D1:1.5:0.05&points=300"];

for (const fragment of ROOMS) {
  for (const [viewport, colorScheme] of [[PHONE, "light"], [DESK, "dark"], [DESK, "light"], [PROJECTOR, "dark"]]) {
    test(`${fragment} at ${viewport.width} px, ${colorScheme}`, () =>
      visit(fragment, async (room) => {
        assert.equal(await room.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, "the page scrolls sideways");
        await room.evaluate(axe);
        const { violations } = await room.evaluate(() => axe.run());
        // Axe does not read formulas: a heading that is one seems empty to it.
        const found = violations.flatMap(({ id, nodes }) => nodes.filter(({ html }) => !(id === "empty-table-header" && html.includes("<math"))).map(({ html }) => `${id}: ${html.slice(0, 160)}`));
        assert.deepEqual(found, []);
      }, { viewport, colorScheme, bypassCSP: true }));
  }

  test(`${fragment}: each control is reached by the Tab key, and shows that it is`, () =>
    visit(fragment, async (room) => {
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
    }));
}

test("what moves by itself stands still where the reader wants that", () =>
  visit("chaos?over=&points=300&set=c%3D1/2,A%3D1.5&value=", async (room) => {
    assert.equal(await room.evaluate(() => document.getAnimations().length), 0);
  }, { reducedMotion: "reduce" }));

test("on paper there are results, and nothing to press", () =>
  visit("formulas", async (room) => {
    await room.emulateMedia({ media: "print" });
    assert.equal(await room.locator("main button:visible, main input:visible").count(), 0);
    assert.ok(await room.locator("main table").first().isVisible());
  }));
