// Room 2 beside the command: numbers, tolerance, crossovers, by mouse and by keyboard.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, command, enter, errors, read, rows, saved, settled, visit } from "./harness.mjs";

after(close);
const USUAL = "bernoulli,power_series_3,denman,black_vel_2,black_vel_3,molina,kidd_fogg,butikov";

async function agrees(room, amplitude) {
  const [period] = answer("period", amplitude, "--formulas", USUAL).results;
  const names = new Map(answer("formulas").formulas.map(({ key, name }) => [key, name]));
  const shown = await rows(room, "The chosen formulas at");
  assert.deepEqual(shown.map(([name]) => name), period.formulas.map(({ key }) => names.get(key)));
  period.formulas.forEach(({ ratio, fractional_error: error }, place) => {
    assert.equal(read(shown[place][1]), Number(ratio.toPrecision(10)));
    assert.equal(read(shown[place][2]), Number(error.toPrecision(3)));
  });
}

test("the values of the formulas are the command's", () =>
  visit("formulas", async (room) => {
    await agrees(room, "60deg");
    await enter(room, "Amplitude", "pi-1e-6");
    await agrees(room, "pi-1e-6");
  }));

test("a tolerance says which formula suffices, and up to where", () =>
  visit("formulas?amplitude=90deg&tolerance=1e-3", async (room) => {
    const [simplest] = answer("formulas", "--amplitude", "90deg", "--tolerance", "1e-3").formulas;
    const said = await room.locator(".results").textContent();
    assert.ok(said.includes(`is ${simplest.name}; it holds up to ${Number(((simplest.holds_to_rad * 180) / Math.PI).toPrecision(6))}°`), said);
    const [, , , within, limit] = (await rows(room, "The chosen formulas")).find(([name]) => name === "Bernoulli");
    const bernoulli = answer("formulas", "--tolerance", "1e-3", "--formulas", "bernoulli").formulas[0].holds_to_rad;
    assert.equal(within, "no");
    assert.equal(read(limit), Number(((bernoulli * 180) / Math.PI).toPrecision(6)));
  }));

test("crossovers are the command's, in degrees and in radians", () =>
  visit("formulas?formulas=denman,black_vel_3,butikov", async (room) => {
    const { crossovers } = answer("formulas", "--crossovers", "--formulas", "denman,black_vel_3,butikov");
    const shown = async () => (await rows(room, "Amplitudes at which")).map(([amplitude]) => parseFloat(amplitude));
    assert.deepEqual(await shown(), crossovers.map(({ amplitude_rad: amplitude }) => Number(((amplitude * 180) / Math.PI).toPrecision(6))));
    await room.getByLabel("Angles in").selectOption("rad");
    await settled(room);
    assert.deepEqual(await shown(), crossovers.map(({ amplitude_rad: amplitude }) => Number(amplitude.toPrecision(6))));
  }));

test("the amplitude moves by keys and by the mouse, and a link shows the same again", () =>
  visit("formulas", async (room) => {
    const slider = room.getByRole("slider");
    await slider.focus();
    for (const key of ["ArrowRight", "PageUp", "Shift+ArrowLeft"]) await room.keyboard.press(key);
    await settled(room);
    assert.equal(await slider.getAttribute("aria-valuetext"), "70.9°");
    await agrees(room, "70.9deg");
    const { x, y, width, height } = await slider.boundingBox();
    await room.mouse.click(x + width / 2, y + height * 0.6);
    await settled(room);
    const moved = await slider.getAttribute("aria-valuetext");
    assert.notEqual(moved, "70.9°");
    assert.match(await room.locator(".under").textContent(), /^Under the pointer, at .*Bernoulli/);
    const shown = await rows(room, "The chosen formulas");
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.deepEqual(await rows(again, "The chosen formulas"), shown));
  }));

