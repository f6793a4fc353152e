// The first screen of room 1: one screen at four sizes, readouts compared with the command's numbers, instruments.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { answer, close, enter, open, page, read, settled, visit } from "./harness.mjs";

after(close);

const SIZES = [[1280, 800], [1920, 1080], [1024, 768], [390, 844]].map(([width, height]) => ({ width, height }));
/** A readout by its name. */
const readout = (room, name) => room.locator(".readout", { hasText: name }).locator("strong").textContent();
const stage = (room) => room.getByRole("slider", { name: /Angle of release/ });

for (const viewport of SIZES) {
  test(`everything that is needed first is on the screen of ${viewport.width} × ${viewport.height}`, () =>
    visit("pendulum?t=0", async (room) => {
      const inside = ({ x, y, width, height }) => x >= 0 && y >= 0 && x + width <= viewport.width && y + height <= viewport.height;
      const boxes = (places) => places.evaluateAll((all) => all.map((it) => ({ name: it.textContent || it.name || it.title, ...it.getBoundingClientRect().toJSON() })));
      const shown = await boxes(room.locator("canvas.stage, .readout strong, .bench-time button, .bench-time select, .quantity input, .quantity select"));
      assert.ok(shown.length >= 16, `${shown.length}`);
      for (const box of shown) assert.ok(inside(box), JSON.stringify(box));
      assert.equal(await room.evaluate(() => scrollY), 0);
      const [canvas] = await boxes(room.locator(".bench-stage"));
      assert.ok(canvas.height >= viewport.height / 2, `${canvas.height} px of ${viewport.height}`);
      const [header] = await boxes(room.locator("header"));
      if (viewport.width < 768) assert.ok(header.height <= 56, `${header.height} px`);
      // A finger needs 24 px (WCAG 2.5.8); the buttons of time have 44 px.
      for (const { name, width, height } of await boxes(room.locator(".bench-time button"))) assert.ok(width >= 43 && height >= 43, name);
    }, { viewport }));
}

test("the readouts are the numbers of the command", () =>
  visit("pendulum?angle=60deg&length=57cm&gravity=1.62m/s^2&t=1.25", async (room) => {
    const { period_s: period } = answer("period", "60deg", "--length", "57cm", "--gravity", "1.62m/s^2").results[0];
    assert.equal(await readout(room, "Period"), `${period.toPrecision(5)} s`);
    assert.deepEqual(await Promise.all(["Amplitude", "Length", "Gravity", "Time"].map((name) => readout(room, name))), ["60°", "0.57 m", "1.62 m/s²", "1.25 s"]);
    await enter(room, "Angle", "90");
    assert.equal(await readout(room, "Amplitude"), "90°");
    await enter(room, "Angular velocity", "1.5");
    const { amplitude_rad: amplitude } = answer("motion", "90deg", "--velocity", "1.5rad/s", "--length", "57cm", "--gravity", "1.62m/s^2", "--times", "0");
    assert.equal(await readout(room, "Amplitude"), `${((180 / Math.PI) * amplitude).toPrecision(5)}°`);
    await room.getByText("Damping and driving").click();
    await enter(room, "Damping c in 1/s", "0.1");
    assert.equal(await readout(room, "Period"), "–");
  }));

test("fields hold bare numbers with their units, which follow the switch of angles", () =>
  visit("pendulum?t=0", async (room) => {
    const field = (label) => room.getByLabel(label, { exact: true });
    const unit = (label) => room.locator(".field", { has: field(label) }).locator(".unit").textContent();
    for (const [label, value, name] of [["Angle", "150", "°"], ["Length", "1", "m"], ["Gravity", "9.80665", "m/s²"]]) {
      assert.equal(await field(label).inputValue(), value);
      assert.equal(await unit(label), name);
    }
    await enter(room, "Length", "0,25");
    assert.equal(await readout(room, "Length"), "0.25 m");
    assert.match(room.url(), /length=0\.25m/);
    await enter(room, "Angle", "45");
    await room.getByLabel("Angles in").selectOption("rad");
    await settled(room);
    assert.equal(Number(await field("Angle").inputValue()), Math.PI / 4);
    assert.equal(await unit("Angle"), "rad");
    assert.match(await readout(room, "Amplitude"), /^0\.785\d* rad$/);
    await room.getByLabel("Angles in").selectOption("deg");
    await settled(room);
    assert.equal(await field("Angle").inputValue(), "45");
    // A form that a conversion would round is kept.
    await enter(room, "Angle", "180deg-1e-9deg");
    await room.getByLabel("Angles in").selectOption("rad");
    await settled(room);
    assert.equal(await field("Angle").inputValue(), "180deg-1e-9deg");
  }));

test("a longer pendulum is drawn longer, to the scale of the stage", () =>
  visit("pendulum?angle=0&length=0.6m&t=0&bars=&trace=", async (room) => {
    const lowest = () =>
      stage(room).evaluate((canvas) => {
        const { width, height } = canvas;
        const column = canvas.getContext("2d").getImageData(Math.round(width / 2), 0, 1, height).data;
        const blue = (y) => column[4 * y + 2] - column[4 * y] > 60 && column[4 * y + 3] > 200;
        const rows = Array.from({ length: height }, (_, y) => y).filter(blue);
        return ((rows[0] + rows.at(-1)) / 2 - height / 2) / height;
      });
    const short = await lowest();
    await enter(room, "Length", "0.9");
    assert.ok(Math.abs((await lowest()) / short - 1.5) < 0.03, `${(await lowest()) / short}`);
  }));

