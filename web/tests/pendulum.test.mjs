// Room 1: numbers compared with the command's, the mouse and the keys, links that restore the state.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, enter, errors, PHONE, PROJECTOR, read, saved, settled, visit } from "./harness.mjs";

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

for (const angle of ["60deg", "179.99deg", "pi-1e-9", "180deg-1e-9deg", "2.5rad"]) {
  test(`the period from ${angle} is the command's`, () =>
    visit(`pendulum?angle=${encodeURIComponent(angle)}&length=57cm&t=0`, async (room) => {
      const { period_s, ratio } = answer("period", angle, "--length", "57cm").results[0];
      near(await fact(room, "Period T"), period_s);
      near(await fact(room, "T / T₀"), ratio);
    }));
}

/** Periods by mpmath, 4·√(l/g)·K(sin²(θ₀/2)) with l = 1 m and g = 9.80665 m/s². */
const [PERIOD_45_DEGREES, PERIOD_THREE_QUARTERS] = [2.08661217983495861704, 2.07930775334818431137];
/** The unit shown in a field for bare numbers. */
const unitOf = (room, label) => room.locator(".field", { has: room.getByLabel(label, { exact: true }) }).locator(".unit").textContent();

test("a number without a unit has the unit that stands in the field", () =>
  visit("pendulum?t=0", async (room) => {
    await enter(room, "Angle", "0.5rad");
    assert.equal(await unitOf(room, "Angle"), "");
    await enter(room, "Angle", "45");
    assert.equal(await unitOf(room, "Angle"), "°");
    near(await fact(room, "Period T"), PERIOD_45_DEGREES);
    assert.equal(await fact(room, "Amplitude θ₀"), "45°");
    assert.match(await stage(room).getAttribute("aria-valuetext"), /^45°: libration/);
    assert.match(await room.locator(".equivalents code").first().textContent(), /^libration motion 45deg /);
    assert.equal(await room.getByLabel("Angle", { exact: true }).evaluate((it) => document.getElementById(it.getAttribute("aria-describedby").split(" ")[0]).textContent), "°");
    for (const [label, entry, unit] of [["Angular velocity", "0", "rad/s"], ["Length", "1", "m"], ["Gravity", "9.80665", "m/s²"]]) {
      await enter(room, label, entry);
      assert.equal(await unitOf(room, label), unit);
      near(await fact(room, "Period T"), PERIOD_45_DEGREES);
    }
  }));

test("the unit switch decides of numbers that are entered, and changes no angle", () =>
  visit("pendulum?angle=45&t=0", async (room) => {
    near(await fact(room, "Period T"), PERIOD_45_DEGREES);
    await room.getByLabel("Angles in").selectOption("rad");
    await settled(room);
    near(await fact(room, "Period T"), PERIOD_45_DEGREES);
    assert.equal(await room.getByLabel("Angle", { exact: true }).inputValue(), String(Math.PI / 4));
    await enter(room, "Angle", "0.75");
    assert.equal(await unitOf(room, "Angle"), "rad");
    near(await fact(room, "Period T"), PERIOD_THREE_QUARTERS);
    await visit(new URL(room.url()).hash.slice(1), async (again) => near(await fact(again, "Period T"), PERIOD_THREE_QUARTERS));
  }));

test("a damped motion starts at the angle that is entered without a unit", () =>
  visit("pendulum?angle=45&damping=0.5&t=0", async (room) => {
    await room.waitForFunction(() => [...document.querySelectorAll("dt")].some((it) => it.textContent === "Angle"), null, { timeout: 60_000 });
    assert.equal(await fact(room, "Angle"), "45.00°");
    assert.match(await room.locator(".equivalents code").first().textContent(), /theta=45deg/);
  }));