test("numbers without a unit have that of the switch, on the axis of the picture too", () =>
  visit("formulas", async (room) => {
    await enter(room, "Amplitude", "45");
    await agrees(room, "45deg");
    await room.getByText("Axes of the picture").click();
    await enter(room, "to", "90");
    const drawn = async () => (await saved(room, "Save the picture as SVG")).bytes.toString();
    const ninety = command("figure", "errors", "--formulas", USUAL, "--to", "90deg", "--output", "-").output;
    assert.equal(await drawn(), ninety);
    assert.equal(await room.getByRole("slider").getAttribute("aria-valuemax"), "90");
    await room.getByLabel("Angles in").selectOption("rad");
    await settled(room);
    await agrees(room, "45deg");
    assert.equal(await drawn(), ninety);
    await enter(room, "Amplitude", "0.75");
    await agrees(room, "0.75rad");
    await enter(room, "to", "1.5");
    assert.equal(await drawn(), command("figure", "errors", "--formulas", USUAL, "--to", "1.5rad", "--output", "-").output);
    assert.ok(Math.abs(Number(await room.getByRole("slider").getAttribute("aria-valuemax")) - (1.5 * 180) / Math.PI) < 0.05);
    const shown = await rows(room, "The chosen formulas");
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.deepEqual(await rows(again, "The chosen formulas"), shown));
  }));

test("nothing is saved where there is nothing to save", () =>
  visit("formulas", async (room) => {
    let files = 0;
    room.on("download", () => (files += 1));
    await enter(room, "Amplitude", "nonsense");
    await room.getByRole("button", { name: "Save the numbers as CSV" }).click();
    await settled(room);
    assert.equal(files, 0);
    assert.match((await errors(room)).join(), /nonsense/);
  }));

test("what is saved is what the command writes", () =>
  visit("formulas?formulas=molina,butikov", async (room) => {
    const { name, bytes } = await saved(room, "Save the picture as SVG");
    assert.equal(name, "errors.svg");
    assert.equal(bytes.toString(), command("figure", "errors", "--formulas", "molina,butikov", "--output", "-").output);
    const csv = await saved(room, "Save the numbers as CSV");
    assert.equal(csv.bytes.toString(), command("period", "60deg", "--formulas", "molina,butikov", "--csv").output);
    const png = await saved(room, "Save the picture as PNG");
    assert.equal(png.bytes.subarray(1, 4).toString(), "PNG");
  }));

test("every formula is typeset, with fractions and roots as LaTeX reads them", () =>
  visit(`formulas?formulas=${answer("formulas").formulas.map(({ key }) => key).join()}`, async (room) => {
    const unread = await room.locator(".formula-card math").evaluateAll((all) => all.filter((math) => math.querySelector("mtext") !== null || /[\\{}^_]/.test(math.textContent)).map((math) => math.textContent));
    assert.deepEqual(unread, []);
    const half = room.locator(".formula-card", { hasText: "AGM, second geometric mean" }).locator("mfrac").nth(1);
    assert.deepEqual(await half.evaluate((it) => [...it.children].map((child) => child.textContent)), ["1", "2"]);
    const ganley = room.locator(".formula-card", { hasText: "Ganley" }).locator("msqrt").nth(1);
    assert.equal(await ganley.textContent(), "3");
  }));

test("keys move no amplitude that is none", () =>
  visit("formulas?amplitude=nonsense", async (room) => {
    await room.getByRole("slider").focus();
    await room.keyboard.press("ArrowRight");
    await settled(room);
    assert.equal(await room.getByLabel("Amplitude", { exact: true }).inputValue(), "nonsense");
  }));

test("wrong entries are answered beside their fields", () =>
  visit("formulas", async (room) => {
    await enter(room, "Amplitude", "200deg");
    assert.match((await errors(room)).join(), /is not below pi/);
    assert.equal(await room.getByLabel("Amplitude", { exact: true }).getAttribute("aria-invalid"), "true");
    await enter(room, "Amplitude", "60deg");
    await enter(room, "Largest error you accept", "-1");
    assert.match((await errors(room)).join(), /^give a finite number above zero/);
    await enter(room, "Largest error you accept", "1e-3");
    assert.deepEqual(await errors(room), []);
    await room.getByRole("button", { name: "None" }).click();
    await settled(room);
    assert.match((await errors(room)).join(), /Choose a formula/);
  }));
