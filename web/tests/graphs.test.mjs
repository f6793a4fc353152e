// The graphs of room 1: the phase plane that starts motions, the free graph, intervals of time that move.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, PHONE, settled, visit } from "./harness.mjs";

after(close);

const figure = (room, title) => room.locator("figure", { has: room.locator("figcaption", { hasText: new RegExp(`^${title}`) }) }).locator("canvas");
/** The margins of a graph, in px at the usual letters. */
const [LEFT, RIGHT, TOP, BOTTOM] = [60, 18, 8, 36];

/** The state at a point of the phase plane, for a motion below the separatrix: its axes end at ±180° and ±1.12·2·√(g/l). */
function stateAt(x, y, { width, height }) {
  const most = 1.12 * 2 * Math.sqrt(9.80665);
  return { angle: (360 * (x - LEFT)) / (width - LEFT - RIGHT) - 180, velocity: most * (1 - (2 * (y - TOP)) / (height - TOP - BOTTOM)) };
}

for (const [name, options] of [["the mouse", {}], ["a finger", { viewport: PHONE, hasTouch: true }]]) {
  test(`a point of the phase plane starts the motion there, by ${name}`, () =>
    visit("pendulum?angle=60deg&t=0", async (room) => {
      const plane = figure(room, "Phase plane");
      const box = await plane.boundingBox();
      const [x, y] = [LEFT + 0.7 * (box.width - LEFT - RIGHT), 50];
      // Scrolls there and presses at once, before the browser has said that the plane is in sight.
      await plane[options.hasTouch ? "tap" : "click"]({ position: { x, y } });
      await room.waitForURL(/velocity=/);
      const values = new URLSearchParams(new URL(room.url()).hash.split("?")[1]);
      const { angle, velocity } = stateAt(x, y, box);
      assert.ok(Math.abs(parseFloat(values.get("angle")) - angle) < 1.2, `${values} for ${angle}`);
      assert.ok(Math.abs(parseFloat(values.get("velocity")) - velocity) < 0.08, `${values} for ${velocity}`);
    }, options));
}

test("any quantity is drawn against any other, and a link shows it again", () =>
  visit("pendulum?angle=60deg&t=0", async (room) => {
    const free = figure(room, "Any quantity");
    assert.equal(await free.getAttribute("aria-label"), "potential energy / 2mgl against θ");
    await room.getByLabel("Across", { exact: true }).selectOption("θ′ in rad/s");
    await room.getByLabel("Up", { exact: true }).selectOption("kinetic energy / 2mgl");
    await settled(room);
    assert.equal(await free.getAttribute("aria-label"), "kinetic energy / 2mgl against θ′ in rad/s");
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.equal(await figure(again, "Any quantity").getAttribute("aria-label"), "kinetic energy / 2mgl against θ′ in rad/s"));
  }));

test("from four fifths of the interval on the graph moves under its mark, instead of jumping", async () => {
  const { period_s: period } = answer("period", "60deg").results[0];
  for (const periods of [3, 4, 7]) {
    await visit(`pendulum?angle=60deg&t=${periods * period}`, async (room) => {
      const graph = figure(room, "Angle$");
      await graph.scrollIntoViewIfNeeded();
      await room.waitForTimeout(300);
      const marked = await graph.evaluate((canvas, [left, right]) => {
        const scale = canvas.width / canvas.clientWidth;
        const column = Math.round(scale * (left + 0.8 * (canvas.clientWidth - left - right)));
        const { data } = canvas.getContext("2d").getImageData(column, 0, 1, canvas.height);
        let count = 0;
        for (let at = 0; at < data.length; at += 4) if (data[at + 2] - data[at] > 80) count += 1;
        return count;
      }, [LEFT, RIGHT]);
      // At the turning point the curve alone is about 2 px high, the mark 10 px.
      assert.ok(marked >= 8, `${marked} px after ${periods} periods`);
    });
  }
});
