// The table of trials of room 1: measured, typed and pasted; its graphs, and gravity by the fits of the command.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { answer, close, command, settled, visit } from "./harness.mjs";

const folder = mkdtempSync(join(tmpdir(), "trials-"));
after(close);
after(() => rmSync(folder, { recursive: true }));

const cells = (room) => room.locator(".trials tbody tr").evaluateAll((all) => all.map((row) => [...row.querySelectorAll("input")].map((it) => it.value).concat(row.lastElementChild.textContent)));
const cell = (room, name, row) => room.getByLabel(`${name}, row ${row}`, { exact: true });

/** Pastes text into a cell, as a spreadsheet puts it on the clipboard. */
async function paste(room, place, written) {
  await place.focus();
  await place.evaluate((input, it) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", it);
    input.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, written);
}

/** The result of the fit, by a table that is written here. */
async function found(room) {
  await room.getByRole("button", { name: "Find g" }).click();
  await room.waitForFunction(() => document.querySelector(".result .headline, .result .error") !== null, null, { timeout: 60_000 });
  return room.locator(".result").innerText();
}
function gravityOf(query, table, ...options) {
  writeFileSync(join(folder, "trials.csv"), table);
  const { status, output, error } = command("fit", query, join(folder, "trials.csv"), ...options);
  assert.equal(status, 0, error);
  return /^gravity\s+(\S+ ± \S+) m\/s²/m.exec(output)[1];
}

test("measured times fill the table: the same settings give a further reading", () =>
  visit("pendulum?angle=60deg&length=30cm&gate=yes&speed=4&t=0", async (room) => {
    const { period_s: period } = answer("period", "60deg", "--length", "30cm").results[0];
    const into = room.getByRole("group", { name: "Photogate" }).getByRole("button", { name: "Into the table" });
    assert.equal(await into.isDisabled(), true);
    await room.getByRole("button", { name: "Run", exact: true }).click();
    await into.click();
    await into.click();
    const time = period.toFixed(3);
    assert.deepEqual(await cells(room), [["60", "0.3", "1", time, time, Number(time).toPrecision(5)], ["", "", "", "", "", ""]]);
    await room.getByLabel("Length", { exact: true }).fill("0.5");
    await settled(room);
    await into.click();
    assert.deepEqual((await cells(room))[1].slice(0, 3), ["60", "0.5", "1"]);
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.deepEqual(await cells(again), await cells(room)));
  }));

test("a stopwatch over ten swings gives the period", () =>
  visit("pendulum?angle=10deg&stopwatch=yes&speed=4&t=0", async (room) => {
    const watch = room.getByRole("group", { name: "Stopwatch" });
    await watch.getByRole("button", { name: "Start" }).click();
    await room.getByRole("button", { name: "Run", exact: true }).click();
    await room.waitForTimeout(500);
    await watch.getByRole("button", { name: "Stop" }).click();
    const time = (await watch.locator("output").textContent()).replace(" s", "");
    await watch.getByRole("button", { name: "Into the table" }).click();
    assert.deepEqual((await cells(room))[0], ["10", "1", "10", time, (Number(time) / 10).toPrecision(5)]);
    await watch.getByLabel("Swings").fill("half");
    await watch.getByRole("button", { name: "Into the table" }).click();
    assert.match(await watch.textContent(), /a whole number of swings/);
    assert.equal((await cells(room)).length, 2);
  }));

test("a table is typed by keys alone, and what is no number is marked", () =>
  visit("pendulum?t=0", async (room) => {
    await cell(room, "amplitude / °", 1).focus();
    for (const entry of ["12", "0,9", "10", "19.1"]) {
      await room.keyboard.type(entry);
      await room.keyboard.press("Tab");
    }
    assert.deepEqual(await cells(room), [["12", "0,9", "10", "19.1", "1.9100"], ["", "", "", "", ""]]);
    await room.keyboard.type("wide");
    assert.equal(await cell(room, "amplitude / °", 2).getAttribute("aria-invalid"), "true");
    assert.match(await room.locator(".trials caption").textContent(), /^1 trial$/);
    await room.getByLabel("Name of a further column").fill("weather");
    await room.getByRole("button", { name: "Add a column" }).click();
    await cell(room, "weather", 1).fill("calm");
    await room.getByRole("button", { name: "Add a reading" }).click();
    assert.deepEqual((await cells(room))[0], ["12", "0,9", "10", "19.1", "", "calm", "1.9100"]);
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.deepEqual((await cells(again))[0], (await cells(room))[0]));
    await room.getByRole("button", { name: "Clear the table" }).click();
    assert.deepEqual(await cells(room), [["", "", "", "", ""]]);
    assert.doesNotMatch(room.url(), /trials=|columns=/);
  }));

/** Ten swings of 1 m at g = 9.81 m/s² by mpmath, 40·√(l/g)·K(sin²(θ₀/2)), to hundredths of a second, read twice with slips of 2 hundredths. */
const READINGS = [["10", "20,10", "20,08"], ["30", "20,41", "20,43"], ["60", "21,53", "21,51"], ["90", "23,68", "23,69"]];

