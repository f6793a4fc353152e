// Room 6 compared with the command: diagrams, sections, neighbours and verdicts, and invalid entries.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, command, enter, errors, PHONE, saved, settled, visit } from "./harness.mjs";

after(close);
const SYSTEM = ["driven_pendulum", "--initial", "theta=0.2"];
const SMALL = "chaos?over=A%3D1:1.5:0.05&each=10&points=300&intervals=100";

test("pictures and verdict are the command's", () =>
  visit(SMALL, async (room) => {
    const at = ["driven_pendulum", "--set", "c=1/2,A=1.2"];
    const asked = [
      ["bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2", "--over", "A=1:1.5:0.05", "--points", "10", "--sweep", "both", "--figure", "-"],
      ["section", ...at, "--initial", "theta=0.2", "--initial", "theta=0.2001", "--points", "300", "--figure", "-"],
      ["figure", "trajectories", ...at, "--initial", "theta=0.2", "--initial", "theta=0.2001", "--to", "100", "--output", "-"],
      ["lyapunov", ...at, "--initial", "theta=0.2", "--intervals", "100", "--figure", "-"],
      ["orbit", ...at, "--initial", "theta=0.2", "--figure", "-"],
    ];
    const buttons = room.getByRole("button", { name: "Save the picture as SVG" });
    assert.equal(await buttons.count(), asked.length);
    for (const [place, words] of asked.entries()) {
      const [download] = await Promise.all([room.waitForEvent("download"), buttons.nth(place).click()]);
      const parts = [];
      for await (const part of await download.createReadStream()) parts.push(part);
      assert.equal(Buffer.concat(parts).toString(), command(...words).output, words[0]);
    }
    const { verdict, reason } = answer("lyapunov", ...at, "--initial", "theta=0.2", "--intervals", "100");
    assert.equal((await room.locator("p.verdict").textContent()).toLowerCase(), `${verdict}: ${reason}.`.toLowerCase());
  }));

test("a value is chosen in the diagram by keys and by the mouse, and a link shows it again", () =>
  visit(SMALL, async (room) => {
    const slider = room.getByRole("slider", { name: "in the diagram" });
    await slider.focus();
    await room.keyboard.press("ArrowRight");
    await settled(room);
    assert.equal(await slider.getAttribute("aria-valuetext"), "A = 1.25");
    const { width, height } = await slider.boundingBox();
    // By its own position: what is drawn above may still move it.
    await slider.click({ position: { x: width * 0.8, y: height / 2 } });
    await settled(room);
    const chosen = await slider.getAttribute("aria-valuetext");
    assert.notEqual(chosen, "A = 1.25");
    const verdict = await room.locator("p.verdict").textContent();
    await visit(new URL(room.url()).hash.slice(1), async (again) => {
      assert.equal(await again.getByRole("slider", { name: "in the diagram" }).getAttribute("aria-valuetext"), chosen);
      assert.equal(await again.locator("p.verdict").textContent(), verdict);
    });
  }));

test("what is shown stays when a long section is stopped", () =>
  visit("chaos?over=&value=&set=c%3D1/2,A%3D1.5&points=100", async (room) => {
    await room.getByLabel("Points of the section", { exact: true }).fill("10000000");
    await room.getByRole("button", { name: "Stop" }).click();
    await settled(room);
    const { bytes } = await saved(room, "Save the picture as SVG");
    assert.match(bytes.toString(), /<path class="markers"/);
    await enter(room, "Points of the section", "50");
    assert.deepEqual(await errors(room), []);
  }));

test("each system to begin with has its pictures and its verdict", () =>
  visit(SMALL, async (room) => {
    const begin = room.getByLabel("Example");
    for (const value of ["stars", "double", "upright", "threshold", "springs", "thirds", "jumps", "lorenz"]) {
      await begin.selectOption(value);
      await settled(room);
      assert.deepEqual(await errors(room), [], value);
      assert.match(await room.locator("p.verdict").textContent(), /^(Regular|Chaotic|Undecided): /);
      assert.equal(await begin.inputValue(), value);
    }
  }));