test("graphs are said with the values of the motion, not with the ends of their axes", () =>
  visit("pendulum?angle=150deg&t=0", async (room) => {
    const graph = (title) => room.locator("figure", { has: room.locator("figcaption", { hasText: new RegExp(`^${title}$`) }) }).locator("canvas").getAttribute("aria-label");
    assert.match(await graph("Angle"), /from −150° to 150°$/);
    // 2·ω₀·sin 75° = 6.0497 rad/s.
    assert.match(await graph("Angular velocity"), /from −6.05 to 6.05 rad\/s$/);
    await enter(room, "Angle", "-30deg");
    assert.match(await graph("Angle"), /from −30° to 30°$/);
    await enter(room, "Angle", "0");
    await enter(room, "Angular velocity", "-7rad/s");
    // The energy: at the top the velocity is √(7² − 4·9.80665) = 3.1263 rad/s.
    assert.match(await graph("Angular velocity"), /from −7 to −3.126 rad\/s$/);
    await room.getByText("Damping and driving").click();
    await enter(room, "Angular velocity", "0");
    await enter(room, "Angle", "60deg");
    await enter(room, "Damping c in 1/s", "0.5");
    await room.waitForFunction(() => [...document.querySelectorAll(".plot canvas")].some((it) => it.getAttribute("aria-label")?.includes("period none")), null, { timeout: 60_000 });
    const { samples } = answer("simulate", "driven_pendulum", "--set", `omega0=${Math.sqrt(9.80665)},c=0.5`, "--initial", "theta=60deg", "--times", "0:2:0.01");
    const lowest = (180 / Math.PI) * Math.min(...samples.map(({ state }) => state[0]));
    const [, least, most] = /period none, from (\S+)° to (\S+)°$/.exec(await graph("Angle"));
    assert.equal(most, "60");
    assert.ok(Math.abs(read(least) - lowest) < 0.02, `${least} instead of ${lowest}`);
    assert.match(await graph("Energy"), /The total begins at 0\.250* of/);
    assert.match(await graph("Phase plane with separatrix"), /damped or driven$/);
  }));

test("the slider of the amplitude keeps the side of the start", () =>
  visit("pendulum?angle=-150deg&t=0", async (room) => {
    const slider = room.getByRole("slider", { name: "Amplitude" });
    assert.equal(await slider.getAttribute("aria-valuetext"), "−150°");
    assert.equal(await stage(room).getAttribute("aria-valuenow"), "-150");
    const angle = () => room.getByLabel("Angle", { exact: true }).inputValue();
    await slider.fill("120");
    assert.equal(await angle(), "-120");
    await slider.fill("0");
    assert.equal(await angle(), "0");
    await slider.fill("30");
    assert.equal(await angle(), "-30");
    assert.equal(await fact(room, "Angle"), "−30.00°");
    await enter(room, "Angle", "20deg");
    await slider.fill("10");
    assert.equal(await angle(), "10");
  }));

/** Takes the bob, and moves it to the right. */
async function take(room) {
  const { x, y, width, height } = await stage(room).boundingBox();
  await room.mouse.move(x + width / 2, y + height / 2 + 100);
  await room.mouse.down();
  await room.mouse.move(x + width / 2 + 80, y + height / 2 + 20);
}
/** Waits until the clock has gone beyond this time in seconds: on a loaded machine longer than in real time. */
const goesBeyond = (room, time) => room.waitForFunction((least) => Number.parseFloat(document.querySelector(".readout.time strong").textContent) > least, time);
const pointerCancelled = (room) => stage(room).evaluate((canvas) => canvas.dispatchEvent(new PointerEvent("pointercancel", { pointerId: 1 })));

