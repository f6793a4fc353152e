// The instruments of room 1, by mouse, touch and keys: what they read is the motion of the command.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, enter, errors, PHONE, read, settled, visit } from "./harness.mjs";

after(close);

const readout = (room, name) => room.locator(".readout", { hasText: name }).locator("strong").textContent();
const gate = (room) => room.getByRole("group", { name: "Photogate" });
const stage = (room) => room.getByRole("slider", { name: /Angle of release/ });
const display = (place) => place.locator("output").textContent();
const run = (room) => room.getByRole("button", { name: "Run", exact: true }).click();

/** The reading of the photogate once there is one. */
async function gated(room) {
  await room.waitForFunction(() => /\d/.test(document.querySelector('[aria-label="Photogate"] output').textContent), null, { timeout: 30_000 });
  return display(gate(room));
}

for (const [speed, digits] of [["1", 4], ["20", 4]]) {
  test(`the photogate reads the period at speed ${speed}, whatever the frames`, () =>
    visit(`pendulum?angle=60deg&length=30cm&gate=yes&t=0&speed=${speed}`, async (room) => {
      const { period_s: period } = answer("period", "60deg", "--length", "30cm").results[0];
      await gate(room).getByLabel("Resolution").selectOption("0.0001 s");
      await run(room);
      assert.equal(await gated(room), `${period.toFixed(digits)} s`);
    }));
}

test("the photogate reads the period of a rotation, and nothing where it cannot follow", () =>
  visit("pendulum?angle=0&velocity=9rad/s&gate=yes&t=0", async (room) => {
    const { period_s: period } = answer("motion", "0", "--velocity", "9rad/s", "--times", "0");
    await run(room);
    assert.equal(await gated(room), `${period.toFixed(3)} s`);
    await visit("pendulum?angle=60deg&length=1e-13m&gate=yes&t=0", async (fast) => {
      await run(fast);
      await fast.waitForTimeout(500);
      assert.equal(await display(gate(fast)), "–");
    });
  }));

test("the photogate times several swings of a damped pendulum as the crossings of the command have them, to its resolution", () =>
  visit("pendulum?angle=60deg&length=30cm&damping=0.4&drag=0.3&gate=yes&t=0", async (room) => {
    await gate(room).getByLabel("Swings").fill("2");
    await gate(room).getByLabel("Resolution").selectOption("0.01 s");
    await run(room);
    const equation = "theta'' = -0.4*theta' - 0.3*abs(theta')*theta' - 9.80665/0.3*sin(theta)";
    const { events } = answer("simulate", equation, "--initial", "theta=60deg,theta'=0", "--times", "0:5:5", "--events", "theta");
    // On a busy machine the first time may be seen only after the next one has taken its place.
    const times = [0, 4].map((first) => `${(events[first + 4].time_s - events[first].time_s).toFixed(2)} s`);
    const shown = await gated(room);
    assert.ok(times.includes(shown), `${shown}, and not one of ${times.join(", ")}`);
  }));

test("a wrong number of swings is refused, and nothing is timed", () =>
  visit("pendulum?angle=60deg&length=30cm&gate=yes&speed=4&t=0", async (room) => {
    await gate(room).getByLabel("Swings").fill("1.5");
    assert.match(await gate(room).textContent(), /a whole number of swings/);
    await run(room);
    await room.waitForTimeout(1500);
    assert.equal(await display(gate(room)), "–");
    await gate(room).getByLabel("Swings").fill("1");
    assert.match(await gated(room), /^1\.179 s$/);
  }));

test("dry friction stops the pendulum where the command stops it", () =>
  visit("pendulum?angle=20deg&t=30", async (room) => {
    await room.getByText("Friction and mass").click();
    await room.getByLabel("Friction", { exact: true }).selectOption("dry: like a rusty pivot");
    await room.getByLabel("Amount of friction").fill("0.25");
    await settled(room);
    assert.match(room.url(), /dry=0\.5(&|$)/);
    await visit(`${new URL(room.url()).hash.slice(1)}&t=30`, async (again) => {
      await again.waitForFunction(() => [...document.querySelectorAll("dt")].some((it) => it.textContent === "Angle"), null, { timeout: 60_000 });
      const shown = await again.locator("dt", { hasText: /^Angle$/ }).locator("xpath=following-sibling::dd[1]").textContent();
      const { samples } = answer("simulate", "theta'' = -0.5*sign(theta') - 9.80665*sin(theta)", "--initial", "theta=20deg,theta'=0", "--times", "30");
      assert.ok(Math.abs(read(shown) - (180 / Math.PI) * samples[0].state[0]) < 0.006, shown);
    });
    await room.getByLabel("Friction", { exact: true }).selectOption("none");
    await settled(room);
    assert.doesNotMatch(room.url(), /dry=/);
  }));

