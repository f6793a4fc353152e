// The analyses of room 6 compared with the command: periodic orbits, responses, maps of stability, thresholds of chaos, exchanges between modes.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, command, enter, errors, part, saved, settled, visit } from "./harness.mjs";

after(close);
test("the periodic orbit and the answers over a parameter are the command's", () =>
  visit("chaos?set=A%3D0.15,c%3D0.1&initial=theta%3D0&over=&value=&points=20&intervals=10&until=5&response=omega%3D0.75:0.9", async (room) => {
    await room.waitForFunction(() => document.querySelector(".results")?.getAttribute("aria-busy") === "false");
    const system = ["driven_pendulum", "--set", "A=0.15,c=0.1", "--initial", "theta=0"];
    const orbit = answer("orbit", ...system);
    assert.match(await part(room, "Periodic orbit").innerText(), new RegExp(`period is ${orbit.period_s.toPrecision(9)} s. It is stable`));
    const { jumps } = answer("response", ...system, "--over", "omega=0.75:0.9");
    assert.equal(jumps.length, 2);
    const said = await part(room, "Periodic responses over a parameter").innerText();
    for (const { parameter, sweep } of jumps) assert.ok(said.includes(`Sweep ${sweep}: the amplitude jumps at omega = ${parameter.toPrecision(6)}`), said);
    for (const [title, words] of [["Periodic orbit", ["orbit", ...system, "--figure", "-"]], ["Periodic responses over a parameter", ["response", ...system, "--over", "omega=0.75:0.9", "--figure", "-"]]]) {
      const { bytes } = await saved(part(room, title), "Save the picture as SVG");
      assert.equal(bytes.toString(), command(...words).output, title);
    }
    await enter(room, "Range of a parameter for the response", "omega=1:2:0.1");
    assert.match((await errors(room)).join(" "), /FROM:TO/);
  }));

/** A number as the page writes it, with `count` digits, and a round one without trailing zeros. */
const written = (value, count) => value.toPrecision(count).replace("-", "−");
const short = (value) => String(Number(value.toPrecision(6))).replace("-", "−");

/** Asserts that the saved files of a part are those of the command. */
async function savedAsAsked(place, words) {
  const { bytes } = await saved(place, "Save the picture as SVG");
  assert.equal(bytes.toString(), command(...words, "--figure", "-").output);
  const table = await saved(place, /CSV/);
  assert.equal(table.bytes.toString(), command(...words, "--csv").output);
}

const QUICK = "over=&value=&points=20&intervals=10&until=5";
const UPRIGHT = `chaos?system=kapitza&set=c%3D0.1&initial=theta%3D170deg&${QUICK}&map=omega%3D5:20,a%3D0.02:0.6&rest=theta%3D180deg&lines=0`;

test("a map of stability is the command's, with its edges in words", () =>
  visit(UPRIGHT, async (room) => {
    const words = ["stability", "kapitza", "--set", "c=0.1", "--initial", "theta=180deg", "--map", "omega=5:20,a=0.02:0.6", "--lines", "0"];
    const { rest_stable_at: ends, curves } = answer(...words);
    const map = part(room, "Stability over two parameters");
    const said = await map.innerText();
    assert.equal(ends.length, 2);
    for (const { value, ranges } of ends) assert.ok(said.includes(`At omega = ${short(value)} the state at rest is stable for a from ${short(ranges[0][0])} to ${short(ranges[0][1])}.`), said);
    assert.equal(await map.locator("li").count(), curves.length);
    for (const [place, { points }] of curves.entries()) {
      const [first, last] = [points[0], points.at(-1)].map(({ parameters: [omega, a] }) => `omega = ${short(omega)}, a = ${short(a)}`);
      const curve = await map.locator("li").nth(place).textContent();
      assert.ok(curve.startsWith("Stability boundary of the state at rest") && curve.includes(first) && curve.includes(last), curve);
    }
    await savedAsAsked(map, words);
    await enter(room, "Ranges of two parameters", "");
    assert.equal(await map.isVisible(), false);
  }));

test("a curve between unstable regions is not called a stability boundary, nor is a part of one", () =>
  visit(`chaos?system=x''%2B0.05*x'%2B(d%2Be*cos(t))*x%3D0;y''%2B(d-0.33)*y'%2B2*y%3D0&set=d%3D0.2,e%3D0.2&initial=x%3D0&${QUICK}&map=d%3D0.1:0.6,e%3D0.1:0.4&lines=0`, async (room) => {
    const curves = await part(room, "Stability over two parameters").locator("li").allTextContents();
    assert.deepEqual(curves.map((curve) => curve.split(": ")[0]), [
      "State at rest, unstable on both sides (period doubling)",
      "State at rest, in part a stability boundary (period doubling)",
      "State at rest, in part a stability boundary (Neimark–Sacker bifurcation)",
    ]);
  }));

