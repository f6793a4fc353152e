// Room 3 compared with the command: series, terms and backbones of built-in and typed oscillators, and invalid entries.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, command, enter, errors, read, rows, saved, settled, visit } from "./harness.mjs";

after(close);

/** The letters and digits of formulas, as they are read one after the other. */
const plain = (markup) => markup.replace(/<[^>]*>/g, "").replace(/&#x2062;/g, "\u2062").replaceAll("\n", "");
/** The series of the command without the line of the equation, which the page typesets. */
const series = (...words) => plain(command("expand", ...words, "--format", "mathml").output.replace(/^.*\n/, ""));
const equation = (room) => room.locator(".equation math").evaluate((math) => math.textContent.replaceAll("\u2061", ""));
/** Enters an equation of the reader's own. */
async function own(room, entry) {
  if (!(await room.getByLabel("Equation of motion", { exact: true }).isVisible())) await room.getByLabel("Oscillator", { exact: true }).selectOption("");
  await enter(room, "Equation of motion", entry);
}
const shown = (room) => room.locator(".series math").evaluateAll((all) => all.map((math) => math.textContent).join(""));

for (const [name, fragment, words] of [
  ["the pendulum", "perturbation", ["pendulum", "--order", "7"]],
  ["a gauge", "perturbation?gauge=A1%3D1,A3%3D-1&order=9", ["pendulum", "--order", "9", "--gauge", "A1=1,A3=-1"]],
  ["letters", "perturbation?oscillator=x''%2Bw^2*x%2Ba*x^2%3D0&order=4", ["x''+w^2*x+a*x^2=0", "--order", "4"]],
  ["an order in stages", "perturbation?oscillator=duffing&order=41", ["duffing", "--order", "41"]],
]) {
  test(`the series of ${name} is the command's`, () =>
    visit(fragment, async (room) => assert.equal(await shown(room), series(...words))));
}

test("terms and backbone have the command's numbers", () =>
  visit("perturbation?evaluate=90deg&amplitudes=30deg,120deg", async (room) => {
    const { steps } = answer("expand", "pendulum", "--evaluate", "90deg");
    const terms = await rows(room, "Term by term");
    assert.deepEqual(terms.map(([power, , term, sum]) => [read(power), read(term), read(sum)]), steps.map(({ power, term, sum }) => [power, Number(term.toPrecision(5)), Number(sum.toPrecision(15))]));
    const { points } = answer("backbone", "pendulum", "--amplitudes", "30deg,120deg", "--order", "7");
    const backbone = await rows(room, "Backbone");
    assert.deepEqual(backbone.map(([, orbit, , exact, series]) => [orbit, exact, series].map(read)), points.map((it) => [it.angular_frequency_rad_per_s, it.exact, it.series_angular_frequency_rad_per_s].map((value) => Number(value.toPrecision(13)))));
  }));

test("amplitudes without a unit have that of the switch where the variable is an angle, and are plain where it is none", () =>
  visit("perturbation", async (room) => {
    const unit = (label) => room.locator(".field", { has: room.getByLabel(label, { exact: true }) }).locator(".unit").textContent();
    const sums = async () => (await rows(room, "Term by term")).map(([, , , sum]) => read(sum));
    const expected = (...words) => answer("expand", ...words).steps.map(({ sum }) => Number(sum.toPrecision(15)));
    const orbits = async () => (await rows(room, "Backbone")).map(([, orbit]) => read(orbit));
    await enter(room, "Evaluate at amplitude", "60");
    await enter(room, "Amplitudes of the backbone", "30:90:30");
    assert.equal(await unit("Evaluate at amplitude"), "°");
    assert.deepEqual(await sums(), expected("pendulum", "--evaluate", "60deg"));
    assert.deepEqual(await orbits(), answer("backbone", "pendulum", "--amplitudes", "30deg:90deg:30deg", "--order", "7").points.map((it) => Number(it.angular_frequency_rad_per_s.toPrecision(13))));
    await room.getByLabel("Angles in").selectOption("rad");
    await settled(room);
    assert.deepEqual(await sums(), expected("pendulum", "--evaluate", "60deg"));
    await enter(room, "Evaluate at amplitude", "0.5");
    assert.equal(await unit("Evaluate at amplitude"), "rad");
    assert.deepEqual(await sums(), expected("pendulum", "--evaluate", "0.5rad"));
    await own(room, "x'' + x + x^3 = 0");
    assert.equal(await unit("Evaluate at amplitude"), "");
    assert.deepEqual(await sums(), expected("x'' + x + x^3 = 0", "--evaluate", "0.5"));
  }));

test("a built-in oscillator brings no damping of that before, and what has no series has nothing to save", () =>
  visit("perturbation?oscillator=damped_pendulum&set=n%3D2&order=3&damping-order=2", async (room) => {
    await room.getByLabel("Oscillator", { exact: true }).selectOption("pendulum");
    await settled(room);
    assert.deepEqual(await errors(room), []);
    assert.equal(await room.getByLabel("Order in the damping", { exact: true }).inputValue(), "");
    const csv = room.getByRole("button", { name: "Save the numbers as CSV" });
    assert.equal(await csv.count(), 2);
    await enter(room, "Order", "nonsense");
    assert.equal(await csv.count(), 0);
    assert.equal(await room.getByRole("button", { name: "Save", exact: true }).count(), 0);
    assert.equal(await room.locator("table:visible").count(), 0);
    await enter(room, "Order", "5");
    assert.equal(await csv.count(), 2);
  }));

test("the equation is mathematics, and that of a built-in oscillator can be changed", () =>
  visit("perturbation?oscillator=cubic_quintic", async (room) => {
    assert.equal(await room.getByLabel("Equation of motion", { exact: true }).isVisible(), false);
    assert.equal(await equation(room), "x¨+x+x3+x5=0");
    await room.getByLabel("Oscillator", { exact: true }).selectOption({ label: "your own equation" });
    await settled(room);
    assert.equal(await room.getByLabel("Equation of motion", { exact: true }).inputValue(), "x'' + x + alpha*x^3 + beta*x^5 = 0");
    assert.equal(await room.getByLabel("Values of parameters", { exact: true }).inputValue(), "alpha=1,beta=1");
    assert.equal(await equation(room), "x¨+x+x3+x5=0");
    await enter(room, "Values of parameters", "");
    assert.equal(await equation(room), "x¨+x+αx3+βx5=0");
  }));

test("a gauge is named in words, and a wrong one is answered in words", () =>
  visit("perturbation?order=5&oscillator=duffing", async (room) => {
    await enter(room, "Gauge: definition of ε", "Half the swing");
    assert.equal(await shown(room), series("duffing", "--order", "5", "--gauge", "half_swing"));
    await enter(room, "Gauge: definition of ε", "nonsense");
    assert.deepEqual(await errors(room), ["unknown gauge “nonsense”: give fundamental, largest displacement, half the swing, energy, nome, or coefficients such as A1=1,A3=-1"]);
  }));

test("a slow flow is mathematics, with the command's words as text", () =>
  visit("perturbation?oscillator=damped_pendulum&set=n%3D2&order=3", async (room) => {
    assert.equal(await equation(room), "θ¨+cθ˙|θ˙|+sin(θ)=0");
    assert.match(await shown(room), /^A˙=−43πcA2ψ˙=1−116A2−16c2A2θ=/);
    assert.equal(await room.locator(".series pre").textContent(), command("expand", "damped_pendulum", "--set", "n=2", "--order", "3").output);
  }));

test("a driven oscillator asks for its resonance, and shows the slow flow with it", () =>
  visit("perturbation?oscillator=x''%2B2*eps*m*x'%2Bw^2*x%2Beps*a*x^3%3Deps*F*cos(W*t)", async (room) => {
    assert.match((await errors(room))[0], /^the acceleration depends on t: name the resonance of the drive/);
    await enter(room, "Resonance of a drive", "1/1");
    assert.deepEqual(await errors(room), []);
    assert.equal(await room.getByLabel("Order", { exact: true }).inputValue(), "");
    assert.match(await shown(room), /^A˙=.*peak\u00a0amplitude=F2mw/);
    const words = ["expand", "x''+2*eps*m*x'+w^2*x+eps*a*x^3=eps*F*cos(W*t)", "--resonance", "1/1"];
    assert.equal(await room.locator(".series pre").textContent(), command(...words).output);
    assert.equal(await room.locator("table:visible").count(), 0);
  }));

test("another oscillator is chosen by the keyboard alone, and a link shows it again", () =>
  visit("perturbation", async (room) => {
    await room.getByLabel("Oscillator", { exact: true }).focus();
    await room.keyboard.press("ArrowDown");
    await settled(room);
    assert.equal(await shown(room), series("duffing", "--order", "7"));
    assert.deepEqual(await errors(room), []);
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.equal(await shown(again), await shown(room)));
  }));

