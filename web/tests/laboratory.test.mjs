// Room 5 compared with the command: files of every kind, options, saved results, and damaged files.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { close, command, EXAMPLES, enter, errors, saved, settled, visit } from "./harness.mjs";

after(close);
/** The fit in words, below the report. */
const inWords = (room) => room.locator(".results section details pre").evaluate((it) => it.textContent);
/** The output of the command, with the line about the report that it writes. */
const reported = (words) => `${command(...words).output}report.html written: report with pictures\n`;

async function give(room, ...files) {
  await room.setInputFiles("#laboratory-files", files.map((file) => (typeof file === "string" ? EXAMPLES + file : file)));
  await settled(room);
}

test("swings are fitted as the command fits them, and choices change the fit", () =>
  visit("laboratory?length=0.56m±0.002m", async (room) => {
    await give(room, "swing_synthetic.csv");
    const fitted = ["fit", "trace", "swing_synthetic.csv", "--length", "0.56m±0.002m"];
    assert.equal(await inWords(room), reported(fitted));
    assert.ok(await room.locator(".report").evaluate((it) => it.querySelectorAll("svg").length >= 4));
    await enter(room, "Damping", "quadratic");
    assert.equal(await inWords(room), reported([...fitted, "--model", "quadratic"]));
    await enter(room, "Damping", "honey");
    assert.match((await errors(room)).join(), /honey/);
  }));

for (const [file, question, fragment, words] of [
  ["gate_synthetic.csv", "gates", "?amplitude=0.9", ["--amplitude", "0.9"]],
  ["period_table_synthetic.csv", "periods", "", []],
  ["lengths_synthetic.csv", "lengths", "", []],
  ["response_synthetic.csv", "response", "?oscillator=pendulum&columns=1,2,-,3&response-unit=deg", ["--model", "pendulum", "--columns", "1,2,-,3", "--amplitude-unit", "deg"]],
]) {
  test(`${file} is known for what it is, and fitted`, () =>
    visit(`laboratory${fragment}`, async (room) => {
      await give(room, file);
      assert.deepEqual(await errors(room), []);
      const said = (await room.locator(".results pre:visible").first().textContent()).replace(/fit\.svg written: .*\n/, "");
      assert.equal(said, command("fit", question, file, ...words).output);
      const { bytes } = await saved(room, "Save the numbers as CSV");
      assert.equal(bytes.toString(), command("fit", question, file, ...words, "--csv").output);
      assert.ok(await room.locator("figure").first().isVisible());
    }));
}

test("the report can be saved where there is one", () =>
  visit("laboratory", async (room) => {
    const report = room.getByRole("button", { name: "Save the report" });
    await give(room, "lengths_synthetic.csv");
    assert.equal(await report.count(), 0);
    assert.equal(await room.getByRole("button", { name: "Save as text" }).count(), 1);
    await room.getByRole("button", { name: "Remove lengths_synthetic.csv" }).click();
    await settled(room);
    await give(room, "swing_synthetic.csv");
    assert.equal(await report.count(), 1);
    const { bytes } = await saved(room, "Save the report");
    const [, script] = /<script>\n([^]*?)<\/script>/.exec(bytes.toString());
    assert.doesNotThrow(() => new Function(script), "the script of the report can be parsed");
    await enter(room, "Damping", "honey");
    assert.equal(await report.count(), 0);
  }));

test("an amplitude without a unit is in radians, and the field says so", () =>
  visit("laboratory?amplitude=0.9", async (room) => {
    await give(room, "gate_synthetic.csv");
    assert.equal(await room.locator(".field", { has: room.getByLabel("Amplitude", { exact: true }) }).locator(".unit").textContent(), "rad");
  }));

test("a response whose frequencies increase throughout is no trace, and its choices are its own", () =>
  visit("laboratory", async (room) => {
    const rows = Array.from({ length: 12 }, (_, row) => [1 + row / 10, 1 / Math.hypot(2.56 - (1 + row / 10) ** 2, 0.3 * (1 + row / 10))]);
    const buffer = Buffer.from(`frequency (Hz),amplitude (mm)\n${rows.map(([f, a]) => `${f.toFixed(2)},${a.toFixed(4)}`).join("\n")}\n`);
    await give(room, { name: "sweep.csv", mimeType: "text/csv", buffer });
    assert.deepEqual(await errors(room), []);
    assert.match(await room.locator(".results pre:visible").first().textContent(), /linear/);
    for (const label of ["Oscillator", "Quantity measured as the amplitude", "Unit of the frequencies", "Unit of the phases"]) assert.ok(await room.getByLabel(label, { exact: true }).isVisible(), label);
    assert.equal(await room.getByLabel("Damping", { exact: true }).isVisible(), false);
    await enter(room, "Columns", "1,7");
    assert.match((await errors(room)).join(), /there is no column `7`/);
    await enter(room, "Columns", "frequency");
    assert.match((await errors(room)).join(), /1 columns given/);
    assert.equal(await room.getByLabel("Columns", { exact: true }).getAttribute("aria-invalid"), "true");
  }));

