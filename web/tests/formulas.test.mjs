// Room 2 compared with mpmath and the command: curves, readout, errors, tolerance, crossovers, by mouse, touch and keyboard.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { answer, close, command, enter, errors, open, page, read, rows, saved, settled, visit } from "./harness.mjs";

after(close);
const USUAL = "bernoulli,power_series_3,denman,black_vel_2,black_vel_3,molina,kidd_fogg,butikov";

/** mpmath with 30 digits: T/T₀ = 2K(k)/π and the formulas as published, in the order of the catalogue: exact, small angles, Bernoulli, power series to
    θ₀⁶, Denman, Fourier-perturbation with 2 and 3 terms, Molina, Kidd-Fogg, Butikov. */
const REFERENCE = {
  60: { ratios: [1.07318200715, 1, 1.068538919, 1.073154484, 1.073582161, 1.073131156, 1.073178536, 1.073832997, 1.074569932, 0.8531830264], errors: [-0.0681916, -0.00432647, -2.56463e-5, 0.000372867, -4.73833e-5, -3.23451e-6, 0.000606598, 0.00129328, -0.204997] },
  150: { ratios: [1.7622037295, 1, 1.428368247, 1.672124413, 1.749377976, 1.703799946, 1.7334647, 1.860477762, 1.965630511, 1.735725427], errors: [-0.432529, -0.189442, -0.0511174, -0.00727825, -0.0331425, -0.0163086, 0.0557677, 0.115439, -0.0150257] },
};
const readout = (room) => rows(room, "The chosen formulas at");
const slider = (room) => room.getByRole("slider", { name: /picture of the period/ });

async function hasReference(room, degrees) {
  const { ratios, errors } = REFERENCE[degrees];
  const shown = await readout(room);
  assert.deepEqual(shown.map(([, ratio]) => read(ratio)), ratios.map((ratio) => Number(ratio.toPrecision(7))));
  assert.deepEqual(shown.slice(1).map(([, , error]) => read(error)), errors.map((error) => Number(error.toPrecision(3))));
}

/** The point of the first picture at an amplitude. */
async function pointAt(room, degrees) {
  await slider(room).scrollIntoViewIfNeeded();
  const { x, y, width, height } = await slider(room).boundingBox();
  return [x + 60 + (degrees / 180) * (width - 60 - 18), y + height / 2];
}

async function agrees(room, amplitude) {
  const [period] = answer("period", amplitude, "--formulas", USUAL, "--sort", "catalogue").results;
  const names = new Map(answer("formulas").formulas.map(({ key, name }) => [key, name]));
  const shown = (await readout(room)).slice(2);
  assert.deepEqual(shown.map(([name]) => name), period.formulas.map(({ key }) => names.get(key)));
  period.formulas.forEach(({ ratio, fractional_error: error }, place) => {
    assert.equal(read(shown[place][1]), Number(ratio.toPrecision(7)));
    assert.equal(read(shown[place][2]), Number(error.toPrecision(3)));
  });
}

test("the readout has the values of mpmath at the amplitude and under the mouse, and returns when the mouse leaves", () =>
  visit("formulas", async (room) => {
    await hasReference(room, 60);
    await room.mouse.move(...(await pointAt(room, 150)));
    await room.getByText("The chosen formulas at 150°").waitFor();
    await hasReference(room, 150);
    await room.mouse.move(5, 300);
    await room.getByText("The chosen formulas at 60°").waitFor();
    await hasReference(room, 60);
    assert.equal(await room.getByLabel("Amplitude", { exact: true }).inputValue(), "60");
  }));

test("a finger moves the amplitude, and one that scrolls the page leaves it", () =>
  visit("formulas", async (room) => {
    await room.touchscreen.tap(...(await pointAt(room, 150)));
    await room.getByText("The chosen formulas at 150°").waitFor();
    await hasReference(room, 150);
    const [x, y] = await pointAt(room, 90);
    const pointer = (type) => slider(room).evaluate((it, [type, clientX, clientY]) => {
      it.setPointerCapture = () => {};
      it.dispatchEvent(new PointerEvent(type, { pointerId: 7, clientX, clientY, bubbles: true }));
    }, [type, x, y]);
    await pointer("pointerdown");
    await room.getByText("The chosen formulas at 90°").waitFor();
    await pointer("pointercancel");
    await room.getByText("The chosen formulas at 150°").waitFor();
    await hasReference(room, 150);
  }, { viewport: { width: 390, height: 844 }, hasTouch: true }));