test("a pendulum that is taken out of the hand goes on", () =>
  visit("pendulum?angle=150deg", async (room) => {
    const time = async () => read((await fact(room, "Time")).replace(" s", ""));
    await take(room);
    const held = await time();
    await room.waitForTimeout(200);
    assert.equal(await time(), held);
    await pointerCancelled(room);
    await goesBeyond(room, held + 0.1);
    assert.equal(await room.getByLabel("Angle", { exact: true }).inputValue(), "150");
    await room.mouse.up();
    assert.equal(await room.getByLabel("Angle", { exact: true }).inputValue(), "150");
    assert.equal(await room.getByRole("button", { name: "Pause" }).count(), 1);
    // A paused pendulum stays where it was, and can be taken again.
    await room.getByRole("button", { name: "Pause" }).click();
    const stood = await time();
    await take(room);
    await pointerCancelled(room);
    await room.mouse.up();
    await room.waitForTimeout(200);
    assert.equal(await time(), stood);
    await take(room);
    await room.waitForTimeout(150);
    await room.mouse.up();
    await room.waitForURL(/angle=\d/);
  }));

test("a finger that the system takes away leaves the pendulum moving", () =>
  visit("pendulum?angle=150deg", async (room) => {
    const session = await room.context().newCDPSession(room);
    const time = async () => read((await fact(room, "Time")).replace(" s", ""));
    await stage(room).scrollIntoViewIfNeeded();
    const { x, y, width, height } = await stage(room).boundingBox();
    const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
    await touch("touchStart", [{ x: x + width / 2, y: y + height / 2 + 60 }]);
    await touch("touchMove", [{ x: x + width / 2 + 50, y: y + height / 2 + 20 }]);
    await room.waitForTimeout(100);
    const held = await time();
    await touch("touchCancel", []);
    await goesBeyond(room, held + 0.1);
  }, { viewport: PHONE, hasTouch: true }));

test("each example is the pendulum that it names, without damping and driving", () =>
  visit("pendulum?angle=60deg&damping=0.5&drive=1.2&driveFrequency=0.5&length=2m&t=0", async (room) => {
    for (const name of ["Small: 5°", "Wide: 150°", "Exactly at the top", "Over the top"]) {
      await room.getByRole("button", { name, exact: true }).click();
      await settled(room);
      assert.match(await room.locator(".how").textContent(), /^Exact solution/, name);
      for (const [label, value] of [["Damping c in 1/s", "0"], ["Drive amplitude A in 1/s²", "0"], ["Drive frequency ω in rad/s", "2/3"], ["Length", "1"]]) assert.equal(await room.getByLabel(label, { exact: true }).inputValue(), value);
      await enter(room, "Damping c in 1/s", "0.3");
      assert.match(await room.locator(".how").textContent(), /integrated/);
    }
  }));

test("the planet is that whose gravity is entered", () =>
  visit("pendulum?angle=60deg&t=0", async (room) => {
    const planet = room.getByLabel("Gravity of", { exact: true });
    const named = () => planet.evaluate((it) => it.selectedOptions[0].textContent);
    assert.equal(await named(), "the Earth");
    await planet.selectOption("Mars");
    await settled(room);
    assert.equal(await room.getByLabel("Gravity", { exact: true }).inputValue(), "3.71");
    await enter(room, "Gravity", "9.81m/s^2");
    assert.equal(await named(), "as typed");
    await enter(room, "Gravity", "1.62");
    assert.equal(await named(), "the Moon");
    await enter(room, "Gravity", "heavy");
    assert.equal(await named(), "as typed");
    await room.getByRole("button", { name: "Small: 5°" }).click();
    await settled(room);
    assert.equal(await named(), "the Earth");
  }));

test("it moves in real time, stands, steps, and goes back", () =>
  visit("pendulum?angle=150deg", async (room) => {
    const time = async () => read((await fact(room, "Time")).replace(" s", ""));
    const before = await time();
    await goesBeyond(room, before + 0.3);
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
    await goesBeyond(room, 0.2);
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
      ["Angle", "179.99degg", /cannot read “179.99degg” as an angle: write 60deg, 1.2rad, pi-1e-6/],
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
    await room.getByLabel("Approximate period", { exact: true }).focus();
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