test("what a file leaves open is decided by a press", () =>
  visit("laboratory", async (room) => {
    await give(room, "phone/swing.txt");
    assert.match((await errors(room)).join(), /it is not clear what column 2 holds/);
    await room.getByRole("button", { name: "--angle-unit rad/s" }).click();
    await settled(room);
    assert.equal(new URL(room.url()).hash, "#laboratory?unit=rad/s");
    assert.equal((await inWords(room)).replaceAll("swing.txt", ""), reported(["fit", "trace", "phone/swing.txt", "--angle-unit", "rad/s"]).replaceAll("phone/swing.txt", ""));
  }));

test("several files are one pendulum, and each can be taken away", () =>
  visit("laboratory?unit=deg", async (room) => {
    const swing = readFileSync(`${EXAMPLES}swing_synthetic.csv`, "utf8");
    const [heading, ...rows] = swing.trim().split("\n").slice(2);
    const part = (name, from, to) => ({ name, mimeType: "text/csv", buffer: Buffer.from([heading, ...rows.slice(from, to)].join("\n")) });
    await give(room, part("a.csv", 0, 600), part("b.csv", 600));
    assert.match(await room.locator(".report").textContent(), /1197 rows in 2 traces/);
    await room.getByRole("button", { name: "Remove b.csv" }).click();
    await settled(room);
    assert.match(await room.locator(".report").textContent(), /600 rows in 1 trace/);
  }));

test("the report is saved as it is shown", () =>
  visit("laboratory?example=yes", async (room) => {
    await settled(room);
    const { name, bytes } = await saved(room, "Save the report");
    assert.equal(name, "report.html");
    assert.match(bytes.toString(), /^<!DOCTYPE html>/i);
    const picture = await saved(room, "Save the picture as SVG");
    assert.match(picture.bytes.toString(), /^<svg xmlns="http:\/\/www.w3.org\/2000\/svg"/);
    const png = await saved(room, "Save the picture as PNG");
    assert.equal(png.bytes.subarray(1, 4).toString(), "PNG");
  }));

test("damaged files end in a message", () =>
  visit("laboratory", async (room) => {
    const swing = readFileSync(`${EXAMPLES}swing_synthetic.csv`, "utf8");
    const noise = Buffer.from(Array.from({ length: 5000 }, (_, place) => (place * 7919 + (place >> 3)) % 256));
    const damaged = {
      "empty.csv": "",
      "noise.csv": noise,
      "noise.xlsx": Buffer.concat([Buffer.from("PK\u0003\u0004"), noise]),
      "words.txt": "one two three\nfour five six\n",
      "infinite.csv": swing.replaceAll(/,\S+/g, ",inf"),
      "one row.csv": swing.split("\n").slice(0, 4).join("\n"),
      "zeros.csv": Buffer.alloc(4096),
      "-.csv": "t (s),theta (deg)\n0,1\n",
      "still.csv": `t (s),theta (deg)\n${Array.from({ length: 300 }, (_, row) => `${row / 50},0`).join("\n")}\n`,
    };
    for (const [name, content] of Object.entries(damaged)) {
      await give(room, { name, mimeType: "application/octet-stream", buffer: Buffer.from(content) });
      const complaints = await errors(room);
      assert.ok(complaints.length > 0 && complaints.every((it) => it.length > 10 && !/the computation failed/.test(it)), `${name}: ${complaints}`);
      await room.getByRole("button", { name: /^Remove/ }).click();
      await settled(room);
    }
  }));

test("markup in a file and in its name stays text", () =>
  visit("laboratory", async (room) => {
    const swing = readFileSync(`${EXAMPLES}swing_synthetic.csv`, "utf8").replace("theta (deg)", "<b><img>angle</b> (deg)");
    const name = "<img src=x onerror=alert(2)>.csv";
    await give(room, { name, mimeType: "text/csv", buffer: Buffer.from(swing) });
    assert.equal(await room.locator("main img, main script").count(), 0);
    assert.equal(await room.locator(".reading h3").textContent(), name);
    const report = await room.locator(".report").textContent();
    assert.ok(report.includes("<b><img>angle</b> (deg)"));
    assert.doesNotMatch(report, /Copy for Word/);
  }));

test("the page says that files stay, and why a desk has no motion sensor", () =>
  visit("laboratory", async (room) => {
    assert.match(await room.locator(".stay").textContent(), /never leave this machine/);
    await room.getByText("Your phone as the instrument").click();
    await room.getByRole("button", { name: "Record" }).click();
    await room.getByText(/No readings received/).waitFor();
  }));

test("a phone's readings become a file that is fitted", () =>
  visit("laboratory", async (room) => {
    await room.getByText("Your phone as the instrument").click();
    await room.getByRole("button", { name: "Record" }).click();
    await room.getByRole("button", { name: "Stop recording" }).waitFor();
    await room.evaluate(() => {
      for (let at = 0; at < 1500; at += 1) {
        const event = new DeviceMotionEvent("devicemotion", { rotationRate: { alpha: 0.1, beta: 0.2, gamma: 60 * Math.sin(at * 0.04) } });
        Object.defineProperty(event, "timeStamp", { value: 1000 + at * 10 });
        dispatchEvent(event);
      }
    });
    await room.getByRole("button", { name: "Stop recording" }).click();
    await settled(room);
    assert.match(await room.locator(".report").textContent(), /1500 rows/);
    assert.match(await room.locator(".controls").textContent(), /about the long axis/);
  }));