test("a cusp is told where folds meet, and a parameter of the map has no value beside it", () =>
  visit(`chaos?set=A%3D0.15,c%3D0.1&initial=theta%3D0&${QUICK}&map=omega%3D0.85:1,A%3D0.05:0.2&lines=1`, async (room) => {
    const words = ["stability", "driven_pendulum", "--set", "c=0.1", "--map", "omega=0.85:1,A=0.05:0.2", "--lines", "1"];
    const [{ cusps }] = answer(...words).curves;
    const [omega, drive] = cusps[0].parameters;
    const said = await part(room, "Stability over two parameters").innerText();
    assert.ok(said.includes(`Driven motions (fold, where a slow sweep jumps): from`) && said.includes(`through a cusp at omega = ${short(omega)}, A = ${short(drive)}`), said);
    await room.getByText("Equivalent command").click();
    assert.ok((await room.locator("pre code").first().textContent()).includes(`libration ${words.join(" ")}\n`) || (await room.locator("pre code").first().textContent()).endsWith(`libration ${words.join(" ")}`));
  }));

test("Melnikov's thresholds are the command's, beside where the manifolds touch", () =>
  visit(`chaos?set=c%3D1/4&initial=theta%3D0.2&${QUICK}&thresholds=A%3D0.1:1`, async (room) => {
    const words = ["melnikov", "driven_pendulum", "--set", "c=1/4", "--over", "A=0.1:1", "--max-drive-periods", "5"];
    const { thresholds, resonances } = answer(...words);
    const found = part(room, "Melnikov's thresholds");
    const said = await found.innerText();
    assert.equal(thresholds.length, 2);
    for (const { value, tangency } of thresholds) {
      assert.ok(said.includes(`cross above A = ${written(value, 8)}, to`), said);
      assert.ok(said.includes(`manifolds are tangent at A = ${written(tangency, 8)}, to`), said);
    }
    const overlaps = resonances.map(({ overlap }) => overlap).filter((overlap) => overlap !== null);
    assert.ok(said.includes(`Of ${overlaps.length} pairs of neighbouring resonances ${overlaps.filter((overlap) => overlap > 2 / 3).length} overlap`), said);
    assert.equal(await found.locator("tbody tr").count(), resonances.length);
    await savedAsAsked(found, words);
    await enter(room, "Range of a parameter for thresholds", "A=0.01:0.1");
    assert.match(await found.innerText(), /There is no threshold in the range/);
  }));

test("the exchange between modes is the command's, with its resonances and its depth", () =>
  visit(`chaos?system=spring_pendulum&set=kappa%3D3&initial=r%3D1.3733,theta%3D0.04&at=theta&${QUICK}&order=3`, async (room) => {
    const words = ["resonance", "spring_pendulum", "--set", "kappa=3", "--initial", "r=1.3733,theta=0.04", "--order", "3"];
    const { exchange, slow_terms: terms } = answer(...words);
    const found = part(room, "Exchange between modes");
    const said = await found.innerText();
    assert.ok(said.includes(`One exchange takes ${written(exchange.measured_period_s, 10)} s, to`), said);
    assert.ok(said.includes(`By the slow flow it takes ${written(exchange.period_s, 10)} s, to`), said);
    const resonant = terms.filter(({ kind }) => kind === "resonance").map(({ monomial, mode }) => `${monomial} in a${mode}′`);
    assert.ok(resonant.length === 2 && said.includes(`by resonant terms: ${resonant.join(", ")}.`), said);
    assert.deepEqual(await found.locator("tbody td:first-of-type").allTextContents(), terms.map(({ exact }) => exact));
    for (const [place, [least, most]] of exchange.amplitudes.entries()) assert.ok(said.includes(`The amplitude of mode ${place + 1} varies from ${written(least, 4)} to ${written(most, 4)}: the mode gives away ${written(100 * (1 - (least / most) ** 2), 3)} %`), said);
    await savedAsAsked(found, words);
    await enter(room, "Values of parameters", "kappa=10");
    assert.match(await found.innerText(), /No exchange: no two modes are in resonance/);
    assert.deepEqual(await errors(room), []);
  }));

