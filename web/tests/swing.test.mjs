// The pendulum of the Python package in a notebook: what its script draws of a course, in a page with a model as notebooks have it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { answer, close, open } from "./harness.mjs";

after(close);

const file = fileURLToPath(new URL("../../python/libration/swing.js", import.meta.url));
const script = readFileSync(file, "utf8");
const { angleAt, rateOf, smallAngleAt } = await import(`data:text/javascript,${encodeURIComponent(script)}`);

/** A course as `swing.py` makes it, from what the command says of a motion. */
function course(words, span, steps, repeats) {
  const times = Array.from({ length: steps + 1 }, (_, n) => (span * n) / steps);
  const { samples, length_m, gravity_m_per_s2 } = answer("motion", ...words, "--times", times.join(","));
  const angles = samples.map((it) => it.angle_rad);
  const velocities = samples.map((it) => it.velocity_rad_per_s);
  const advance = repeats ? angles.at(-1) - angles[0] : 0;
  return { span, angles, velocities, repeats, advance, small_angle_period: 2 * Math.PI * Math.sqrt(length_m / gravity_m_per_s2) };
}

for (const words of [["150deg"], ["0", "--velocity", "9rad/s"], ["0", "--velocity=-9rad/s"]]) {
  test(`between the samples of ${words.join(" ")} are the command's angles, in later periods too`, () => {
    const { period_s } = answer("motion", ...words);
    const drawn = course(words, period_s, 128, true);
    const times = [0, 0.1, 0.77, 1.31, 2.5, 6.02];
    const { samples } = answer("motion", ...words, "--times", times.join(","));
    samples.forEach((it, n) => assert.ok(Math.abs(angleAt(drawn, times[n]) - it.angle_rad) < 1e-5, `${times[n]} s`));
    const slow = { ...drawn, repeats: false };
    assert.equal(angleAt(slow, 10 * period_s), drawn.angles.at(-1));
  });
}

test("small swings are the cosine of the small-angle period", () => {
  const drawn = { angles: [0.3], velocities: [0.5], small_angle_period: 2 };
  assert.equal(smallAngleAt(drawn, 0), 0.3);
  assert.ok(Math.abs(smallAngleAt(drawn, 0.5) - 0.5 / Math.PI) < 1e-15);
});

test("motions that are too fast or too slow to be watched are shown at a round rate", () => {
  const rate = (span) => rateOf({ repeats: true, span });
  assert.deepEqual([0.5, 2, 10].map(rate), [1, 1, 1]);
  assert.deepEqual([0.3, 3e-3, 30, 600].map(rate), [0.1, 1e-3, 10, 200]);
});

/** A page with a pendulum from 150°, and what its model was told. */
function shown(use, options) {
  const { period_s } = answer("motion", "150deg");
  const state = { angle: 150, velocity: 0, caption: "libration of 150°", _course: course(["150deg"], period_s, 256, true) };
  return open(async (page) => {
    await page.evaluate(
      async ([script, state]) => {
        const listeners = {};
        const model = {
          told: [],
          get: (name) => state[name],
          set: (name, value) => {
            state[name] = value;
            model.told.push([name, value]);
          },
          save_changes: () => model.told.push("saved"),
          on: (event, listener) => (listeners[event] ??= new Set()).add(listener),
          off: (event, listener) => listeners[event].delete(listener),
          change: (name, value) => {
            state[name] = value;
            listeners[`change:${name}`].forEach((listener) => listener());
          },
          listeners,
        };
        const { default: widget } = await import(`data:text/javascript,${encodeURIComponent(script)}`);
        const el = document.createElement("div");
        document.body.append(el);
        Object.assign(window, { model, leave: widget.render({ model, el }) });
      },
      [script, state],
    );
    await use(page, state._course);
  }, options);
}

const turned = (page, name) =>
  page.locator(`.libration-swing g.${name}`).evaluate((arm) => -Number(/rotate\((.*)\)/.exec(arm.getAttribute("transform"))[1]));

test("it swings, stands when it is told, and begins again", () =>
  shown(async (page) => {
    await page.waitForTimeout(500);
    await page.getByRole("button", { name: "Pause" }).click();
    const stands = await turned(page, "exact");
    assert.ok(stands < 149, `${stands}`);
    await page.waitForTimeout(200);
    assert.equal(await turned(page, "exact"), stands);
    await page.getByRole("button", { name: "From the start" }).click();
    assert.ok(Math.abs((await turned(page, "exact")) - 150) < 1e-3);
    assert.ok(Math.abs((await turned(page, "small")) - 150) < 1e-3);
    assert.equal(await page.locator(".caption").textContent(), "libration of 150°");
  }));

test("sliders and the bob set the start, and a new course is drawn", () =>
  shown(async (page, course) => {
    await page.getByRole("button", { name: "Pause" }).click();
    await page.getByLabel("angle").fill("-30");
    assert.deepEqual(await page.evaluate("model.told"), [["angle", -30], "saved"]);
    await page.evaluate("model.told = []");
    const bob = await page.locator("g.exact circle").boundingBox();
    const frame = await page.locator("svg").boundingBox();
    await page.mouse.move(bob.x + bob.width / 2, bob.y + bob.height / 2);
    await page.mouse.down();
    // Level with the pivot, on its right.
    await page.mouse.move(frame.x + (225 * frame.width) / 660, frame.y + (130 * frame.width) / 660);
    await page.mouse.up();
    assert.deepEqual(await page.evaluate("model.told"), [["angle", 90], ["velocity", 0], "saved"]);
    const before = await page.locator("path.exact").getAttribute("d");
    const other = { ...course, angles: course.angles.map((it) => it / 2), velocities: course.velocities.map((it) => it / 2) };
    await page.evaluate((other) => model.change("_course", other), other);
    assert.ok(Math.abs((await turned(page, "exact")) - 75) < 1e-3);
    assert.deepEqual(await page.locator(".labels text").allTextContents(), ["75°", "−75°", "0", "7.07 s"]);
    assert.ok(before.startsWith("M320.0 "));
  }));

test("for a reader who wants no motion it stands until it is told to run", () =>
  shown(
    async (page) => {
      await page.waitForTimeout(150);
      assert.ok(Math.abs((await turned(page, "exact")) - 150) < 1e-3);
      await page.getByRole("button", { name: "Run" }).click();
      await page.waitForTimeout(500);
      assert.ok((await turned(page, "exact")) < 149);
    },
    { reducedMotion: "reduce" },
  ));

test("nothing goes on when it leaves the notebook", () =>
  shown(async (page) => {
    await page.evaluate("leave()");
    assert.deepEqual(await page.evaluate("Object.values(model.listeners).map((it) => it.size)"), [0, 0, 0]);
    await page.waitForTimeout(100);
    const stands = await turned(page, "exact");
    await page.waitForTimeout(150);
    assert.equal(await turned(page, "exact"), stands);
  }));