test("a class's table is pasted from a spreadsheet, and gives g as the command does", () =>
  visit("pendulum?t=0", async (room) => {
    const lines = READINGS.map(([amplitude, ...times]) => [amplitude, "1,000", "10", ...times].join("\t"));
    await paste(room, cell(room, "amplitude / °", 1), `Amplitude\tLänge\tn\tt1\tt2\r\n${lines.join("\r\n")}\r\n`);
    assert.equal((await cells(room)).length, 5);
    assert.match(await room.locator(".trials caption").textContent(), /^4 trials$/);
    const rows = READINGS.flatMap(([amplitude, ...times]) => times.map((time) => `${amplitude},${Number(time.replace(",", ".")) / 10}`));
    const table = `amplitude (deg),period (s)\n${rows.join("\n")}\n`;
    const expected = gravityOf("periods", table, "--length", "1.000m±0.001m");
    const shown = await found(room);
    assert.match(shown, new RegExp(`^g = ${expected.replace(".", "\\.")} m/s²`));
    const [, gravity, error] = /g = (\S+) ± (\S+)/.exec(shown).map(Number);
    assert.ok(Math.abs(gravity - 9.81) < 2 * error, shown);
    assert.match(shown, /\d+ % of the variance comes from the length/);
    // A known uncertainty of each time gives weights.
    await room.getByLabel("Uncertainty of one time").fill("0.02");
    const weighted = table.split("\n").map((line, n) => (n === 0 ? `${line},u(period) (s)` : line && `${line},0.002`)).join("\n");
    assert.match(await found(room), new RegExp(`^g = ${gravityOf("periods", weighted, "--length", "1.000m±0.001m").replace(".", "\\.")} m/s²`));
    await room.getByRole("button", { name: "Open the table in the laboratory" }).click();
    await room.locator(".result-headline").waitFor({ timeout: 60_000 });
    assert.match(await room.locator(".result-headline").textContent(), /^g = 9\.8\d* ± 0\.\d+ m\/s²$/);
  }));

test("three lengths are fitted over the lengths, two are refused", () =>
  visit("pendulum?t=0", async (room) => {
    // Periods at 10° and g = 9.81 m/s² by mpmath, to milliseconds: 1.1009, 1.5569, 2.0099 s, with slips.
    const rows = [["0.3", "1.101"], ["0.3", "1.102"], ["0.6", "1.556"], ["0.6", "1.557"], ["1", "2.009"], ["1", "2.010"]];
    await paste(room, cell(room, "amplitude / °", 1), rows.map(([length, time]) => `10\t${length}\t1\t${time}`).join("\n"));
    const table = `length (m),period (s),u(length) (m),amplitude (deg)\n${rows.map(([length, time]) => `${length},${time},0.001,10`).join("\n")}\n`;
    const expected = gravityOf("lengths", table, "--columns", "1,2,3,-,4");
    assert.match(await found(room), new RegExp(`^g = ${expected.replace(".", "\\.")} m/s²`));
    await cell(room, "amplitude / °", 1).fill("");
    assert.match(await found(room), /1 trial without amplitude or length left out/);
    await paste(room, cell(room, "amplitude / °", 1), `1\t2\n`.repeat(600));
    assert.match(await room.locator(".result").innerText(), /The table holds 500 trials/);
    await room.getByRole("button", { name: "Undo" }).click();
    for (const row of [5, 6]) await cell(room, "time 1 / s", row).fill("");
    assert.match(await found(room), /Use one length for all trials, or three or more/);
  }));

test("the reasons of a fit are in words of the page, and doubt a gravity only on the Earth", () =>
  // Equal readings at 23.22 m/s², rounded to milliseconds, so that rounding alone bends the line.
  visit("pendulum?t=0&trials=10:0.5:1:0.924/10:1:1:1.306/10:1.5:1:1.600/10:0.5:1:0.924/10:1.5:1:1.600/10:1:1:1.306", async (room) => {
    const here = await found(room);
    assert.match(here, /give the radius of the bob/);
    assert.match(here, /on Earth/);
    assert.doesNotMatch(here, /--|`/);
    await room.getByLabel("Gravity of", { exact: true }).selectOption("Jupiter");
    await settled(room);
    const elsewhere = await found(room);
    assert.match(elsewhere, /give the radius of the bob/);
    assert.doesNotMatch(elsewhere, /on Earth/);
  }));

test("the graphs show the measured times, and hide the laws with the exact values", () =>
  visit("pendulum?angle=60deg&t=0&trials=10:1:10:20.1/60:1:10:21.53", async (room) => {
    const graph = room.locator(".trials figure").first().locator("canvas");
    assert.match(await graph.getAttribute("aria-label"), /^2 measured times/);
    const coloured = () =>
      graph.evaluate((canvas) => {
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        let count = 0;
        for (let at = 0; at < data.length; at += 4) if (data[at + 2] - data[at] > 80) count += 1;
        return count;
      });
    await graph.scrollIntoViewIfNeeded();
    await room.waitForTimeout(300);
    assert.ok((await coloured()) > 200);
    await room.getByLabel("Hide the exact values").check();
    await settled(room);
    await graph.scrollIntoViewIfNeeded();
    await room.waitForTimeout(200);
    assert.ok((await coloured()) < 40, `${await coloured()}`);
  }));

test("a chosen formula is drawn with the exact law", () =>
  visit("pendulum?angle=60deg&t=0&formula=bernoulli", async (room) => {
    const graph = room.locator(".trials figure").first().locator("canvas");
    await graph.scrollIntoViewIfNeeded();
    const purple = () =>
      graph.evaluate((canvas) => {
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        let count = 0;
        for (let at = 0; at < data.length; at += 4) if (data[at] - data[at + 1] > 60 && data[at + 2] - data[at + 1] > 40) count += 1;
        return count;
      });
    for (let tries = 0; tries < 60 && (await purple()) < 100; tries++) await room.waitForTimeout(250);
    assert.ok((await purple()) >= 100, `${await purple()}`);
    await room.getByLabel("Approximate period", { exact: true }).selectOption("none");
    await settled(room);
    await room.waitForTimeout(200);
    assert.ok((await purple()) < 40);
  }));