/** The verdict. */
const verdict = (room) => room.locator("p.verdict").textContent();
const entry = (room, label) => room.getByLabel(label, { exact: true }).inputValue();
const QUICKLY = "points=20&intervals=300&until=5&each=5";

test("the motion stays the same when the range of its parameter is taken away", () =>
  visit(`chaos?set=c%3D1/2&value=1.2&over=A%3D1:1.5:0.1&${QUICKLY}`, async (room) => {
    const chaotic = await verdict(room);
    assert.match(chaotic, /^Chaotic: /);
    await enter(room, "Range of a parameter", "");
    assert.equal(await verdict(room), chaotic);
    assert.equal(await entry(room, "Values of parameters"), "c=1/2,A=1.2");
    assert.equal(await entry(room, "Value of the parameter"), "");
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.equal(await verdict(again), chaotic));
    await enter(room, "Range of a parameter", "A=1:1.5:0.1");
    assert.equal(await verdict(room), chaotic);
    assert.equal(await entry(room, "Values of parameters"), "c=1/2");
    assert.equal(await entry(room, "Value of the parameter"), "1.2");
    assert.ok(await part(room, "Bifurcation diagram").locator(".picture-slider").evaluate((it) => it.querySelector(".picture").shadowRoot.querySelector("svg") !== null));
  }));

test("the motion stays the same when the range gets another parameter", () =>
  visit(`chaos?set=c%3D1/2,omega%3D0.7&value=1.2&over=A%3D1:1.5:0.1&${QUICKLY}`, async (room) => {
    const before = await verdict(room);
    await enter(room, "Range of a parameter", "omega=0.6:0.8:0.1");
    assert.equal(await verdict(room), before);
    const slider = room.getByRole("slider", { name: "Value of omega in the diagram" });
    assert.equal(await slider.getAttribute("aria-valuetext"), "omega = 0.7");
    assert.equal(await entry(room, "Values of parameters"), "c=1/2,A=1.2");
    assert.equal(await entry(room, "Value of the parameter"), "0.7");
    await enter(room, "Range of a parameter", "omega0=1:1.2:0.1");
    assert.equal(await verdict(room), before);
    assert.deepEqual(await errors(room), []);
    assert.equal(await room.getByRole("slider", { name: "Value of omega0 in the diagram" }).getAttribute("aria-valuetext"), "no value chosen");
    await enter(room, "Range of a parameter", "");
    assert.equal(await room.getByRole("slider", { name: "in the diagram" }).count(), 0);
  }));

test("letter by letter the range changes no more than at once", () =>
  visit(`chaos?set=c%3D1/2&value=1.2&over=A%3D1:1.5:0.1&${QUICKLY}`, async (room) => {
    const before = await verdict(room);
    const field = room.getByLabel("Range of a parameter", { exact: true });
    await field.focus();
    await room.keyboard.press("End");
    for (let left = (await field.inputValue()).length; left > 0; left -= 1) await room.keyboard.press("Backspace", { delay: left === 5 ? 500 : 20 });
    await settled(room);
    assert.equal(await verdict(room), before);
    await room.keyboard.type("omega=0.6:0.8:0.1", { delay: 60 });
    await settled(room);
    assert.equal(await verdict(room), before);
    assert.equal(await entry(room, "Values of parameters"), "c=1/2,A=1.2");
  }));