test("the exact period is drawn and read to screen readers without the large module", () =>
  open(async (room) => {
    await room.addInitScript(() => (window.Worker = class extends EventTarget { postMessage() {} terminate() {} }));
    await room.goto(`${pathToFileURL(page)}#formulas?amplitude=150deg`);
    await room.locator(".plot canvas[aria-label*='0 formulas']").waitFor();
    await slider(room).focus();
    assert.equal(await slider(room).getAttribute("aria-valuetext"), "150°, exact T/T₀ 1.7622");
    await room.keyboard.press("PageDown");
    await room.keyboard.press("PageDown");
    await room.keyboard.press("PageDown");
    // mpmath: 2 K(sin 60°)/π = 1.37288050061835
    assert.equal(await slider(room).getAttribute("aria-valuetext"), "120°, exact T/T₀ 1.3729");
  }));

test("searches run only when the reader opens their part", () =>
  open(async (room) => {
    await room.addInitScript(() => {
      window.asked = [];
      const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function (message, ...rest) {
        if (message.words) window.asked.push(message.words.join(" "));
        return post.call(this, message, ...rest);
      };
    });
    await room.goto(`${pathToFileURL(page)}#formulas`);
    await settled(room);
    const searches = () => room.evaluate(() => window.asked.filter((words) => /--crossovers|--tolerance/.test(words) && !/--formulas small_angle$/.test(words)));
    assert.ok((await room.evaluate(() => window.asked.length)) >= 4);
    assert.deepEqual(await searches(), []);
    await room.getByText("Which formula is good enough?").click();
    await room.getByText("The simplest formula").waitFor();
    assert.equal((await searches()).length, 2);
    await room.getByText("Where does one formula overtake another?").click();
    await rows(room, "Amplitudes at which");
    await settled(room);
    assert.equal((await searches()).length, 3);
  }));

test("both pictures are tables too, with the values of mpmath", () =>
  visit("formulas", async (room) => {
    for (const [summary, caption, row] of [["The curves as a table", "Period T/T₀ against", 60], ["The errors as a table", "Error of each formula", 150]]) {
      await room.getByText(summary).click();
      const cells = (await rows(room, caption)).find(([amplitude]) => amplitude === `${row}°`).slice(1).map(read);
      const { ratios, errors } = REFERENCE[row];
      const expected = row === 60 ? [ratios[0], ...ratios.slice(2)] : errors.slice(1);
      assert.deepEqual(cells, expected.map((value) => Number(value.toPrecision(4))));
    }
  }));

