// Room 5 compared with the command: files of every kind, options, saved results, and damaged files.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, command, EXAMPLES, enter, errors, PHONE, saved, settled, visit } from "./harness.mjs";

after(close);
/** The headline of the result. */
const headline = (room) => room.locator(".result-headline").textContent();
/** The fit in words, which is computed when it is opened. */
async function inWords(room) {
  await room.locator("details.in-words summary").click();
  await room.waitForFunction(() => document.querySelector("details.in-words pre")?.textContent !== "", null, { timeout: 60_000 });
  return room.locator("details.in-words pre").textContent();
}
/** All that is visible of the results has no option, no key and no backtick. */
async function inPageWords(room) {
  const [said, report] = await Promise.all([".results", ".report"].map((part) => room.locator(part).innerText()));
  // A report has the command that makes it again.
  assert.doesNotMatch(said.replace(report, "").replace(/The files[^]*/, ""), /--[a-z]|`|libration fit|[a-z]+_[a-z]/);
}
const table = (name, ...lines) => ({ name, mimeType: "text/csv", buffer: Buffer.from(`${lines.join("\n")}\n`) });

async function give(room, ...files) {
  await room.setInputFiles("#laboratory-files", files.map((file) => (typeof file === "string" ? EXAMPLES + file : file)));
  await settled(room);
}

test("swings are fitted as the command fits them, and choices change the fit", () =>
  visit("laboratory?length=0.56m±0.002m", async (room) => {
    await give(room, "swing_synthetic.csv");
    const fitted = ["fit", "trace", "swing_synthetic.csv", "--length", "0.56m±0.002m"];
    assert.equal(await inWords(room), command(...fitted).output);
    assert.ok(await room.locator(".report").evaluate((it) => it.querySelectorAll("svg").length >= 4));
    await enter(room, "Damping", "quadratic");
    assert.equal(await inWords(room), command(...fitted, "--model", "quadratic").output);
    await enter(room, "Damping", "honey");
    assert.match((await errors(room)).join(), /honey/);
  }));

for (const [file, question, fragment, words] of [
  ["gate_synthetic.csv", "gates", "?amplitude=0.9", ["--amplitude", "0.9"]],
  ["period_table_synthetic.csv", "periods", "", []],
  ["lengths_synthetic.csv", "lengths", "", []],
  ["amplitudes_synthetic.csv", "amplitudes", "", []],
  ["class/ten_swings.csv", "lengths", "", []],
  ["class/groups.csv", "lengths", "?least=0,4m&groups=A,B", ["--from", "0.4m", "--run", "A,B"]],
  ["class/amplitudes.csv", "periods", "?length=0,500 ± 0,001 m", ["--length", "0.500 ± 0.001 m"]],
  ["response_synthetic.csv", "response", "?oscillator=pendulum&columns=1,2,-,3&response-unit=deg", ["--model", "pendulum", "--columns", "1,2,-,3", "--amplitude-unit", "deg"]],
]) {
  test(`${file} is known for what it is, and fitted`, () =>
    visit(`laboratory${fragment}`, async (room) => {
      await give(room, file);
      assert.deepEqual(await errors(room), []);
      await inPageWords(room);
      assert.equal(await inWords(room), command("fit", question, file, ...words).output);
      const { bytes } = await saved(room, "Save the numbers as CSV");
      assert.equal(bytes.toString(), command("fit", question, file, ...words, "--csv").output);
      assert.ok(await room.locator("figure").first().isVisible());
    }));
}

test("the result stands first, in view, with its uncertainty", () =>
  visit("laboratory", async (room) => {
    await give(room, "class/ten_swings.csv");
    // A weighted straight line through T² against L in mpmath, the readings of ten swings with their common scatter of 0.0876 s: g = 9.83395 ± 0.05349 m/s².
    assert.equal(await headline(room), "g = 9.834 ± 0.053 m/s²");
    const { y, height } = await room.locator(".result-headline").boundingBox();
    assert.ok(y > 0 && y + height < 800);
    assert.match(await room.locator(".reasons").textContent(), /95 %, g lies within ± 0.12 m\/s²/);
    assert.equal(await room.locator(".reading table").first().isVisible(), false);
  }));

test("on a phone the result follows the files, before the options", () =>
  visit("laboratory", async (room) => {
    await give(room, "class/ten_swings.csv");
    const [files, result, options] = await Promise.all([".drop", ".result-headline", ".laboratory > .controls:last-child"].map(async (it) => (await room.locator(it).boundingBox()).y));
    assert.ok(files < result && result < options, `${files} ${result} ${options}`);
  }, { viewport: PHONE }));

test("readings of ten swings, half swings and units are chosen by sentences with buttons", () =>
  visit("laboratory", async (room) => {
    const lengths = [0.2, 0.35, 0.5, 0.65, 0.8, 1];
    const gravity = async () => Number(/g = ([\d.]+)/.exec(await headline(room))?.[1]);
    // Exact times of small swings at g = 9.81 m/s², so that the line through them is exact.
    const period = (length) => 2 * Math.PI * Math.sqrt(length / 9.81);
    await give(room, table("ten.csv", "L (m);T (s)", ...lengths.map((it) => `${it};${(10 * period(it)).toFixed(2)}`.replaceAll(".", ","))));
    assert.ok((await gravity()) < 0.1);
    await room.getByRole("button", { name: "These are ten swings each" }).click();
    await settled(room);
    assert.ok(Math.abs((await gravity()) / 9.81 - 1) < 0.005, `${await gravity()}`);
    assert.match(new URL(room.url()).hash, /swings-per-reading=10/);
    assert.equal(await room.evaluate(() => document.querySelector(".results").contains(document.activeElement)), true, "the focus stays in the results");
    assert.equal(await room.getByRole("button", { name: "10 swings", exact: true }).getAttribute("aria-pressed"), "true");
    await room.getByRole("button", { name: "half a swing" }).click();
    await settled(room);
    assert.match(new URL(room.url()).hash, /half-periods=yes/);
    assert.doesNotMatch(new URL(room.url()).hash, /swings-per-reading/);
    await room.getByRole("button", { name: "10 swings", exact: true }).click();
    await settled(room);
    await room.getByRole("button", { name: "cm", exact: true }).click();
    await settled(room);
    assert.ok((await gravity()) < 0.1);
    await inPageWords(room);
  }));

test("the uncertainty of a timing by hand is chosen where no repeated reading shows it", () =>
  visit("laboratory", async (room) => {
    await give(room, "class/units_below.csv");
    await room.getByRole("group", { name: "Standard uncertainty of one timing by hand" }).getByRole("button", { name: "0.1 s" }).click();
    await settled(room);
    assert.equal(await inWords(room), command("fit", "lengths", "class/units_below.csv", "--reaction-time", "0.1 s").output);
    await room.getByRole("button", { name: /^Remove/ }).click();
    await settled(room);
    await give(room, "class/ten_swings.csv");
    assert.equal(await room.getByRole("group", { name: "Standard uncertainty of one timing by hand" }).count(), 0);
  }));

test("a column that is no reading is taken out by a choice", () =>
  visit("laboratory", async (room) => {
    await give(room, "class/ten_swings.csv");
    await room.locator("details.roles summary").click();
    await room.getByLabel("Column 4 “time for 10 swings 3 (s)”").selectOption("ignore");
    await settled(room);
    assert.match(new URL(room.url()).hash, /roles=4%3Dignore/);
    assert.equal(await inWords(room), command("fit", "lengths", "class/ten_swings.csv", "--role", "4=ignore").output);
  }));

test("groups of a class have their own results", () =>
  visit("laboratory", async (room) => {
    await give(room, "class/groups.csv");
    const { groups } = JSON.parse(command("fit", "lengths", "class/groups.csv", "--json").output);
    const said = await room.locator(".reasons").textContent();
    for (const { group, gravity_m_per_s2: value, gravity_uncertainty_m_per_s2: uncertainty } of groups) assert.ok(said.includes(`Group ${group}: g = ${value.toFixed(3)} ± ${uncertainty.toFixed(3)} m/s²`), said);
  }));

test("the page asks for the length, and g follows", () =>
  visit("laboratory", async (room) => {
    await give(room, "class/amplitudes.csv");
    assert.match(await headline(room), /^T₀ = 1\.418/);
    await room.locator(".guide input").fill("50,0 ± 0,1 cm");
    await room.keyboard.press("Enter");
    await settled(room);
    // g = 4π²·0.5 m / T₀² with T₀ = 1.41805 s is 9.8163 m/s²; u(L)/L = 0.002 makes 0.0196 m/s², and u(T₀) 0.0117 m/s².
    assert.equal(await headline(room), "g = 9.816 ± 0.023 m/s²");
    await room.getByLabel("Length", { exact: true }).fill("half a metre");
    await settled(room);
    const [said] = await errors(room);
    assert.doesNotMatch(said, /`|--/);
    assert.match(said, /“half a metre”/);
  }));