test("the stopwatch runs in the time of the pendulum, and stands with it", () =>
  visit("pendulum?t=0&stopwatch=yes", async (room) => {
    const watch = room.getByRole("group", { name: "Stopwatch" });
    await watch.getByRole("button", { name: "Start" }).click();
    await room.waitForTimeout(300);
    assert.equal(await display(watch), "0.00 s");
    await run(room);
    await room.waitForTimeout(600);
    await room.getByRole("button", { name: "Pause" }).click();
    const [measured, time] = [await display(watch), await readout(room, "Time")].map((it) => read(it.replace(" s", "")));
    assert.ok(measured > 0.2 && Math.abs(measured - time) <= 0.0101, `${measured} of ${time}`);
    await watch.getByRole("button", { name: "Stop" }).click();
    await room.getByRole("button", { name: "Step forward" }).click();
    assert.equal(read((await display(watch)).replace(" s", "")), measured);
    await watch.getByRole("button", { name: "Zero" }).click();
    assert.equal(await display(watch), "0.00 s");
  }));

/** The place of the ruler. */
async function lies(room) {
  const { x, y } = await room.locator(".ruler").boundingBox();
  return { x: Math.round(x), y: Math.round(y) };
}

test("the ruler has the scale of the pendulum, and moves by mouse and keys", () =>
  visit("pendulum?angle=0&length=0.8m&ruler=yes&t=0", async (room) => {
    const start = await lies(room);
    assert.match(await room.locator(".ruler").getAttribute("aria-label"), /^Ruler: it reads 0.8 m /);
    const bench = await room.locator("canvas.stage").boundingBox();
    // Its zero, 12 px below its upper edge, lies at the pivot.
    assert.ok(Math.abs(start.y + 12 - (bench.y + bench.height / 2)) <= 1.5, `${start.y}`);
    await room.mouse.move(start.x + 20, start.y + 60);
    await room.mouse.down();
    await room.mouse.move(start.x - 80, start.y + 90, { steps: 3 });
    await room.mouse.up();
    assert.deepEqual(await lies(room), { x: start.x - 100, y: start.y + 30 });
    // 1 m is the radius of the circle of marks, so that the ruler reads less by the px that it was lowered.
    const radius = (await room.locator(".ruler").boundingBox()).height - 2 - 24;
    const said = /reads (\S+) m where/.exec(await room.locator(".ruler").getAttribute("aria-label"))[1];
    assert.ok(Math.abs(Number(said) - (0.8 - 30 / radius)) <= 0.0051, `${said} for ${radius} px`);
    await room.locator(".ruler").focus();
    for (const key of ["ArrowRight", "ArrowUp", "Shift+ArrowUp"]) await room.keyboard.press(key);
    assert.deepEqual(await lies(room), { x: start.x - 90, y: start.y + 19 });
    assert.equal(await room.getByLabel("Angle", { exact: true }).inputValue(), "0");
  }));

test("the ruler moves under a finger, and goes back if the system takes the finger away", () =>
  visit("pendulum?angle=0&ruler=yes&t=0", async (room) => {
    const session = await room.context().newCDPSession(room);
    const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
    const start = await lies(room);
    const drag = async (end) => {
      await touch("touchStart", [{ x: start.x + 20, y: start.y + 50 }]);
      await touch("touchMove", [{ x: start.x + 50, y: start.y + 60 }]);
      await touch(end, []);
    };
    await drag("touchCancel");
    assert.deepEqual(await lies(room), start);
    await drag("touchEnd");
    assert.deepEqual(await lies(room), { x: start.x + 30, y: start.y + 10 });
  }, { viewport: PHONE, hasTouch: true }));