test("numbers are saved where there are some, and nowhere else", () =>
  visit(`chaos?set=c%3D1/2,A%3D0.5&value=&over=&${QUICKLY}`, async (room) => {
    const csv = (title) => part(room, title).getByRole("button", { name: "Save the numbers as CSV" });
    assert.equal(await csv("Bifurcation diagram").count(), 0);
    for (const title of ["Poincaré section", "Order or chaos?", "Periodic orbit"]) assert.ok((await saved(part(room, title), "Save the numbers as CSV")).bytes.length > 20, title);
    await enter(room, "Range of a parameter", "A=0.4:0.6:0.1");
    const { bytes } = await saved(part(room, "Bifurcation diagram"), "Save the numbers as CSV");
    assert.equal(bytes.toString(), command("bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2", "--over", "A=0.4:0.6:0.1", "--points", "5", "--sweep", "both", "--csv").output);
    await enter(room, "Range of a parameter", "A=0.4:0.6");
    assert.equal(await csv("Bifurcation diagram").count(), 0);
    await enter(room, "System or equation", "nonsense");
    for (const title of ["Poincaré section", "Order or chaos?", "Periodic orbit", "Bifurcation diagram"]) assert.equal(await csv(title).count(), 0, title);
  }));

test("what cannot be computed is answered beside its field", () =>
  visit(SMALL, async (room) => {
    for (const [label, entry, said] of [
      ["System or equation", "nonsense", /no system has the key/],
      ["System or equation", "driven_pendulum", undefined],
      ["Initial states", "q=1", /has no state variable/],
      ["Initial states", "theta=0.2", undefined],
      ["Values of parameters", "c=foo", /contains foo/],
      ["Values of parameters", "c=1/2", undefined],
      ["Range of a parameter", "A=1:2", /give START:STOP:STEP/],
      ["Range of a parameter", "A=1:1.5:0.05", undefined],
      ["Points of the section", "many", /give a whole number/],
    ]) {
      await enter(room, label, entry);
      if (said === undefined) assert.deepEqual(await errors(room), []);
      else assert.match((await errors(room))[0] ?? "", said);
      assert.equal((await room.getByLabel(label, { exact: true }).getAttribute("aria-invalid")) === "true", said !== undefined, entry);
    }
  }));

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

/** The part of the results with this title. */
const part = (room, title) => room.locator("section", { has: room.getByRole("heading", { name: title, exact: true }) });

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

/** Records the first words of the queries of a room. */
async function listening(room) {
  await room.evaluate(() => {
    const post = Worker.prototype.postMessage;
    globalThis.asked = [];
    Worker.prototype.postMessage = function (message, ...more) {
      if (message.kind === "question") globalThis.asked.push(message.words[0]);
      return post.call(this, message, ...more);
    };
  });
  return () => room.evaluate(() => globalThis.asked.splice(0));
}

