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
const shown = (room) => room.locator(".derivation").evaluate((it) => it.textContent.replaceAll(/\s/g, ""));

for (const [fragment, words] of [
  ["road=elliptic&amplitude=40deg&length=57cm", ["--method", "elliptic", "--amplitude", "40deg", "--length", "57cm"]],
  ["amplitude=40deg", ["--method", "short", "--amplitude", "40deg"]],
  ["road=elliptic&exercises=yes", ["--method", "elliptic", "--exercises"]],
  ["road=formulas", ["--method", "formulas"]],
  ["road=perturbation&oscillator=duffing&order=3", ["--method", "perturbation", "duffing", "--order", "3"]],
  ["road=averaging&set=n%3D2&order=3", ["--method", "averaging", "--set", "n=2", "--order", "3"]],
  ["road=limit-cycle", ["--method", "limit-cycle"]],
]) {
  test(`the derivation of ${fragment} is the command's, word by word`, () =>
    visit(`derivations?${fragment}`, async (room) => {
      const { output } = command("derive", ...words, "--format", "html");
      assert.equal(await shown(room), await inBody(room, output));
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

test("wrong entries are answered beside their fields", () =>
  visit("derivations", async (room) => {
    await enter(room, "Your amplitude", "400");
    assert.match((await errors(room)).join(), /is not below pi/);
    await enter(room, "Your amplitude", "");
    await room.getByLabel("Derivation").selectOption("perturbation");
    await enter(room, "Order", "1000");
    assert.equal(await room.getByLabel("Order", { exact: true }).getAttribute("aria-invalid"), "true");
  }));