test("an equation without an angle is tried at plain numbers", () =>
  visit("perturbation?oscillator=x''%3D-x-x^3", async (room) => {
    assert.deepEqual(await errors(room), []);
    assert.equal(await room.getByLabel("Evaluate at amplitude", { exact: true }).inputValue(), "0.4");
    assert.equal((await rows(room, "Backbone")).length, 8);
  }));

test("functions of a language are saved as the command writes them", () =>
  visit("perturbation?oscillator=duffing", async (room) => {
    await room.getByLabel("Export as functions in").selectOption("c");
    const { name, bytes } = await saved(room, /^Save$/);
    assert.equal(name, "series.c");
    assert.equal(bytes.toString(), command("expand", "duffing", "--order", "7", "--format", "c").output);
  }));

test("entries that are no oscillators are answered in the command's words", () =>
  visit("perturbation", async (room) => {
    for (const entry of ["x'' + q", "x'' = 1/0", `${"(".repeat(20000)}x`, "x'' + x = 0; y", "<b>x</b>", "x''' = 0", "'\"`$(ls)"]) {
      await own(room, entry);
      const [said = ""] = await errors(room);
      const { status, error } = command("expand", entry, "--order", "7");
      assert.notEqual(status, 0);
      const inWords = (sentence) => sentence.replace(/`([^`]*)`/g, "“$1”");
      const reason = inWords(error.trim().replace(/^error: (?:OSCILLATOR\|EQUATION: |invalid value '[^]*?' for '[^']*': )?/, "").replace(/\n+For more information[^]*$/, ""));
      assert.equal(said, reason);
    }
    await enter(room, "Order", "0");
    await own(room, "x'' + x + x^3 = 0");
    assert.match((await errors(room)).join(), /give a whole number from 1 to 1000/);
  }));