test("nothing further is asked unasked, nor again while it stays the same", () =>
  visit(SMALL, async (room) => {
    const asked = await listening(room);
    await enter(room, "Value of the parameter", "1.25");
    const first = await asked();
    assert.ok(first.includes("section") && first.includes("lyapunov"), first.join(" "));
    assert.deepEqual(first.filter((it) => ["response", "stability", "melnikov", "resonance"].includes(it)), []);
    // With keys, the part is unfolded, and its first field is next.
    await room.locator("summary", { hasText: "Thresholds of chaos" }).focus();
    await room.keyboard.press("Enter");
    await room.keyboard.press("Tab");
    await room.keyboard.type("A=0.1:1.5");
    await settled(room);
    assert.ok((await asked()).includes("melnikov"));
    assert.ok(await part(room, "Melnikov's thresholds").locator("svg").isVisible());
    await enter(room, "Value of the parameter", "1.3");
    const again = await asked();
    assert.ok(again.includes("section") && !again.includes("melnikov"), again.join(" "));
    await visit(new URL(room.url()).hash.slice(1), async (other) => {
      assert.ok(await part(other, "Melnikov's thresholds").locator("svg").isVisible());
      assert.ok(await other.getByLabel("Range of a parameter for thresholds").isVisible());
    });
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

test("a picture that needs more room than a phone has is drawn smaller", () =>
  visit(`${SMALL}&value=1.407&motions=20`, async (room) => {
    assert.notEqual(command("section", SYSTEM[0], "--set", "c=1/2,A=1.407", "--initial", "theta=0.2", "--initial", "theta=0.2001", "--points", "300", "--size", "column", "--figure", "-").status, 0);
    assert.deepEqual(await errors(room), []);
    assert.ok(await room.locator("p.verdict").isVisible());
  }, { viewport: PHONE }));

test("the numbers of the section are saved", () =>
  visit(SMALL, async (room) => {
    const button = room.locator("section", { hasText: "Poincaré section" }).getByRole("button", { name: "CSV" });
    const [download] = await Promise.all([room.waitForEvent("download"), button.click()]);
    const parts = [];
    for await (const part of await download.createReadStream()) parts.push(part);
    const words = ["section", SYSTEM[0], "--set", "c=1/2,A=1.2", "--initial", "theta=0.2", "--initial", "theta=0.2001", "--points", "300", "--csv"];
    assert.equal(Buffer.concat(parts).toString(), command(...words).output);
  }));

const DRIVEN = "chaos?over=&value=&set=c%3D1/2,A%3D1.2&initial=theta%3D0.2;theta%3D0.2001&points=20&intervals=10&until=5&motions=20";

test("sliders change the drive and the friction, and a pendulum that runs swings on", () =>
  visit(DRIVEN, async (room) => {
    const time = () => room.evaluate(() => Number(/t = ([\d.]+) s/.exec(document.querySelector(".fleet-words")?.textContent ?? "")?.[1]));
    const after = (least) => room.waitForFunction((least) => Number(/t = ([\d.]+) s/.exec(document.querySelector(".fleet-words")?.textContent ?? "")?.[1]) > least, least, { timeout: 60_000 });
    const slider = room.getByRole("slider", { name: "Strength of the drive" });
    assert.equal(await slider.getAttribute("aria-valuetext"), "A = 1.2 1/s²");
    await room.getByLabel("Speed").selectOption("5");
    await room.getByRole("button", { name: "Run the ensemble" }).click();
    await after(5);
    await slider.focus();
    await room.keyboard.press("ArrowLeft");
    assert.equal(await slider.getAttribute("aria-valuetext"), "A = 1.195 1/s²");
    await room.waitForFunction(() => Number(/t = ([\d.]+) s/.exec(document.querySelector(".fleet-words").textContent)?.[1]) < 5);
    await after(1);
    assert.ok(await room.getByRole("button", { name: "Pause the ensemble" }).isVisible());
    assert.equal(await entry(room, "Values of parameters"), "c=1/2,A=1.195");
    await slider.fill("0.9");
    await room.getByRole("slider", { name: "Friction" }).fill("0.5");
    await settled(room);
    assert.equal(await entry(room, "Values of parameters"), "A=0.9,c=0.5");
    assert.match(await room.locator("p.verdict").textContent(), /^(Regular|Undecided)/);
    const { hash } = new URL(room.url());
    await visit(`${hash.slice(1)}&time=10`, async (again) => {
      await again.waitForFunction(() => document.querySelector(".fleet-words")?.textContent.includes("t = 10.00 s"), null, { timeout: 60_000 });
      const { bytes } = await saved(again, "Save the states as CSV");
      const [, , theta, velocity] = bytes.toString().split("\n")[1].split(",").map(Number);
      // θ″ = −θ′/2 − sin θ + 0.9 cos(2t/3) from θ = 0.2 at rest, by mpmath's Taylor integration with 25 digits.
      assert.ok(Math.abs(theta - 1.6471867024) < 1e-6 && Math.abs(velocity - 0.8544171885) < 1e-6, `${theta} ${velocity}`);
    });
    assert.ok((await time()) >= 0);
  }));

test("the diagram follows one attractor at a time, or both in two colours", () =>
  visit(`${SMALL}&motions=20`, async (room) => {
    const diagram = part(room, "Bifurcation diagram");
    const colours = () => diagram.locator(".picture").evaluate((it) => it.shadowRoot.querySelectorAll("path.markers").length);
    assert.equal(await colours(), 2);
    await diagram.getByRole("button", { name: "up", exact: true }).click();
    await settled(room);
    assert.equal(await colours(), 1);
    assert.match(new URL(room.url()).hash, /sweep=up/);
    assert.equal(await diagram.getByRole("button", { name: "up", exact: true }).getAttribute("aria-pressed"), "true");
    const { bytes } = await saved(diagram, "Save the picture as SVG");
    assert.equal(bytes.toString(), command("bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2", "--over", "A=1:1.5:0.05", "--points", "10", "--sweep", "up", "--figure", "-").output);
  }));

test("pictures have their numbers as tables", () =>
  visit(`${SMALL}&motions=20`, async (room) => {
    for (const title of ["Bifurcation diagram", "Poincaré section", "Neighbouring motions", "Order or chaos?", "Periodic orbit", "The motion and its neighbours"]) {
      const found = part(room, title);
      await found.getByText("Numbers as a table").click();
      await found.locator("tbody tr").first().waitFor();
    }
    const { samples } = answer("simulate", "driven_pendulum", "--set", "c=1/2,A=1.2", "--initial", "theta=0.2", "--times", "0:100:2");
    const shown = await part(room, "Neighbouring motions").locator("tbody tr").nth(3).locator("th, td").allTextContents();
    assert.equal(Number(shown[0]), 6);
    assert.ok(Math.abs(Number(shown[1].replace("−", "-")) - samples[3].state[0]) < 1e-3);
  }));

test("out of sight nothing is drawn", () =>
  visit(DRIVEN, async (room) => {
    await room.evaluate(() => {
      globalThis.drawn = 0;
      const { clearRect } = CanvasRenderingContext2D.prototype;
      CanvasRenderingContext2D.prototype.clearRect = function (...all) {
        globalThis.drawn += 1;
        return clearRect.apply(this, all);
      };
    });
    await room.getByRole("button", { name: "Run the ensemble" }).click();
    await room.waitForFunction(() => globalThis.drawn > 20);
    await room.getByText("Equivalent command").scrollIntoViewIfNeeded();
    const seen = () => room.evaluate(() => new Promise((resolve) => {
      const sight = new IntersectionObserver((all) => resolve(all.some((it) => it.isIntersecting)));
      document.querySelectorAll(".fleet canvas").forEach((it) => sight.observe(it));
    }));
    assert.equal(await seen(), false);
    const before = await room.evaluate(() => globalThis.drawn);
    const text = await room.locator(".fleet-words").textContent();
    await room.waitForFunction((text) => document.querySelector(".fleet-words").textContent !== text, text);
    assert.equal(await room.evaluate(() => globalThis.drawn), before);
    await room.locator(".fleet").scrollIntoViewIfNeeded();
    await room.waitForFunction((before) => globalThis.drawn > before, before);
  }));

test("neither examples nor messages have options, keys or backticks", () =>
  visit(`${SMALL}&motions=20`, async (room) => {
    for (const name of await room.getByLabel("Example").locator("option").allTextContents()) assert.doesNotMatch(name, /_|`|--/);
    for (const [label, wrong] of [["System or equation", "nonsense"], ["System or equation", "x'' = q"], ["Initial states", "q=1"], ["Values of parameters", "c="], ["Values of parameters", "c=foo"], ["Range of a parameter", "A=1:2"], ["Points of the section", "many"], ["Section at zeros of the formula", "1/"]]) {
      const before = await entry(room, label);
      await enter(room, label, wrong);
      const said = [...(await errors(room)), ...(await room.locator(".results .quiet:visible").allTextContents())].join(" ");
      assert.ok(said.length > 10, wrong);
      assert.doesNotMatch(said, /`|--[a-z]/, wrong);
      await enter(room, label, before);
    }
  }));
