// Undo, redo, reset, links and the embedded view of room 1.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, enter, PHONE, settled, visit } from "./harness.mjs";

after(close);

const field = (room, label) => room.getByLabel(label, { exact: true }).inputValue();
const press = (room, name) => room.getByRole("button", { name, exact: true }).click();
const stage = (room) => room.getByRole("slider", { name: /Angle of release/ });
/** Longer than the pause that separates two steps. */
const pause = (room) => room.waitForTimeout(750);

test("changes by fields, slider, switches and the mouse are undone and redone one by one", () =>
  visit("pendulum?angle=60deg&t=0", async (room) => {
    assert.equal(await room.getByRole("button", { name: "Undo" }).isDisabled(), true);
    await enter(room, "Length", "0.5");
    await pause(room);
    await room.getByRole("slider", { name: "Amplitude" }).fill("90");
    await pause(room);
    await room.getByLabel("Arrows", { exact: true }).check();
    await pause(room);
    const { x, y, width, height } = await stage(room).boundingBox();
    await room.mouse.move(x + width / 2, y + height / 2 + 100);
    await room.mouse.down();
    await room.mouse.move(x + width / 2 - 100, y + height / 2, { steps: 4 });
    await room.waitForTimeout(150);
    await room.mouse.up();
    await room.waitForURL(/angle=-90/);
    const state = async () => [await field(room, "Length"), await field(room, "Angle"), await room.getByLabel("Arrows", { exact: true }).isChecked()];
    const states = [["0.5", "90", true], ["0.5", "90", false], ["0.5", "60", false], ["1", "60", false]];
    for (const expected of states) {
      await press(room, "Undo");
      assert.deepEqual(await state(), expected);
    }
    assert.equal(await room.getByRole("button", { name: "Undo" }).isDisabled(), true);
    for (const expected of states.slice(0, 3).reverse()) {
      await press(room, "Redo");
      assert.deepEqual(await state(), expected);
    }
    await press(room, "Redo");
    assert.equal(await field(room, "Angle"), "-90");
  }));

test("a table of trials is undone like any change, and reset is undone too", () =>
  visit("pendulum?t=0&trials=10:1:10:20.1", async (room) => {
    const rows = () => room.locator(".trials tbody tr").count();
    await press(room, "Clear the table");
    assert.equal(await rows(), 1);
    await press(room, "Undo");
    assert.equal(await rows(), 2);
    await enter(room, "Angle", "20");
    await pause(room);
    await press(room, "Reset");
    assert.deepEqual([await field(room, "Angle"), await rows()], ["150", 1]);
    await press(room, "Undo");
    assert.deepEqual([await field(room, "Angle"), await rows()], ["20", 2]);
    // Cells that are filled one right after the other are steps of their own.
    const cells = ["amplitude / °, row 2", "length / m, row 2"];
    for (const cell of cells) await room.getByLabel(cell, { exact: true }).fill("1");
    await press(room, "Undo");
    assert.deepEqual(await Promise.all(cells.map((cell) => field(room, cell))), ["1", ""]);
  }));

test("keys of the stage undo and redo, and the stage keeps the focus", () =>
  visit("pendulum?angle=60deg&t=0", async (room) => {
    await stage(room).focus();
    await room.keyboard.press("ArrowRight");
    assert.equal(await field(room, "Angle"), "61");
    await room.keyboard.press("Control+z");
    assert.equal(await field(room, "Angle"), "60");
    await room.keyboard.press("Control+Shift+Z");
    assert.equal(await field(room, "Angle"), "61");
    assert.equal(await room.evaluate(() => document.activeElement.className), "stage");
  }));

test("the link has the state and no folder of this machine, and opens the same", () =>
  visit("pendulum?angle=60deg&length=0.3m&t=0", async (room) => {
    await room.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await room.getByText("Link to this state").click();
    await press(room, "Copy: Link to this state");
    const link = await room.evaluate(() => navigator.clipboard.readText());
    assert.match(link, /^#pendulum\?/);
    await visit(link.slice(1), async (again) => assert.deepEqual([await field(again, "Angle"), await field(again, "Length")], ["60", "0.3"]));
    await room.getByLabel("without header, for a learning platform").check();
    await press(room, "Copy: Link to this state").catch(() => press(room, "Copied"));
    assert.match(await room.evaluate(() => navigator.clipboard.readText()), /^#embed\?/);
  }));

for (const viewport of [{ width: 800, height: 500 }, PHONE]) {
  test(`the embedded view of ${viewport.width} px has the bench without the header`, () =>
    visit("embed?angle=45&t=0", async (room) => {
      assert.equal(await room.locator("header").isVisible(), false);
      assert.equal(await room.locator(".swing-graphs").first().isVisible(), false);
      assert.equal(await field(room, "Angle"), "45");
      const { y, height } = await room.locator(".bench-stage").boundingBox();
      assert.ok(y === 0 && height >= viewport.height / 2, `${y} ${height}`);
      await enter(room, "Angle", "50");
      assert.match(room.url(), /#embed\?/);
      assert.equal(await room.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
    }, { viewport }));
}

test("another room has no steps of this one", () =>
  visit("pendulum?t=0", async (room) => {
    await enter(room, "Angle", "20");
    await room.getByRole("link", { name: "About" }).click();
    await room.getByRole("link", { name: "The pendulum" }).click();
    await settled(room);
    assert.equal(await room.getByRole("button", { name: "Undo" }).isDisabled(), true);
  }));
