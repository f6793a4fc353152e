// The views of room 1: tasks, explanations of terms, lecture.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, DESK, settled, visit } from "./harness.mjs";

after(close);

test("tasks are read one after the other, with their reasons on demand", () =>
  visit("pendulum?t=0", async (room) => {
    const card = room.getByRole("group", { name: "Learn" });
    assert.equal(await card.isVisible(), false);
    await room.getByLabel("View", { exact: true }).selectOption("learn");
    await settled(room);
    const acts = new Set();
    for (let n = 1; n <= 6; n++) {
      assert.equal(await card.locator("h2").textContent(), `Task ${n} of 6`);
      acts.add(await card.locator("p").first().textContent());
      assert.equal(await card.locator("details p").isVisible(), false);
      await card.getByText("Why?").click();
      assert.ok(await card.locator("details p").isVisible());
      if (n < 6) await card.getByRole("button", { name: "Next" }).click();
    }
    assert.equal(acts.size, 6);
    assert.equal(await card.getByRole("button", { name: "Next" }).isDisabled(), true);
    await card.getByRole("button", { name: "Back" }).click();
    assert.equal(await card.locator("h2").textContent(), "Task 5 of 6");
  }));

test("each graph says what to look at and where there is more, and terms are explained by keys", () =>
  visit("pendulum?t=0", async (room) => {
    const figures = room.locator("figure.plot:visible");
    assert.equal(await figures.count(), 9);
    for (const figure of await figures.all()) {
      assert.match(await figure.locator(".look").textContent(), /\w.*[.:].* more$/);
      assert.match(await figure.locator(".look a").getAttribute("href"), /^#(derivations|formulas)/);
    }
    const terms = new Set(await room.locator("button.term").allTextContents());
    assert.deepEqual([...terms].sort(), ["equilibrium", "restoring force", "separatrix", "small-angle approximation"]);
    await room.locator("figure button.term", { hasText: "separatrix" }).first().focus();
    await room.keyboard.press("Enter");
    const note = room.locator(".explanation:popover-open");
    assert.match(await note.textContent(), /^separatrix The curve between swinging and going over/);
    await room.keyboard.press("Escape");
    assert.equal(await note.count(), 0);
    await room.locator("figure .look a").first().click();
    await room.waitForURL(/#formulas/);
  }));

test("a lecture has larger letters and few settings, and ends with the room", () =>
  visit("pendulum?t=0", async (room) => {
    const size = () => room.locator(".readout.period strong").evaluate((it) => parseFloat(getComputedStyle(it).fontSize));
    const before = await size();
    await room.getByLabel("View", { exact: true }).selectOption("lecture");
    await settled(room);
    assert.ok((await size()) > 1.5 * before);
    for (const hidden of [".trials", ".facts", ".shown", ".look"]) assert.equal(await room.locator(hidden).first().isVisible(), false, hidden);
    const box = await room.locator(".bench-time").boundingBox();
    assert.ok(box.y + box.height <= DESK.height);
    await room.getByRole("link", { name: "About" }).click();
    assert.equal(await room.evaluate(() => document.documentElement.className), "");
  }));