test("answers at a part of the drive's frequency are looked for", () =>
  visit(`chaos?system=x%27%27%20%2B%200.15%20x%27%20%2B%20x%20%2B%20x^3%20%3D%205%20cos(w%20t)&set=w%3D4.5&initial=x%3D0&${QUICK}&response=w%3D4:5&orders=1/3,1/30`, async (room) => {
    const found = part(room, "Periodic responses over a parameter");
    const said = await found.innerText();
    assert.match(said, /Order 1\/3: 2 branches found from free oscillations\./);
    assert.match(said, /Order 1\/30: no free oscillation has this fraction of the drive frequency\./);
    await savedAsAsked(found, ["response", "x'' + 0.15 x' + x + x^3 = 5 cos(w t)", "--initial", "x=0", "--over", "w=4:5", "--orders", "1/3,1/30"]);
    await enter(room, "Orders of subharmonic responses", "third");
    assert.match((await errors(room)).join(" "), /third/);
  }));

test("a question without an answer says so in the command's words, where it is asked", () =>
  visit(`chaos?system=lorenz&set=&initial=x%3D1,y%3D1,z%3D1&at=z-27&${QUICK}`, async (room) => {
    const titles = ["Melnikov's thresholds", "Exchange between modes", "Stability over two parameters", "Periodic responses over a parameter"];
    for (const title of titles) assert.equal(await part(room, title).isVisible(), false, title);
    for (const summary of ["Thresholds of chaos", "Exchange between modes", "Stability map"]) await room.locator("summary", { hasText: summary }).click();
    for (const [title, label, entry, words] of [
      [titles[0], "Range of a parameter for thresholds", "rho=1:2", ["melnikov", "lorenz", "--over", "rho=1:2"]],
      [titles[1], "Order in the amplitudes", "3", ["resonance", "lorenz", "--order", "3", "--initial", "x=1,y=1,z=1"]],
      [titles[2], "Ranges of two parameters", "rho=1:2,sigma=1:2", ["stability", "lorenz", "--map", "rho=1:2,sigma=1:2"]],
    ]) {
      await enter(room, label, entry);
      // The same sentence, without the name of the option and with the quotation marks of the page.
      const said = command(...words).error.replace(/^error: /, "").trim().replace(/^[-A-Z|a-z]+: /, "").replace(/`([^`]*)`/g, "“$1”");
      assert.ok((await part(room, title).locator("p.quiet").textContent()) === said, said);
      assert.deepEqual(await errors(room), []);
    }
    assert.ok(await room.locator("p.verdict").isVisible());
  }));

test("what is wrong in a folded part is said beside its field", () =>
  visit(`chaos?set=c%3D0.1,A%3D0.3&initial=theta%3D0&${QUICK}`, async (room) => {
    for (const summary of ["Thresholds of chaos", "Exchange between modes", "Stability map"]) await room.locator("summary", { hasText: summary }).click();
    for (const [label, entry, said, mended] of [
      ["Ranges of two parameters", "omega", /two parameters/, "omega=0.9:1,A=0.05:0.1"],
      ["Lines for the continuation of driven motions", "-1", /whole number from 0/, "0"],
      ["State at rest", "q=1", /no state variable/, ""],
      ["Range of a parameter for thresholds", "A=1", /FROM:TO/, "A=0.1:1"],
      ["Resonances p:q up to q", "0", /whole number/, "2"],
      ["Order in the amplitudes", "x", /from 1 to 9/, ""],
    ]) {
      await enter(room, label, entry);
      const all = await errors(room);
      assert.ok(all.length === 1 && said.test(all[0]), `${label}: ${all.join(" ")}`);
      assert.equal(await room.getByLabel(label, { exact: true }).getAttribute("aria-invalid"), "true", label);
      await enter(room, label, mended);
      assert.deepEqual(await errors(room), [], label);
    }
  }));

test("a map that is stopped keeps the curves up to then", () =>
  visit(`chaos?set=c%3D0.1&initial=theta%3D0&${QUICK}`, async (room) => {
    await room.locator("summary", { hasText: "Stability map" }).click();
    await room.getByLabel("Lines for the continuation of driven motions").fill("30");
    await room.getByLabel("Ranges of two parameters").fill("omega=0.3:2,A=0.05:3");
    await room.getByText("points of the curve").waitFor();
    await room.waitForTimeout(2000);
    await room.getByRole("button", { name: "Stop" }).click();
    await settled(room);
    const map = part(room, "Stability over two parameters");
    assert.ok(await map.locator("svg").isVisible());
    assert.ok((await map.locator("p, li").count()) > 0);
    await enter(room, "Ranges of two parameters", "omega=0.9:1,A=0.05:0.1");
    assert.deepEqual(await errors(room), []);
  }));
