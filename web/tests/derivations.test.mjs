// Room 4 compared with the command: the text of each method, its steps, links to formulas, exercises, and both documents.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, command, DESK, enter, errors, PHONE, saved, settled, visit } from "./harness.mjs";

after(close);

/** The text of the body of a page, without spaces. */
const inBody = (room, page) =>
  room.evaluate((source) => {
    const { body } = new DOMParser().parseFromString(source.replaceAll(/<style>[^]*?<\/style>/g, ""), "text/html");
    return body.textContent.replaceAll(/\s/g, "");
  }, page);
const shown = (room) => room.locator(".derivation").evaluate((it) => {
  const text = it.cloneNode(true);
  text.querySelectorAll("form").forEach((form) => form.remove());
  return text.textContent.replaceAll(/\s/g, "");
});

const DRIVEN = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)";
for (const [fragment, words, names = {}] of [
  ["road=elliptic&amplitude=40deg&length=57cm", ["--method", "elliptic", "--amplitude", "40deg", "--length", "57cm"]],
  ["amplitude=40deg", ["--method", "short", "--amplitude", "40deg"]],
  ["road=elliptic&exercises=yes", ["--method", "elliptic", "--exercises"]],
  ["road=formulas", ["--method", "formulas"], { kidd_fogg: "Kidd-Fogg", carvalhaes_suppes: "Carvalhaes-Suppes", black_vel_2: "Fourier-perturbation (2)", black_vel_3: "Fourier-perturbation (3)" }],
  ["road=perturbation&oscillator=duffing&order=3", ["--method", "perturbation", "duffing", "--order", "3"]],
  ["road=averaging&set=n%3D2&order=3", ["--method", "averaging", "--set", "n=2", "--order", "3"]],
  ["road=limit-cycle", ["--method", "limit-cycle"]],
  [`road=averaging&resonance=1%2F1&oscillator=${encodeURIComponent(DRIVEN)}`, ["--method", "averaging", "--resonance", "1/1", DRIVEN]],
]) {
  test(`the derivation of ${fragment} is the command's, word by word`, () =>
    visit(`derivations?${fragment}`, async (room) => {
      const { output } = command("derive", ...words, "--format", "html");
      for (const key of Object.keys(names)) assert.ok(output.includes(key), key);
      assert.equal(await shown(room), await inBody(room, Object.entries(names).reduce((page, [key, name]) => page.replaceAll(key, name), output)));
    }));
}

test("the room begins with the first correction, which ends in the sixteenth", () =>
  visit("derivations", async (room) => {
    assert.equal(await room.getByLabel("Derivation").inputValue(), "short");
    assert.equal(await room.locator(".derivation .title").textContent(), "The first correction to the period of a pendulum");
    await room.getByRole("button", { name: "Open all steps" }).click();
    // T/T₀ − 1 by mpmath, 2K(sin 10°)/π − 1 = 0.00766904, and (π/9)²/16 = 0.00761544, each to four digits.
    const [, exact, first] = await room.locator(".derivation tbody tr").nth(2).evaluate((row) => [...row.children].map((cell) => cell.textContent));
    assert.deepEqual([exact, first], ["0.007669", "0.007615"]);
  }));

for (const [fragment, viewport] of [["derivations?steps=all", DESK], ["derivations?steps=all", PHONE], ["derivations?road=elliptic&steps=all", PHONE], ["formulas?formulas=cubic_force,agm_b2,pade_sin2_2,lima_2008", PHONE], ["perturbation", PHONE]]) {
  test(`no letter of a formula is smaller than 11 px in ${fragment}, ${viewport.width} px`, () =>
    visit(fragment, async (room) => {
      const sizes = await room.locator(".results math :is(mi, mn, mo, mtext)").evaluateAll((all) => all.map((it) => parseFloat(getComputedStyle(it).fontSize)));
      assert.ok(sizes.length > 40);
      assert.ok(Math.min(...sizes) >= 11, `${Math.min(...sizes)} px`);
    }, { viewport }));
}

