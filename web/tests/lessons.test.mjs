// The lesson plans of docs/teaching: each is opened by its own links, its steps are done, and what it promises is seen.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { close, enter, saved, settled, visit } from "./harness.mjs";

after(close);

/** The text of a plan and the states of the page that it opens, in order. */
function plan(name) {
  const text = readFileSync(new URL(`../../docs/teaching/${name}.md`, import.meta.url), "utf8");
  const links = [...text.matchAll(/\]\(\.\.\/page\/libration\.html#([^)\s]+)\)/g)].map(([, fragment]) => fragment);
  return { text, links };
}

/** The cells of the plan's table whose first heading is this one, row by row. */
function tableOf({ text }, heading) {
  const lines = text.split("\n");
  const head = lines.findIndex((line) => line.startsWith(`| ${heading} `));
  assert.ok(head >= 0, heading);
  const end = lines.findIndex((line, n) => n > head && !line.startsWith("|"));
  return lines.slice(head + 2, end).map((line) => line.split("|").slice(1, -1).map((cell) => cell.trim()));
}

const readout = (room, name) => room.locator(".readout", { hasText: name }).locator("strong").textContent();
const gate = (room) => room.getByRole("group", { name: "Photogate" });
const press = (place, name) => place.getByRole("button", { name, exact: true }).click();
const trials = (room) => room.locator(".trials tbody tr").evaluateAll((all) => all.map((row) => [...row.querySelectorAll("input")].map((it) => it.value).concat(row.lastElementChild.textContent)));
const fact = (room, name) => room.locator("dt", { hasText: new RegExp(`^${name}$`) }).locator("xpath=following-sibling::dd[1]").textContent();

/** Enters a value of the bench, waits for a reading of the photogate, and puts it into the table. */
async function measure(room, label, value) {
  await enter(room, label, value);
  await press(gate(room), "Into the table");
}

/** Periods in s of 1 m at 9.80665 m/s², by mpmath: 4·sqrt(l/g)·ellipk(sin²(θ₀/2)). */
const PERIODS = [[5, 2.0073647], [10, 2.0102359], [20, 2.0217965], [40, 2.0692912], [60, 2.1532424], [90, 2.3682463], [120, 2.7545602], [150, 3.5357019]];

test("the period depends on the amplitude", () => {
  const amplitude = plan("amplitude");
  assert.deepEqual(tableOf(amplitude, "amplitude"), PERIODS.map(([angle, period]) => [`${angle}°`, `${period.toFixed(3)} s`]));
  return visit(amplitude.links[0], async (room) => {
    assert.equal(await readout(room, "Period"), "?");
    await room.getByLabel("Speed").selectOption("4 times faster");
    await press(room, "Run");
    for (const [angle] of PERIODS) await measure(room, "Angle", String(angle));
    assert.deepEqual(await trials(room), [...PERIODS.map(([angle, period]) => [String(angle), "1", "1", period.toFixed(3), Number(period.toFixed(3)).toPrecision(5)]), ["", "", "", "", ""]]);
    assert.match(await room.locator(".trials canvas").first().getAttribute("aria-label"), /^8 measured times/);
    await room.getByLabel("Hide the exact values").uncheck();
    await settled(room);
    // By mpmath's findroot: 1 % at 22.81°, 10 % at 69.33°, double at 159.8°; the readout has five digits.
    for (const [angle, ratio] of [["22.8", 1.01], ["69.3", 1.1], ["159.8", 2]]) {
      await enter(room, "Angle", angle);
      assert.ok(Math.abs(parseFloat(await readout(room, "Period")) / (2.00640929 * ratio) - 1) < 2e-3, angle);
      assert.match(amplitude.text, new RegExp(`${angle}°`));
    }
    await enter(room, "Angle", "180");
    assert.equal(await readout(room, "Period"), "–");
    await visit(amplitude.links[1].replace("t=0", "t=15"), async (two) => {
      // Both angles at 15 s by mpmath: 2·asin(k·sn(K − ω₀t)), k = sin(θ₀/2): −4.9255° and 58.7170°, near their opposite ends.
      assert.deepEqual([await fact(two, "Angle"), await fact(two, "Angle of the other pendulum")], ["−4.93°", "58.72°"]);
      const graph = two.getByRole("img", { name: /^Angle against time, .*; and that of the other pendulum$/ });
      await graph.scrollIntoViewIfNeeded();
      await two.waitForFunction((it) => it.getContext("2d").getImageData(0, 0, it.width, it.height).data.some((_, n, all) => n % 4 === 0 && all[n] - all[n + 1] > 60 && all[n + 2] - all[n + 1] > 30), await graph.elementHandle());
    });
  });
});

/** The energies of the bars: kinetic, potential, total. */
const bars = (room) => room.locator(".bar b").allTextContents();

test("energy and phase space", () => {
  const energy = plan("energy");
  const promised = Object.fromEntries(tableOf(energy, "step").map(([, quantity, value]) => [quantity, value]));
  return visit(energy.links[0], async (room) => {
    // m·g·l·(1 − cos 60°) = 0.2 · 9.80665 · 0.25 J.
    assert.deepEqual(await bars(room), ["0.000 J", "0.490 J", "0.490 J"]);
    assert.equal(promised["potential energy at 60°"], "0.490 J");
    for (let n = 0; n < 23; n++) await press(room, "Step forward");
    assert.deepEqual(await bars(room), ["0.490 J", "0.000 J", "0.490 J"]);
    // By mpmath at 23/60 s: 2·asin(k·sn(K − ω₀t)) = −0.6826°, and −4.4282 rad/s; √(2·9.80665·0.25) m/s = 2.2143 m/s at the lowest point.
    assert.equal(await fact(room, "Angle"), "−0.68°");
    assert.equal(await fact(room, "Angular velocity"), promised["angular velocity there"]);
    assert.equal(promised["speed at the lowest point"], `${Math.sqrt(2 * 9.80665 * 0.25).toFixed(2)} m/s`);
    const plane = room.getByRole("img", { name: /^Velocity against angle/ });
    await plane.scrollIntoViewIfNeeded();
    const { width, height } = await plane.boundingBox();
    for (const [across, up, regime] of [[0.55, 0.3, /^libration/], [0.55, 0.06, /^rotation/]]) {
      await plane.click({ position: { x: across * width, y: up * height } });
      await settled(room);
      assert.match(await fact(room, "Regime"), regime);
    }
    await enter(room, "Angle", "0");
    // 2·√(g/l) = 8.8574 rad/s.
    for (const [velocity, regime, words] of [["8.8", /^libration/, "swings to and fro"], ["8.9", /^rotation/, "over the top"]]) {
      await enter(room, "Angular velocity", velocity);
      assert.match(await fact(room, "Regime"), regime);
      assert.equal(promised[`${velocity} rad/s`], words);
    }
    assert.match(energy.text, /= 8\.857 rad\/s/);
    await visit(energy.links[1].replace("t=0", "t=10"), async (rubbed) => {
      await rubbed.waitForFunction(() => document.querySelector(".readout.time strong").textContent === "10.00 s" && [...document.querySelectorAll("dt")].some((it) => it.textContent === "Angle"));
      // By mpmath's odefun at 10 s, 20 digits: E = m·l²·(θ′²/2 + ω₀²·(1 − cos θ)).
      // The rest of m·g·l·(1 − cos 60°) is heat.
      assert.deepEqual((await bars(rubbed)).slice(2), ["0.0670 J", "0.4234 J"]);
      assert.equal(promised["heat after 10 s"], "0.4234 J");
      assert.equal(promised["total energy after 10 s"], "0.0670 J");
    });
  });
});

/** The headline and the reasons of the fit of the table. */
async function fit(room) {
  await press(room, "Find g");
  await room.waitForFunction(() => document.querySelector(".result .headline, .result .error") !== null, null, { timeout: 60_000 });
  return room.locator(".result").innerText();
}

/** Pastes text into a cell, as a spreadsheet puts it on the clipboard. */
async function paste(place, written) {
  await place.focus();
  await place.evaluate((input, it) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", it);
    input.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, written);
}

test("gravity of a mystery planet, with the page's own instruments", () => {
  const gravity = plan("gravity");
  // By mpmath, 4·sqrt(l/g)·ellipk(sin²5°) at g = 23.22 m/s².
  const periods = [["0.5", 0.92376447], ["1", 1.3064002], ["1.5", 1.600007]];
  assert.deepEqual(tableOf(gravity, "length"), periods.map(([length, period]) => [`${length} m`, `${period.toFixed(3)} s`]));
  return visit(gravity.links[0], async (room) => {
    assert.deepEqual(await Promise.all(["Period", "Gravity"].map((name) => readout(room, name))), ["?", "?"]);
    await press(room, "Run");
    for (const [length] of periods) await measure(room, "Length", length);
    assert.deepEqual((await trials(room)).map((row) => row.slice(0, 4)), [...periods.map(([length, period]) => ["10", length, "1", period.toFixed(3)]), ["", "", "", ""]]);
    assert.match(await room.locator(".trials canvas").last().getAttribute("aria-label"), /^3 measured times/);
    await room.getByLabel("Uncertainty of one time").fill("0.0005");
    const found = await fit(room);
    const [, value, error] = /^g = (\S+) ± (\S+) m\/s²/.exec(found);
    const [, interval] = /With 95 % probability g lies within ± (\S+) m/.exec(found);
    assert.ok(Math.abs(Number(value) - 23.22) < Number(interval), found);
    assert.doesNotMatch(found, /Earth/);
    assert.match(gravity.text, new RegExp(`They should find ${Number(value).toFixed(2)} ± ${Number(error).toFixed(2)} m/s²; the planet has 23.22 m/s²`));
    await press(room, "Reveal");
    await settled(room);
    assert.equal(await readout(room, "Gravity"), "23.22 m/s²");
  });
});

test("gravity from a class's table", () => {
  const gravity = plan("gravity");
  const rows = tableOf(gravity, "amplitude / °");
  return visit(gravity.links[1], async (room) => {
    await paste(room.getByLabel("amplitude / °, row 1"), rows.map((row) => row.join("\t")).join("\n"));
    const found = await fit(room);
    // NumPy's polyfit of T² against l over all readings, the amplitude of 10° taken out by (T/T₀)² with mpmath: 9.80137 ± 0.03060 m/s².
    const [, value, error] = /^g = (\S+) ± (\S+) m\/s²/.exec(found);
    assert.ok(Math.abs(Number(value) - 9.80137) < 6e-4 && Math.abs(Number(error) - 0.0306) < 6e-4, found);
    assert.match(gravity.text, new RegExp(`The table gives ${Number(value).toFixed(2)} ± ${Number(error).toFixed(2)} m/s²`));
    await visit(gravity.links[2], async (filled) => assert.deepEqual(await trials(filled), await trials(room)));
  });
});

/** T/T₀ by mpmath, 2·ellipk(sin²(θ₀/2))/π, with twelve digits. */
const RATIOS = [[10, "1.00190718814"], [20, "1.00766902579"], [30, "1.0174087976"], [40, "1.03134051913"]];

test("the sixteenth is found in numbers", () => {
  const sixteenth = plan("sixteenth");
  const quotient = (angle, ratio) => ((Number(ratio) - 1) / ((angle * Math.PI) / 180) ** 2).toFixed(5);
  assert.deepEqual(tableOf(sixteenth, "amplitude"), RATIOS.map(([angle, ratio]) => [`${angle}°`, ratio, quotient(angle, ratio)]));
  return visit(sixteenth.links[0], async (room) => {
    for (const [angle, ratio] of RATIOS) {
      await enter(room, "Angle", String(angle));
      assert.equal(Number(await fact(room, "T / T₀")), Number(ratio));
    }
  });
});

test("the sixteenth is derived as an exercise, and checked", () => {
  const { links, text } = plan("sixteenth");
  return visit(links[1], async (room) => {
    const step = (place) => room.locator(".derivation details.step").nth(place);
    await step(0).waitFor();
    for (let n = 1; n < 4; n++) {
      assert.equal(await step(n).evaluate((it) => it.open), false);
      await press(room, "Next step");
      assert.equal(await step(n).evaluate((it) => it.open), true);
    }
    // The bracket of the exercises is a question mark; the answer has θ₀²/16.
    assert.match(await step(2).innerText(), /=\s*\?/);
    const answer31 = room.getByLabel("Your answer to (3.1)");
    await answer31.fill(/such as `([^`]*)`/.exec(text)[1]);
    await answer31.press("Enter");
    await room.getByText("right", { exact: true }).waitFor();
    const last = room.locator(".derivation details.step").last();
    assert.equal(await last.evaluate((it) => it.open), false);
    while (!(await last.evaluate((it) => it.open))) await press(room, "Next step");
    const answer = await last.evaluate((it) => it.textContent.replaceAll(/\s/g, ""));
    assert.match(answer, /=1\+θ0216\+O/);
    await visit(links[2], async (checked) => {
      await checked.locator(".derivation details.step").first().waitFor();
      // By mpmath, 2·ellipk(sin²10°)/π − 1 = 0.00766903, and (π/9)²/16 = 0.00761544.
      const row = await checked.locator(".derivation table tbody tr", { hasText: "0.007669" }).innerText();
      assert.match(row, /^20\s+0\.007669\s+0\.007615/);
      assert.match(text, /20° has 0\.007669 \(exact\) and 0\.007615/);
      // By mpmath's findroot: 1 − (1 + θ₀²/16)/(T/T₀) = 0.001 at 41.63°, 0.01 at 73.91°.
      assert.match(text, /Up to 41\.6° and 73\.9°/);
    });
  });
});

test("two driven pendulums stay in step, or part", () => {
  const { links, text } = plan("chaos");
  // By SciPy's solve_ivp with DOP853 and tolerances of 1e-13: 121.5543° and 121.5550° at 30 s, 238.7695° and 185.1615° at 25 s, here within a turn.
  const angles = [[links[0], 30, ["121.55°", "121.55°"]], [links[1], 25, ["−121.23°", "−174.84°"]]];
  assert.match(text, /at 30 s both angles are 121\.55°\. Step 3: at 25 s they are −121\.23° and −174\.84°/);
  const both = async ([link, time, expected]) =>
    visit(link.replace("t=0", `t=${time}`), async (room) => {
      await room.waitForFunction(() => [...document.querySelectorAll("dt")].some((it) => it.textContent === "Angle of the other pendulum"), null, { timeout: 60_000 });
      assert.deepEqual([await fact(room, "Angle"), await fact(room, "Angle of the other pendulum")], expected);
    });
  return angles.reduce((before, it) => before.then(() => both(it)), Promise.resolve());
});

/** The distinct velocities of the last 64 points of the section, rounded. */
async function pointsOf(room, decimals) {
  const section = room.locator("section", { has: room.getByRole("heading", { name: "Poincaré section", exact: true }) });
  const lines = (await saved(section, "Save the numbers as CSV")).bytes.toString().trim().split("\n");
  const velocity = lines[0].split(",").indexOf("theta'");
  const last = lines.filter((line) => line.startsWith("1,")).slice(-64);
  return [...new Set(last.map((line) => Number(line.split(",")[velocity]).toFixed(decimals)))].map(Number).sort((a, b) => a - b);
}

// Velocities once per period of the drive by SciPy's solve_ivp with DOP853 and a tolerance of 1e-10, after 200 periods. The exponents: −c/2 where the
// multipliers are a complex pair, whose product is exp(−c·period); 0.132 by the equation of the deviations over 600 periods.
const SNAPSHOTS = [
  ["0.9", [1.934], /^Regular: /, -0.25],
  ["1.07", [1.149, 1.346], /^Regular: /, undefined],
  ["1.09", [-0.375, 0.845, 1.821], /^Regular: /, -0.25],
  ["1.2", undefined, /^Chaotic: /, 0.132],
  ["1.4", [0.934], /^Regular: /, undefined],
];

for (const [place, [amplitude, points, verdict, exponent]] of SNAPSHOTS.entries()) {
  test(`snapshots of the pendulum driven by ${amplitude} are as the plan says`, () => {
    const chaos = plan("chaos");
    const [, count, said, rounded] = tableOf(chaos, "amplitude").find(([first]) => first === amplitude);
    return visit(chaos.links[2 + place], async (room) => {
      await room.waitForFunction(() => document.querySelector(".results")?.getAttribute("aria-busy") === "false" && document.querySelector("p.verdict") !== null, null, { timeout: 120_000 });
      assert.match(await room.locator("p.verdict").textContent(), verdict);
      assert.match(`${said}: `, verdict);
      if (points === undefined) assert.deepEqual([(await pointsOf(room, 6)).length, count], [64, "never the same"]);
      else assert.deepEqual([await pointsOf(room, 3), count], [points, String(points.length)]);
      const [, value, error] = /exponent is (\S+) ± (\S+) 1\/s/.exec((await room.locator(".results").textContent()).replaceAll("−", "-")).map(Number);
      assert.equal(rounded.replace("−", "-"), value.toFixed(2));
      if (exponent !== undefined) assert.ok(Math.abs(value - exponent) < 4 * error, `${value} ± ${error}`);
    });
  });
}

test("the bifurcation diagram is clicked", () =>
  visit(plan("chaos").links[7], async (room) => {
    const slider = room.getByRole("slider", { name: /^Value of A in the diagram/ });
    await slider.waitFor({ timeout: 120_000 });
    await room.waitForFunction(() => document.querySelector(".results")?.getAttribute("aria-busy") === "false", null, { timeout: 120_000 });
    assert.match(await room.locator("p.verdict").textContent(), /^Chaotic: /);
    // The frame of the axes begins right of the numbers; around 1.4 is a window of order.
    const { width, height } = await slider.boundingBox();
    for (let at = 0.7; at < 0.95 && !/A = 1\.(3[5-9]|4[0-5])/.test(await slider.getAttribute("aria-valuetext")); at += 0.05) await slider.click({ position: { x: width * at, y: height / 2 } });
    assert.match(await slider.getAttribute("aria-valuetext"), /A = 1\.(3[5-9]|4[0-5])/);
    await settled(room);
    assert.match(await room.locator("p.verdict").textContent(), /^Regular: /);
  }));