test("a broken file leaves the others", () =>
  visit("laboratory", async (room) => {
    const file = (name) => ({ name, mimeType: "text/csv", buffer: readFileSync(`${EXAMPLES}class/${name}`) });
    await give(room, file("ten_swings.csv"), table("broken.csv", "a"), { name: "noise.xlsx", mimeType: "application/octet-stream", buffer: Buffer.from("PK\u0003\u0004 nothing") }, file("groups.csv"));
    assert.equal(await headline(room), "g = 9.834 ± 0.053 m/s²");
    assert.match((await errors(room)).join(), /./);
    await room.getByRole("button", { name: "groups.csv", exact: true }).click();
    await settled(room);
    assert.equal(await headline(room), "g = 9.791 ± 0.031 m/s²");
    assert.equal(await room.getByRole("button", { name: "groups.csv", exact: true }).getAttribute("aria-pressed"), "true");
  }));

test("a table is typed, with decimal commas", () =>
  visit("laboratory", async (room) => {
    await room.getByText("Type or paste a table").click();
    await room.locator("#laboratory-typed").fill("L (cm)\t10 T (s)\n20\t9,00\n35\t11,90\n50\t14,20\n65\t16,15\n80\t17,95\n100\t20,07");
    await room.getByRole("button", { name: "Use this table" }).click();
    await settled(room);
    assert.match(await headline(room), /^g = 9\.8\d* ± 0\.\d+ m\/s²$/);
  }));