test("an amplitude without a unit is in the degrees that the derivation shows, and plain where the variable is no angle", () =>
  visit("derivations?road=elliptic&amplitude=45", async (room) => {
    const unit = () => room.locator(".field", { has: room.getByLabel("Your amplitude", { exact: true }) }).locator(".unit").textContent();
    const derived = async (...words) => assert.equal(await shown(room), await inBody(room, command("derive", ...words, "--format", "html").output));
    assert.equal(await unit(), "°");
    await derived("--method", "elliptic", "--amplitude", "45deg");
    await room.getByLabel("Derivation").selectOption("perturbation");
    await enter(room, "Equation of motion", "duffing");
    await enter(room, "Your amplitude", "0.4");
    assert.equal(await unit(), "");
    await derived("--method", "perturbation", "duffing", "--amplitude", "0.4");
  }));

test("steps open one after the other by the keyboard, and a link leads to a formula", () =>
  visit("derivations", async (room) => {
    const open = room.locator("details.step[open]");
    assert.equal(await open.count(), 1);
    const next = room.getByRole("button", { name: "Next step" });
    for (const steps of [2, 3]) {
      await next.focus();
      await room.keyboard.press("Enter");
      assert.equal(await open.count(), steps);
    }
    const number = room.locator("details.step[open] a.number").last();
    const link = await number.getAttribute("href");
    await number.click();
    const place = await room.locator(".arrived").getAttribute("id");
    assert.equal(new URL(room.url()).hash, link);
    await visit(new URL(room.url()).hash.slice(1), async (again) => {
      assert.equal(await again.locator(".arrived").getAttribute("id"), place);
      assert.equal(await again.locator("details.step[open]").count(), 3);
    });
  }));

