// Opens the built page in a browser without any network, and runs the same queries with the command.
// PAGE, LIBRATION and CHROMIUM name others than web/dist/libration.html, the newest of target/{release,debug}/libration and /usr/bin/chromium.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, statSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const clone = fileURLToPath(new URL("../../", import.meta.url));
export const page = process.env.PAGE ?? `${clone}web/dist/libration.html`;
const built = ["release", "debug"].map((profile) => `${clone}target/${profile}/libration`).filter(existsSync);
const libration = process.env.LIBRATION ?? built.sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs)[0];

export const EXAMPLES = `${clone}examples/`;
export const PHONE = { width: 320, height: 640 };
export const DESK = { width: 1280, height: 800 };
export const PROJECTOR = { width: 1920, height: 1080 };

/** The longest wait for anything, in milliseconds. */
const LONGEST = 180_000;

let browser;
const kept = new Map();

// Tests with the same options have pages in one context: an empty page there keeps the renderer process, whose beginning costs a second of processor
// time, more than the page itself.
function context(options) {
  const key = JSON.stringify(options);
  if (!kept.has(key)) kept.set(key, begun(options));
  return kept.get(key);
}

async function begun(options) {
  browser ??= chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
  const made = await (await browser).newContext({ viewport: DESK, ...options });
  await (await made.newPage()).goto(pathToFileURL(`${clone}web/tests/`).href);
  return made;
}

/** A page with nothing in it; nothing may leave the machine, and nothing may break meanwhile. */
export async function open(use, { viewport = DESK, ...options } = {}) {
  const around = await context(options);
  const complaints = [];
  const opened = await around.newPage();
  await opened.setViewportSize(viewport);
  await opened.route(/^(?!file:|blob:|data:)/, (route) => {
    complaints.push(`asked for ${route.request().url()}`);
    return route.abort();
  });
  // A loaded machine needs longer than usual; no test measures times by this.
  opened.setDefaultTimeout(LONGEST);
  try {
    opened.on("pageerror", (error) => complaints.push(`threw ${error.message}`));
    opened.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
    await use(opened);
    assert.deepEqual(complaints, []);
  } finally {
    await opened.close();
  }
}

/** A room as a reader sees it. */
export function visit(fragment, use, options) {
  const enter = async (room) => {
    await room.goto(`${pathToFileURL(page)}#${fragment}`);
    await settled(room);
    await use(room);
  };
  return open(enter, options);
}

export async function close() {
  await (await browser)?.close();
  browser = undefined;
  kept.clear();
}

/** Waits until the query for the entries has run. */
export async function settled(room) {
  await room.waitForTimeout(380);
  await room.waitForFunction(() => document.querySelector(".results")?.getAttribute("aria-busy") !== "true", null, { timeout: LONGEST });
}

/** Enters a value as a reader would, and waits for the new results. */
export async function enter(room, label, value) {
  await room.getByLabel(label, { exact: true }).fill(value);
  await settled(room);
}

/** The result of the command for these words, in the folder `examples`. */
export function command(...words) {
  const { status, stdout, stderr } = spawnSync(libration, words, { cwd: EXAMPLES, encoding: "utf8", maxBuffer: 1 << 28 });
  return { status, output: stdout, error: stderr };
}

export function answer(...words) {
  const { status, output, error } = command(...words, "--json");
  assert.equal(status, 0, error);
  return JSON.parse(output);
}

/** A number as the page writes it. */
export function read(text) {
  return Number(text.replaceAll("−", "-").replace("°", ""));
}

/** The cells of the table with this caption, row by row. */
export async function rows(room, caption) {
  const table = room.locator("table", { has: room.locator("caption", { hasText: caption }) }).first();
  return table.locator("tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
}

/** The error messages of the page. */
export async function errors(room) {
  return room.locator(".error:visible").allTextContents();
}

/** The part of a room's results with this title. */
export const part = (room, title) => room.locator("section", { has: room.getByRole("heading", { name: title, exact: true }) });

/** A file that the reader saves by this button of a room or of a part of it. */
export async function saved(room, button) {
  const [download] = await Promise.all([(room.page?.() ?? room).waitForEvent("download"), room.getByRole("button", { name: button }).first().click()]);
  const parts = [];
  for await (const part of await download.createReadStream()) parts.push(part);
  return { name: download.suggestedFilename(), bytes: Buffer.concat(parts) };
}
