// Ensembles: the states compared with those of the command, bit for bit; run, paused, stepped and linked by mouse and keyboard; invalid entries.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, command, enter, errors, PHONE, saved, visit } from "./harness.mjs";

const folder = mkdtempSync(join(tmpdir(), "fleet-"));
after(() => rmSync(folder, { recursive: true }));
after(close);

/** Small sizes for the other pictures of the room, so that they are ready soon. */
const REST = "over=&value=&points=20&intervals=10&until=5";
const DOUBLE = `chaos?system=double_pendulum&set=&initial=theta1%3D120deg,theta2%3D120deg;theta1%3D120deg,theta2%3D121deg&at=sin(theta1)&${REST}`;
const DRIVEN = `chaos?set=c%3D1/2,A%3D1.5&initial=theta%3D0.2;theta%3D0.3&${REST}`;

const words = (room) => room.locator(".fleet-words").textContent();
/** Waits until the words of the ensemble contain this text. */
const says = (room, text) => room.waitForFunction((text) => document.querySelector(".fleet-words")?.textContent.includes(text), text, { timeout: 60_000 });
const time = (room) => Number(new URLSearchParams(new URL(room.url()).hash.split("?")[1]).get("time") ?? NaN);

/** The states saved by the page, one row per motion. */
async function states(room) {
  const { name, bytes } = await saved(room, "Save the states as CSV");
  assert.equal(name, "states.csv");
  const [head, ...rows] = bytes.toString().trim().split("\n").map((line) => line.split(","));
  return { head, rows: rows.map((row) => row.map(Number)) };
}

for (const [system, fragment, set, at] of [["double_pendulum", DOUBLE, [], 3.7], ["driven_pendulum", DRIVEN, ["--set", "c=1/2,A=1.5"], 21]]) {
  test(`the states of an ensemble of ${system} are those of the command, bit for bit`, () =>
    visit(`${fragment}&motions=100&time=${at}`, async (room) => {
      await says(room, `at t = ${at.toPrecision(4)} s`);
      const found = await states(room);
      const { bytes } = await saved(room, "Save the initial states as CSV");
      const starts = join(folder, `${system}.csv`);
      writeFileSync(starts, bytes);
      // The query has a later time as well, since the command shortens its last step to end at its last time.
      const answer = command("simulate", system, ...set, "--each", starts, "--times", `${at},${at + 20}`, "--tolerance", "1e-8", "--json");
      assert.equal(answer.status, 0, answer.error);
      const { motions } = JSON.parse(answer.output);
      assert.equal(found.rows.length, 100);
      found.rows.forEach((row, n) => assert.deepEqual(row, [n + 1, at, ...motions[n].samples[0].state], `motion ${n + 1}`));
    }));
}

test("with the mouse: two thousand double pendulums run, stand, step, and begin again", () =>
  visit(DOUBLE, async (room) => {
    await says(room, "2000 motions at t = 0 s");
    await room.getByRole("button", { name: "Run the ensemble" }).click();
    await says(room, "of real time");
    await room.getByRole("button", { name: "Pause the ensemble" }).click();
    await room.getByRole("button", { name: "Run the ensemble" }).waitFor();
    await room.waitForFunction(() => location.hash.includes("time="));
    const stands = time(room);
    assert.ok(stands > 0.2, `${stands}`);
    await room.getByRole("button", { name: "Advance by one frame" }).click();
    await room.waitForFunction((before) => !location.hash.includes(`time=${before}`), stands);
    assert.ok(Math.abs(time(room) - stands - 1 / 30) < 1e-9);
    await room.getByText("Equivalent command").click();
    assert.match(await room.locator(".equivalents code").first().textContent(), new RegExp(`simulate double_pendulum --each starts.csv --times ${time(room)} --tolerance 1e-8`));
    const { bytes } = await saved(room, "Save the ensemble as PNG");
    assert.equal(bytes.subarray(1, 4).toString(), "PNG");
    await room.getByRole("button", { name: "Restart the ensemble" }).click();
    await says(room, "at t = 0 s");
    assert.ok(Number.isNaN(time(room)));
  }));

test("with keys only, on a phone; and a link shows the same again", () =>
  visit(`${DRIVEN}&motions=50`, async (room) => {
    await says(room, "50 motions at t = 0 s");
    await room.getByRole("button", { name: "Run the ensemble" }).focus();
    await room.keyboard.press("Enter");
    await says(room, "of real time");
    await room.keyboard.press("Space");
    await room.waitForFunction(() => location.hash.includes("time="));
    const found = await states(room);
    await visit(new URL(room.url()).hash.slice(1), async (again) => {
      await says(again, "differ by");
      await again.waitForFunction(() => !/ t = 0 s/.test(document.querySelector(".fleet-words")?.textContent ?? "0"));
      await again.getByText("Integrating the ensemble to").waitFor({ state: "detached" });
      assert.deepEqual((await states(again)).rows, found.rows);
    });
  }, { viewport: PHONE }));

test("a driven ensemble has its section, and one without bodies its states only", () =>
  visit(`${DRIVEN}&motions=50`, async (room) => {
    const picture = (name) => room.locator(".fleet figure", { hasText: name });
    await says(room, "50 motions");
    assert.ok(await picture("Stroboscopic section, once per period of the drive").isVisible());
    assert.match(await picture("Picture of the motions").locator("canvas").getAttribute("aria-label"), /50 motions at t = 0 s/);
    await visit(`chaos?system=lorenz&set=&initial=x%3D1,y%3D1,z%3D1;x%3D1.001,y%3D1,z%3D1&at=z-27&motions=40&${REST}`, async (other) => {
      await says(other, "40 motions");
      assert.deepEqual(await other.locator(".fleet figure:visible figcaption").allTextContents(), ["Current states", "Distance between motions"]);
    });
  }));

test("the page reports when motions can no longer be trusted", () =>
  visit(`${DOUBLE.replace("121deg", "120.00001deg")}&motions=20&tolerance=1e-3&time=10`, async (room) => {
    await says(room, "can no longer be trusted");
    await says(room, "at t = 10.00 s");
    assert.match(await words(room), /From t = 0?\.?\d+/);
  }));

test("an invalid ensemble is reported in words", () =>
  visit(`${DOUBLE}&motions=20`, async (room) => {
    await says(room, "20 motions");
    for (const [label, entry, said] of [
      ["Number of motions", "1", /whole number from 2 to 20000/],
      ["Number of motions", "many", /whole number from 2 to 20000/],
      ["Number of motions", "20", undefined],
      ["Relative tolerance", "0", /give a number from 1e-18 to 0.1/],
      ["Relative tolerance", "1e-8", undefined],
    ]) {
      await enter(room, label, entry);
      await room.waitForFunction((wanted) => ([...document.querySelectorAll(".error")].some((it) => it.checkVisibility())) === wanted, said !== undefined, { timeout: 60_000 });
      if (said !== undefined) assert.match((await errors(room)).join(" "), said);
    }
    for (const entry of ["theta1=120deg", "theta1=120deg; theta2=1deg", "theta1=pi/3; theta1=pi/2"]) {
      await enter(room, "Initial states", entry);
      await room.getByText("An ensemble needs two initial states").waitFor();
      assert.deepEqual(await errors(room), []);
    }
    await enter(room, "Initial states", "theta1=120deg; theta1=121deg");
    await says(room, "20 motions at t = 0 s");
  }));