test("answers to exercises are judged: right, not simplified, wrong with the term, and what is no formula", () =>
  visit("derivations?exercises=yes&steps=all", async (room) => {
    const judged = async (answer) => {
      const form = room.locator("form", { has: room.getByLabel("Your answer to (3.1)") });
      await form.getByRole("textbox").fill(answer);
      await form.getByRole("textbox").press("Enter");
      await form.locator(".judgement p").filter({ hasNotText: "…" }).waitFor();
      await settled(room);
      return form.locator(".judgement").textContent();
    };
    assert.equal(await judged("omega0^2*(1 - theta0^2/8)"), "right\n");
    assert.match(await judged("omega0^2*(8 - theta0^2 + 3*theta0^2 - 3*theta0^2)/8"), /^right, but not simplified/);
    assert.match(await judged("ω0²·(1 - θ0²/9)"), /^wrong: the term in .* has another coefficient/);
    assert.match(await judged("omega0^2*(1 -"), /expected a number, a name or \(/);
    assert.match(await judged("zeta"), /no symbol ζ/);
  }));

test("a derivation is saved in every form as the command writes it", () =>
  visit("derivations?road=limit-cycle", async (room) => {
    for (const [button, format] of [["HTML", "html"], ["LaTeX", "latex"], ["Markdown", "markdown"], ["Jupyter notebook", "ipynb"]]) {
      const { bytes } = await saved(room, button);
      assert.equal(bytes.toString(), command("derive", "--method", "limit-cycle", "--format", format).output);
    }
  }));

test("both documents are judged statement by statement", () =>
  visit("derivations?road=paper", async (room) => {
    const { equations } = answer("paper");
    const cards = () => room.locator(".statement h2").allTextContents();
    assert.deepEqual(await cards(), equations.map(({ label, claim }) => `${label}: ${claim}`));
    await room.getByLabel("Verdict").selectOption("wrong");
    await room.getByLabel("Document").selectOption("cote");
    await settled(room);
    const wrong = answer("paper", "--only", "wrong", "--document", "cote").equations;
    assert.deepEqual(await cards(), wrong.map(({ label, claim }) => `${label}: ${claim}`));
    assert.deepEqual(await room.locator(".statement .verdict").allTextContents(), wrong.map(({ verdict }) => verdict));
    await enter(room, "Equation", "no such label");
    assert.match((await errors(room)).join(), /no statement matches/);
  }));

/** Values of the sides of a typed formula, where `value` gives those of its letters; `undefined` if it is none of letters, fractions, powers and functions. */
function typed(formula, value) {
  if (/[^\w\s+*/^()=|'.<>-]|\bd(theta|psi|v|t|x)?\b|\b[a-zA-Z]+\d*\s*(?<!\b(?:sin|cos|ln|sqrt))\(|\.\.\.|[a-z]{2,} [a-z]{2,}/.test(formula)) return undefined;
  return formula.split(/<=|>=|=|<|>/).map((side) => {
    const powers = side.trim().replace(/\|([^|]*)\|/g, "abs($1)").replace(/(^|[(])-/g, "$10-").replaceAll("^", "**");
    const code = powers.replace(/[A-Za-z]\w*'*/g, (name) => ({ sin: "Math.sin", cos: "Math.cos", ln: "Math.log", sqrt: "Math.sqrt", abs: "Math.abs", pi: "Math.PI" })[name] ?? `(${value(name)})`);
    return Function(`return ${code}`)();
  });
}

/** The same of typeset mathematics, read from its elements: fractions, roots, powers, functions and juxtaposed factors. */
const typeset = (math, names) => math.evaluate((math, names) => {
  const GREEK = { α: "alpha", β: "beta", γ: "gamma", δ: "delta", ε: "epsilon", θ: "theta", κ: "kappa", λ: "lambda", μ: "mu", ρ: "rho", σ: "sigma", τ: "tau", φ: "phi", ψ: "psi", ω: "omega", Δ: "Delta", Ω: "Omega" };
  const FUNCTIONS = { sin: Math.sin, cos: Math.cos, ln: Math.log };
  const name = (it) => (it.localName === "msub" ? name(it.children[0]) + it.children[1].textContent : it.localName === "msup" && /^′+$/.test(it.children[1].textContent) ? name(it.children[0]) + "'".repeat(it.children[1].textContent.length) : it.localName === "mrow" && it.children.length === 1 ? name(it.children[0]) : GREEK[it.textContent] ?? it.textContent);
  const functionOf = (it) => FUNCTIONS[(it.localName === "msup" ? it.children[0] : it).textContent.replace("\u2061", "")];
  function one(it) {
    const [first, second, third] = it.children;
    if (it.localName === "mn") return Number(it.textContent);
    if (it.localName === "mfrac") return one(first) / one(second);
    if (it.localName === "msqrt") return Math.sqrt(sum([...it.children]));
    if (it.localName === "msubsup") return names[name(first) + second.textContent] ** one(third);
    if (it.localName === "msup" && !/^′+$/.test(second.textContent)) return one(first) ** one(second);
    if (it.localName === "mrow" && it.children.length !== 1) {
      const [open, inside] = [first?.textContent, [...it.children]];
      return open === "|" ? Math.abs(sum(inside.slice(1, -1))) : sum(open === "(" ? inside.slice(1, -1) : inside);
    }
    if (it.localName === "mrow") return one(first);
    return it.textContent === "π" ? Math.PI : names[name(it)];
  }
  function sum(all) {
    let [total, sign, product, factors] = [0, 1, 1, 0];
    for (let place = 0; place < all.length; place += 1) {
      const it = all[place];
      if (it.localName === "mspace" || it.textContent === "·") continue;
      if (it.localName === "mo" && "+−".includes(it.textContent)) {
        if (factors > 0) total += sign * product;
        [sign, product, factors] = [it.textContent === "−" ? -1 : 1, 1, 0];
        continue;
      }
      const applied = functionOf(it);
      if (applied === undefined) product *= one(it);
      else {
        while (all[place + 1]?.localName === "mspace") place += 1;
        place += 1;
        product *= applied(one(all[place])) ** (it.localName === "msup" ? one(it.children[1]) : 1);
      }
      factors += 1;
    }
    return total + sign * product;
  }
  const sides = [[]];
  for (const it of math.children) {
    if (it.localName === "mo" && /^[=≤≥<>]$/.test(it.textContent)) sides.push([]);
    else sides.at(-1).push(it);
  }
  return sides.map(sum);
}, names);

test("the formulas of the documents are typeset with the values that they have as typed", () =>
  visit("derivations?road=paper", async (room) => {
    const { equations } = answer("paper");
    let compared = 0;
    for (const [place, { printed, correct }] of equations.entries()) {
      const shown = room.locator(".statement").nth(place).locator("dd").filter({ has: room.locator("math, code") });
      for (const [line, formula] of [...printed, ...(correct === "" ? [] : [correct])].entries()) {
        const names = {};
        const expected = typed(formula, (name) => (names[name] ??= 0.2 + 0.6 * Math.abs(Math.sin(12.3 * (Object.keys(names).length + 1)))));
        const math = shown.nth(line).locator("math");
        if (expected === undefined || (await math.count()) === 0) continue;
        const found = await typeset(math, names);
        expected.forEach((value, side) => assert.ok(Number.isNaN(value) ? Number.isNaN(found[side]) : Math.abs(found[side] - value) <= 1e-12 * Math.abs(value), `${formula}: ${found[side]} for ${value}`));
        compared += 1;
      }
    }
    assert.ok(compared > 150, `${compared} formulas`);
  }));

test("no option, key or backtick stands in a room, its messages or its documents", async () => {
  const NAMES = /`|--[a-z]|\b[a-z]{2,}_[a-z0-9]+\b/;
  const wrong = [["derivations?road=perturbation&gauge=nonsense", "unknown gauge"], ["derivations?length=nonsense&amplitude=40", "cannot read"], ["derivations?length=1m", "amplitude"], ["derivations?road=perturbation&oscillator=nonsense", "no oscillator"], ["derivations?road=paper&label=nonsense", "no statement"], ["perturbation?oscillator=nonsense", "no oscillator"], ["perturbation?oscillator=duffing&set=foo%3D1", "no parameter"], ["formulas?from=nonsense", "cannot read"], ["formulas?tolerance=-1", "above zero"]];
  const right = ["derivations?road=paper", "derivations?road=limit-cycle&steps=all", "derivations?road=formulas&steps=all", "formulas?ranges=yes&crossovers=yes", "perturbation?oscillator=duffing"];
  for (const [fragment, message] of [...wrong, ...right.map((it) => [it, ""])]) {
    await visit(fragment, async (room) => {
      const said = await room.evaluate(() => {
        document.querySelector(".equivalents")?.remove();
        return [document.querySelector("main").innerText, ...[...document.querySelectorAll("main :is(option, [title], [aria-label])")].map((it) => `${it.textContent} ${it.title ?? ""} ${it.matches("math") ? "" : it.ariaLabel ?? ""}`)].join("\n");
      });
      assert.ok(said.includes(message), `${fragment}: ${(await errors(room)).join()}`);
      assert.equal(NAMES.exec(said)?.[0], undefined, fragment);
    });
  }
});

test("wrong entries are answered beside their fields", () =>
  visit("derivations", async (room) => {
    await enter(room, "Your amplitude", "400");
    assert.match((await errors(room)).join(), /is not below pi/);
    await enter(room, "Your amplitude", "");
    await room.getByLabel("Derivation").selectOption("perturbation");
    await enter(room, "Order", "1000");
    assert.equal(await room.getByLabel("Order", { exact: true }).getAttribute("aria-invalid"), "true");
  }));