test("keys of the stage do nothing outside it", () =>
  visit("pendulum?angle=60deg&t=0", async (room) => {
    await room.getByRole("button", { name: "Step back" }).focus();
    for (const key of [".", ",", "Home"]) await room.keyboard.press(key);
    assert.equal(await readout(room, "Time"), "0.00 s");
    await room.locator("body").click({ position: { x: 5, y: 5 } });
    await room.keyboard.press(".");
    assert.equal(await readout(room, "Time"), "0.00 s");
    await stage(room).focus();
    await room.keyboard.press(".");
    assert.equal(await readout(room, "Time"), "0.02 s");
  }));

test("energy bars are the parts of the energy", () =>
  visit("pendulum?angle=120deg&t=0.4", async (room) => {
    const values = await room.locator(".bar b").allTextContents();
    const { samples, energy_ratio: total } = answer("motion", "120deg", "--times", "0.4");
    const potential = Math.sin(samples[0].angle_rad / 2) ** 2;
    [total - potential, potential, total].forEach((energy, n) => assert.ok(Math.abs(read(values[n]) - energy) < 0.0051, `${values} for ${energy}`));
    await room.getByLabel("Energy", { exact: true }).uncheck();
    await settled(room);
    assert.equal(await room.locator(".bars").isVisible(), false);
    assert.match(room.url(), /bars=(&|$)/);
  }));

test("what friction takes is heat, unless a drive works too", () =>
  visit("pendulum?angle=120deg&damping=0.3&t=5", async (room) => {
    await room.waitForFunction(() => document.querySelectorAll(".bar").length === 4 && document.querySelector(".readout.time strong").textContent === "5.00 s");
    await settled(room);
    const [kinetic, potential, total, heat] = (await room.locator(".bar b").allTextContents()).map(read);
    const { samples } = answer("simulate", "driven_pendulum", "--set", `omega0=${Math.sqrt(9.80665)},c=0.3,A=0`, "--initial", "theta=120deg", "--times", "5");
    const [angle, velocity] = samples[0].state;
    const truth = [velocity ** 2 / 4 / 9.80665, Math.sin(angle / 2) ** 2];
    [kinetic, potential, total, heat].forEach((energy, n) => assert.ok(Math.abs(energy - [...truth, truth[0] + truth[1], 0.75 - truth[0] - truth[1]][n]) < 0.0051, `${[kinetic, potential, total, heat]}`));
    await visit("pendulum?angle=120deg&damping=0.3&drive=0.1&t=5", async (driven) => {
      await driven.waitForFunction(() => document.querySelector(".readout.time strong").textContent === "5.00 s");
      await settled(driven);
      assert.equal(await driven.locator(".bar").count(), 3);
    });
  }));

/** Processor time in s that the page's thread has used until the first room is painted. */
async function firstPicture() {
  let used = 0;
  await open(async (room) => {
    const session = await room.context().newCDPSession(room);
    await session.send("Performance.enable", { timeDomain: "threadTicks" });
    const busy = async () => (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
    await room.addInitScript(() => {
      const look = () => requestAnimationFrame(/\d/.test(document.querySelector(".readout.period strong")?.textContent ?? "") ? () => (window.isPainted = true) : look);
      look();
    });
    const before = await busy();
    await room.goto(`${pathToFileURL(page)}#pendulum`, { waitUntil: "commit" });
    await room.waitForFunction(() => window.isPainted);
    used = (await busy()) - before;
  });
  return used;
}

// A time is right for one machine only: TIMES=yes measures it. An Intel Xeon needs 0.24 s of processor time, an AMD EPYC 0.41 s.
test("the first picture is there within a second on a processor four times slower", { skip: process.env.TIMES === undefined }, async () => {
  // Processor time instead of a throttled clock, which depends on what else the machine does; a busy one needs up to a fifth more for the same work.
  const runs = [];
  for (let n = 0; n < 5; n++) runs.push(await firstPicture());
  assert.ok(4 * Math.min(...runs) < 1.2, `${runs}`);
});

test("a driven pendulum is shown where it is released until its motion is known", () =>
  open(async (room) => {
    await room.addInitScript(() => {
      // The bob is blue, at 90° right of the pivot.
      const isBlue = ([red, , blue, opacity]) => blue - red > 60 && opacity > 200;
      let frames = 0;
      const look = () => {
        const stage = document.querySelector("canvas.stage");
        // The size of the stage is known from its second frame on.
        frames += stage === null ? 0 : 1;
        if (frames < 3 || !/\d/.test(document.querySelector(".readout.length strong")?.textContent ?? "")) return requestAnimationFrame(look);
        const { data } = stage.getContext("2d").getImageData(stage.width / 2 + 5, stage.height / 2, stage.width / 2 - 5, 1);
        window.isShown = Array.from({ length: data.length / 4 }, (_, n) => data.slice(4 * n, 4 * n + 4)).some(isBlue);
        window.isKnown = document.querySelector(".readout.time strong").textContent !== "–";
      };
      requestAnimationFrame(look);
    });
    await room.goto(`${pathToFileURL(page)}#pendulum?angle=90deg&drive=0.5&t=0`);
    await room.waitForFunction(() => window.isShown !== undefined);
    assert.deepEqual(await room.evaluate(() => [window.isKnown, window.isShown]), [false, true]);
  }));