test("what each file can give is offered, and a file without headings asks", () =>
  visit("laboratory", async (room) => {
    await give(room, table("plain.csv", "20,9.00", "35,11.90", "50,14.2", "65,16.15", "80,17.95", "100,20.07"));
    for (const what of ["T₀, damping and g from a recorded swing", "T₀ and g from photogate times", "T₀ and g from periods at several amplitudes", "damping and Q from falling amplitudes"]) assert.ok(await room.getByRole("button", { name: what }).isVisible(), what);
    await room.getByRole("button", { name: "g from periods at several lengths" }).click();
    await settled(room);
    await room.getByRole("button", { name: "cm", exact: true }).click();
    await settled(room);
    await room.getByRole("button", { name: "10 swings", exact: true }).click();
    await settled(room);
    assert.match(await headline(room), /^g = 9\.8/);
  }));

test("a video is refused where it is dropped, with the way to numbers", () =>
  visit("laboratory", async (room) => {
    await give(room, { name: "swing.mp4", mimeType: "video/mp4", buffer: Buffer.from("video") });
    assert.match((await errors(room)).join(), /Mark the bob frame by frame/);
    assert.match(await room.locator(".drop").textContent(), /Videos cannot be read here/);
  }));

test("more than two million rows are offered to be thinned", () =>
  visit("laboratory", async (room) => {
    const count = 2_000_010;
    const lines = Array.from({ length: count }, (_, n) => `${(n / 1e5).toFixed(5)},${(40 * Math.cos((4.2 * n) / 1e5)).toFixed(1)}`);
    // A path, since the browser reads a file of thirty megabytes faster than a message.
    const folder = mkdtempSync(join(tmpdir(), "laboratory-"));
    writeFileSync(join(folder, "long.csv"), `t (s),theta (deg)\n${lines.join("\n")}\n`);
    await room.setInputFiles("#laboratory-files", join(folder, "long.csv"));
    await room.locator(".files li").waitFor({ timeout: 60_000 });
    rmSync(folder, { recursive: true });
    assert.match(await room.locator(".files").textContent(), /2,000,011 rows/);
    assert.equal(await room.locator(".reading").count(), 0);
    await room.getByRole("button", { name: "Keep one row in 21" }).click();
    await room.locator(".reading table").waitFor({ state: "attached", timeout: 60_000 });
    assert.match(await room.locator(".reading caption").first().textContent(), new RegExp(`${Math.ceil(count / 21)} rows`));
  }));