test("a curve has one look in both pictures and in the readout", () =>
  visit("formulas", async (room) => {
    const looks = (all) => all.map((it) => [it.getAttribute("stroke"), it.getAttribute("stroke-width"), it.getAttribute("stroke-dasharray") ?? ""]);
    const drawn = await room.locator(".picture path.curve").evaluateAll(looks);
    const sampled = await room.locator(".comparison .sample path").evaluateAll(looks);
    assert.deepEqual(sampled.slice(2).map(([stroke, ...rest]) => [/#\w+/.exec(stroke)[0], ...rest]), drawn);
  }));

test("nothing is drawn out of sight", () =>
  visit("formulas", async (room) => {
    await room.evaluate(() => scrollTo(0, document.body.scrollHeight));
    await room.locator(".plot canvas").evaluate((canvas) => {
      window.drawn = 0;
      const context = canvas.getContext("2d");
      context.clearRect = () => (window.drawn += 1);
      return new Promise((resolve) => new IntersectionObserver(([entry]) => !entry.isIntersecting && resolve()).observe(canvas));
    });
    await room.getByLabel("Amplitude", { exact: true }).evaluate((field) => {
      field.value = "100deg";
      field.dispatchEvent(new Event("input", { bubbles: true }));
    });
    await settled(room);
    assert.equal(await room.evaluate(() => window.drawn), 0);
    await room.evaluate(() => scrollTo(0, 0));
    await room.waitForFunction(() => window.drawn > 0);
  }));

test("the name of a formula leads to its written form, year and source", () =>
  visit("formulas", async (room) => {
    await room.locator(".comparison").getByRole("button", { name: "Molina" }).click();
    const card = room.locator(".formula-card:focus");
    assert.match(await card.textContent(), /M\. I\. Molina, 1997.*Phys\. Teach\. 35, 489/s);
    assert.equal(await card.locator("math").count(), 2);
    assert.doesNotMatch(await card.textContent(), /pi -|\^/);
  }));

test("the values of the formulas are the command's", () =>
  visit("formulas", async (room) => {
    await agrees(room, "60deg");
    await enter(room, "Amplitude", "pi-1e-6");
    await agrees(room, "pi-1e-6");
  }));

test("a tolerance says which formula suffices, and up to where", () =>
  visit("formulas?amplitude=90deg&tolerance=1e-3&ranges=yes", async (room) => {
    const [simplest] = answer("formulas", "--amplitude", "90deg", "--tolerance", "1e-3").formulas;
    const said = await room.locator(".results").textContent();
    assert.ok(said.includes(`is ${simplest.name}; it holds up to ${Number(((simplest.holds_to_rad * 180) / Math.PI).toPrecision(6))}°`), said);
    assert.equal((await readout(room)).find(([name]) => name === "Bernoulli")[3], "no");
    const [, limit] = (await rows(room, "Amplitudes up to which")).find(([name]) => name === "Bernoulli");
    const bernoulli = answer("formulas", "--tolerance", "1e-3", "--formulas", "bernoulli").formulas[0].holds_to_rad;
    assert.equal(read(limit), Number(((bernoulli * 180) / Math.PI).toPrecision(6)));
  }));

test("crossovers are the command's, in degrees and in radians", () =>
  visit("formulas?formulas=denman,black_vel_3,butikov&crossovers=yes", async (room) => {
    const { crossovers } = answer("formulas", "--crossovers", "--formulas", "denman,black_vel_3,butikov");
    const shown = async () => (await rows(room, "Amplitudes at which")).map(([amplitude]) => parseFloat(amplitude));
    assert.deepEqual(await shown(), crossovers.map(({ amplitude_rad: amplitude }) => Number(((amplitude * 180) / Math.PI).toPrecision(6))));
    await room.getByLabel("Angles in").selectOption("rad");
    await settled(room);
    assert.deepEqual(await shown(), crossovers.map(({ amplitude_rad: amplitude }) => Number(amplitude.toPrecision(6))));
  }));

test("the amplitude moves by keys and by the mouse in both pictures, and a link shows the same again", () =>
  visit("formulas", async (room) => {
    const errors = room.getByRole("slider", { name: /picture of the errors/ });
    for (const its of [slider(room), errors]) {
      await enter(room, "Amplitude", "60");
      await its.focus();
      for (const key of ["ArrowRight", "PageUp", "Shift+ArrowLeft"]) await room.keyboard.press(key);
      await settled(room);
      assert.match(await its.getAttribute("aria-valuetext"), /^70\.9°/);
      await agrees(room, "70.9deg");
    }
    await room.mouse.click(...(await pointAt(room, 120)));
    await settled(room);
    assert.match(await slider(room).getAttribute("aria-valuetext"), /^120°/);
    await errors.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await errors.boundingBox();
    await room.mouse.click(x + width / 2, y + height * 0.6);
    await settled(room);
    assert.doesNotMatch(await errors.getAttribute("aria-valuetext"), /^120°/);
    const shown = await readout(room);
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.deepEqual(await readout(again), shown));
  }));

test("numbers without a unit have that of the switch, on the axis of the picture too", () =>
  visit("formulas", async (room) => {
    await enter(room, "Amplitude", "45");
    await agrees(room, "45deg");
    await room.getByText("Axes of the pictures").click();
    await enter(room, "to", "90");
    const drawn = async () => (await saved(room, "Save the picture as SVG")).bytes.toString();
    const ninety = command("figure", "errors", "--formulas", USUAL, "--to", "90deg", "--output", "-").output;
    assert.equal(await drawn(), ninety);
    assert.equal(await slider(room).getAttribute("aria-valuemax"), "90");
    await room.getByLabel("Angles in").selectOption("rad");
    await settled(room);
    await agrees(room, "45deg");
    assert.equal(await drawn(), ninety);
    await enter(room, "Amplitude", "0.75");
    await agrees(room, "0.75rad");
    await enter(room, "to", "1.5");
    assert.equal(await drawn(), command("figure", "errors", "--formulas", USUAL, "--to", "1.5rad", "--output", "-").output);
    assert.ok(Math.abs(Number(await slider(room).getAttribute("aria-valuemax")) - (1.5 * 180) / Math.PI) < 0.05);
    const shown = await readout(room);
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.deepEqual(await readout(again), shown));
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
    await slider(room).focus();
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
