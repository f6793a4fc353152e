// The first room: numbers beside the command's, the mouse and the keys, links that show the same again.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, errors, PHONE, PROJECTOR, read, saved, settled, visit } from "./harness.mjs";

after(close);

/** A fact of the motion by its name. */
async function fact(room, name) {
  const entry = room.locator("dt", { hasText: new RegExp(`^${name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}$`) }).first();
  return entry.locator("xpath=following-sibling::dd[1]").textContent();
}
const stage = (room) => room.getByRole("slider", { name: /Angle of release/ });

/** Twelve digits are shown. */
function near(shown, exact) {
  assert.ok(Math.abs(read(shown.replace(/ (s|rad).*/, "")) / exact - 1) < 1e-11, `${shown} instead of ${exact}`);
}

for (const angle of ["60deg", "179.99deg", "pi-1e-9", "180deg-1e-9deg", "2.5"]) {
  test(`the period from ${angle} is the command's`, () =>
    visit(`pendulum?angle=${encodeURIComponent(angle)}&length=57cm&t=0`, async (room) => {
      const { period_s, ratio } = answer("period", angle, "--length", "57cm").results[0];
      near(await fact(room, "Period T"), period_s);
      near(await fact(room, "T / T₀"), ratio);
    }));
}

test("it moves in real time, stands, steps, and goes back", () =>
  visit("pendulum?angle=150deg", async (room) => {
    const time = async () => read((await fact(room, "Time")).replace(" s", ""));
    const before = await time();
    await room.waitForTimeout(700);
    assert.ok((await time()) > before + 0.3);
    await room.getByRole("button", { name: "Pause" }).click();
    const stands = await time();
    await room.waitForTimeout(200);
    assert.equal(await time(), stands);
    await room.getByRole("button", { name: "Step forward" }).click();
    assert.ok(Math.abs((await time()) - stands - 1 / 60) < 0.011);
    await room.getByRole("button", { name: "To the start" }).click();
    assert.equal(await time(), 0);
  }));

test("a link shows the same moment, with the angle of the command", () =>
  visit("pendulum?angle=150deg&t=1.5", async (room) => {
    const sample = answer("motion", "150deg", "--times", "1.5").samples[0];
    const shown = read(await fact(room, "Angle"));
    assert.ok(Math.abs(shown - (180 / Math.PI) * sample.angle_in_turn_rad) < 0.006, `${shown}`);
    assert.equal(await room.getByRole("button", { name: "Run", exact: true }).count(), 1);
  }));

test("with keys only: turned, run, stopped, stepped", () =>
  visit("pendulum?angle=60deg&t=0", async (room) => {
    await stage(room).focus();
    await room.keyboard.press("ArrowRight");
    await room.keyboard.press("PageUp");
    await room.waitForURL(/angle=71deg/);
    assert.equal(await stage(room).getAttribute("aria-valuenow"), "71");
    await room.keyboard.press(".");
    await room.waitForURL(/t=0\.016667/);
    await room.keyboard.press("Space");
    await room.waitForTimeout(300);
    await room.keyboard.press("Space");
    await room.waitForURL((url) => Number(new URLSearchParams(url.hash.split("?")[1]).get("t")) > 0.1);
    await room.keyboard.press("Home");
    await room.waitForURL(/t=0$/);
  }, { viewport: PHONE }));

test("with the mouse: dragged, let go exactly at the top, thrown", () =>
  visit("pendulum?angle=20deg&t=0", async (room) => {
    const box = await stage(room).boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await room.mouse.move(x, y + 100);
    await room.mouse.down();
    await room.mouse.move(x + 100, y, { steps: 5 });
    await room.waitForTimeout(150);
    await room.mouse.up();
    await room.waitForURL(/angle=90deg|angle=90.0deg/);
    await room.mouse.move(x + 100, y);
    await room.mouse.down();
    await room.mouse.move(x, y - 100, { steps: 5 });
    await room.waitForTimeout(150);
    await room.mouse.up();
    await room.waitForURL(/angle=180deg/);
    assert.match(await fact(room, "Regime"), /upright/);
    await room.mouse.move(x, y + 100);
    await room.mouse.down();
    for (const step of [1, 2, 3, 4, 5]) await room.mouse.move(x + 20 * step, y + 100);
    await room.mouse.up();
    await room.waitForURL(/velocity=\d/);
  }, { viewport: PROJECTOR }));

test("wrong entries are answered beside their fields, in the library's words", () =>
  visit("pendulum?t=0", async (room) => {
    for (const [label, value, words] of [
      ["Angle", "179.99degg", /cannot read `179.99degg` as an angle/],
      ["Angle", "9".repeat(5000), /angle|number|long/],
      ["Angular velocity", "fast", /fast/],
      ["Length", "-1m", /length/],
      ["Gravity", "9.81 kg", /kg/],
    ]) {
      const field = room.getByLabel(label, { exact: true });
      const before = await field.inputValue();
      await field.fill(value);
      await settled(room);
      assert.match((await errors(room)).join(" "), words);
      assert.equal(await field.getAttribute("aria-invalid"), "true");
      await field.fill(before);
      await settled(room);
      assert.deepEqual((await errors(room)).filter((it) => it !== ""), []);
    }
  }));

test("with damping it is integrated, and says so", () =>
  visit("pendulum?angle=60deg&damping=0.5&t=4", async (room) => {
    assert.match(await room.locator(".how").textContent(), /integrated/);
    await room.waitForFunction(() => [...document.querySelectorAll("dt")].some((it) => it.textContent === "Angle"), null, { timeout: 60_000 });
    const { samples } = answer("simulate", "driven_pendulum", "--set", `omega0=${Math.sqrt(9.80665)},c=0.5`, "--initial", "theta=60deg", "--times", "4");
    const shown = read(await fact(room, "Angle"));
    assert.ok(Math.abs(shown - (180 / Math.PI) * samples[0].state[0]) < 0.006, `${shown}`);
  }));

test("ghosts, the formulas' list, the picture and the numbers come from the command", () =>
  visit("pendulum?angle=90deg&t=1&small-angle=yes&fourier-3=yes", async (room) => {
    await room.getByLabel("The period of a formula", { exact: true }).focus();
    await room.waitForFunction(() => document.querySelectorAll("option[value=molina]").length === 1, null, { timeout: 60_000 });
    await room.getByRole("button", { name: "Draw the picture" }).click();
    await room.waitForFunction(() => document.querySelector(".picture")?.shadowRoot?.querySelector("svg") != null, null, { timeout: 60_000 });
    const { name, bytes } = await saved(room, "Save the numbers as CSV");
    assert.equal(name, "motion.csv");
    assert.match(bytes.toString(), /^time_s,angle_rad/);
    assert.equal(bytes.toString().trim().split("\n").length, 1002);
  }));

test("it does not grow while it swings", (watched) =>
  visit("pendulum?angle=170deg&speed=20", async (room) => {
    const session = await room.context().newCDPSession(room);
    const used = async () => {
      await session.send("HeapProfiler.collectGarbage");
      return (await session.send("Runtime.getHeapUsage")).usedSize;
    };
    const seconds = Number(process.env.SWING_SECONDS ?? 10);
    await room.waitForTimeout(3000);
    const before = await used();
    await room.waitForTimeout(1000 * seconds);
    const more = (await used()) - before;
    watched.diagnostic(`${more} bytes more after ${seconds} s`);
    assert.ok(more < 2e6, `${more} bytes more after ${seconds} s`);
  }));