test("the report of each fit can be saved", () =>
  visit("laboratory", async (room) => {
    const report = room.getByRole("button", { name: "Save the report" });
    await give(room, "lengths_synthetic.csv");
    assert.equal(await report.count(), 1);
    assert.equal(await room.getByRole("button", { name: "Save as text" }).count(), 1);
    assert.match(await room.locator(".report").textContent(), /The uncertainty of gravity/);
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

test("a light sensor's signal becomes passages of a gate by a press", () =>
  visit("laboratory", async (room) => {
    await give(room, "light_synthetic.csv");
    await room.getByRole("button", { name: "The dips or peaks of column 2 are passages" }).click();
    await settled(room);
    assert.deepEqual(await errors(room), []);
    assert.equal(await inWords(room), command("fit", "gates", "light_synthetic.csv", "--signal", "2").output);
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
    assert.match(await room.locator(".others").textContent(), /Oscillator: linear/);
    for (const label of ["Oscillator", "Quantity measured as the amplitude", "Unit of the frequencies", "Unit of the phases"]) assert.ok(await room.getByLabel(label, { exact: true }).isVisible(), label);
    assert.equal(await room.getByLabel("Damping", { exact: true }).isVisible(), false);
    await enter(room, "Columns", "1,7");
    assert.match((await errors(room)).join(), /There is no column “7”/);
    await enter(room, "Columns", "frequency");
    assert.match((await errors(room)).join(), /1 columns given/);
    assert.equal(await room.getByLabel("Columns", { exact: true }).getAttribute("aria-invalid"), "true");
  }));

test("what a file leaves open is decided by a press", () =>
  visit("laboratory", async (room) => {
    await give(room, "phone/swing.txt");
    assert.match(await room.locator(".results").textContent(), /it is not clear what column 2 holds/);
    await room.getByRole("button", { name: "These are angular velocities in rad/s" }).click();
    await settled(room);
    assert.equal(new URL(room.url()).hash, "#laboratory?unit=rad/s");
    assert.equal((await inWords(room)).replaceAll("swing.txt", ""), command("fit", "trace", "phone/swing.txt", "--angle-unit", "rad/s").output.replaceAll("phone/swing.txt", ""));
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
    assert.equal(await room.locator(".reading summary .mono").textContent(), name);
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
    assert.match(await room.locator(".controls").last().textContent(), /about the long axis/);
  }));

test("axe finds nothing in tables, warnings, refusals and open questions, light and dark", () =>
  visit("laboratory", async (room) => {
    await room.evaluate(readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8"));
    const states = [
      "class/ten_swings.csv",
      "class/amplitudes.csv",
      "class/side_by_side.csv",
      "phone/swing.txt",
      table("ten.csv", "L (m),T (s)", "0.2,9.00", "0.35,11.90", "0.5,14.2", "0.65,16.15", "0.8,17.95", "1,20.07"),
      table("comma.csv", "angle;period", "5;2,001", "10;2,005"),
    ];
    for (const file of states) {
      await give(room, file);
      for (const roles of await room.locator("details.roles summary").all()) await roles.click();
      for (const colorScheme of ["light", "dark"]) {
        await room.emulateMedia({ colorScheme });
        const { violations } = await room.evaluate(() => axe.run());
        assert.deepEqual(violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html.slice(0, 160)}`)), [], file.name ?? file);
      }
      await room.getByRole("button", { name: /^Remove/ }).click();
      await settled(room);
    }
  }, { bypassCSP: true }));