test("a mystery planet shows its gravity nowhere until it is revealed", () =>
  visit("pendulum?angle=60deg&t=0&gate=yes", async (room) => {
    await room.getByLabel("Gravity of", { exact: true }).selectOption("a mystery planet");
    await settled(room);
    assert.equal(await readout(room, "Gravity"), "?");
    assert.equal(await readout(room, "Period"), "?");
    assert.equal(await room.locator(".facts").isVisible(), false);
    assert.equal(await room.locator(".equivalents").isVisible(), false);
    assert.equal(await room.getByLabel("Gravity", { exact: true }).inputValue(), "?");
    await gate(room).getByLabel("Resolution").selectOption("0.0001 s");
    await run(room);
    const period = read((await gated(room)).replace(" s", ""));
    const said = await room.evaluate(() => [...document.querySelectorAll("[aria-label], [role=status]")].map((it) => `${it.getAttribute("aria-label")} ${it.textContent}`).join("\n"));
    assert.doesNotMatch(said.replace(/Photogate.*/g, ""), new RegExp(period.toFixed(2)));
    await room.getByRole("button", { name: "Reveal" }).click();
    await settled(room);
    const gravity = Number(await room.getByLabel("Gravity", { exact: true }).inputValue());
    const { period_s } = answer("period", "60deg", "--gravity", `${gravity}m/s^2`).results[0];
    assert.ok(Math.abs(period - period_s) < 6e-5, `${period} for ${gravity}`);
    assert.equal(await room.getByRole("button", { name: "Reveal" }).isVisible(), false);
  }));

test("a mystery pendulum has the same hidden length for everyone with the link, and hiding hides the period only", () =>
  visit("pendulum?secret=pendulum-4711&angle=10deg&t=0", async (room) => {
    assert.equal(await readout(room, "Length"), "?");
    await room.getByRole("button", { name: "Reveal" }).click();
    await settled(room);
    const length = await room.getByLabel("Length", { exact: true }).inputValue();
    await visit("pendulum?secret=pendulum-4711&t=0", async (again) => {
      await again.getByRole("button", { name: "Reveal" }).click();
      assert.equal(await again.getByLabel("Length", { exact: true }).inputValue(), length);
    });
    await room.getByLabel("Hide the exact values").check();
    await settled(room);
    assert.equal(await readout(room, "Period"), "?");
    assert.equal(await readout(room, "Gravity"), "9.807 m/s²");
    assert.equal(await room.locator(".facts").isVisible(), false);
  }));

test("two pendulums are released together, each with its own settings and errors", () =>
  visit("pendulum?angle=40deg&second=yes&length2=0.25m&angle2=40deg&t=0&trace=&bars=", async (room) => {
    // The second is a quarter as long: after one period of the first it has made two swings, so that both are back.
    const pink = (it = room) =>
      stage(it).evaluate((canvas) => {
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        let [count, sum] = [0, 0];
        for (let at = 0; at < data.length; at += 4) {
          if (data[at] - data[at + 1] > 70 && data[at + 2] - data[at + 1] > 40) [count, sum] = [count + 1, sum + ((at / 4) % canvas.width)];
        }
        return count === 0 ? undefined : sum / count;
      });
    await room.waitForTimeout(300);
    const start = await pink();
    assert.notEqual(start, undefined);
    const { period_s: period } = answer("period", "40deg").results[0];
    await visit(`pendulum?angle=40deg&second=yes&length2=0.25m&angle2=40deg&trace=&bars=&t=${period}`, async (again) => {
      await again.waitForTimeout(300);
      const back = await pink(again);
      assert.ok(Math.abs(back - start) < 1, `${back} instead of ${start}`);
    });
    await visit(`pendulum?angle=40deg&second=yes&length2=0.25m&angle2=40deg&trace=&bars=&t=${period / 4}`, async (again) => {
      await again.waitForTimeout(300);
      // At a quarter of the first period the second is at its other turning point.
      const width = await stage(again).evaluate((canvas) => canvas.width);
      assert.ok(Math.abs((await pink(again)) - (width - start)) < 2, `${await pink(again)} of ${width}`);
    });
    await room.getByLabel("Length of the second").fill("long");
    await settled(room);
    assert.match((await errors(room)).join(), /long/);
    await enter(room, "Length of the second", "0.25");
    await enter(room, "Mass of the second", "2");
    assert.deepEqual((await errors(room)).filter((it) => it !== ""), []);
    assert.ok((await pink()) !== undefined);
    await room.getByLabel("Second pendulum").uncheck();
    await settled(room);
    assert.equal(await pink(), undefined);
  }));

test("with a mass the energies are joules", () =>
  visit("pendulum?angle=90deg&length=0.5m&mass=200g&t=0", async (room) => {
    // m g l (1 − cos 90°) = 0.2 · 9.80665 · 0.5 J.
    assert.deepEqual(await room.locator(".bar b").allTextContents(), ["0.000 J", "0.981 J", "0.981 J"]);
    await room.getByLabel("Mass", { exact: true }).fill("heavy");
    await settled(room);
    assert.match((await errors(room)).join(), /a mass such as/);
  }));
