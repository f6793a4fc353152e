// Every room works in Firefox too, without errors and without requests to any host. FIREFOX names another than /usr/bin/firefox-esr; where
// there is none, this is left out.

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";

const executablePath = process.env.FIREFOX ?? "/usr/bin/firefox-esr";
const page = process.env.PAGE ?? fileURLToPath(new URL("../dist/libration.html", import.meta.url));
/** A text in each room once it is ready. */
const ROOMS = {
  pendulum: /Period T\s+3\.5357/,
  formulas: /At 60° the exact period is 1\.07318200715/,
  perturbation: /The exact value is 1\.07318200714936/,
  derivations: /The first correction to the period of a pendulum/,
  laboratory: /never leave this machine/,
  chaos: /The largest Lyapunov exponent is/,
  about: /How to cite/,
};

describe("in Firefox", { skip: !existsSync(executablePath) && "Firefox is not installed" }, () => {
  let browser;
  before(async () => {
    browser = await puppeteer.launch({ browser: "firefox", executablePath, headless: true });
  });
  after(() => browser?.close());

  for (const [name, expected] of Object.entries(ROOMS)) {
    test(name, async () => {
      const room = await browser.newPage();
      const complaints = [];
      room.on("pageerror", (error) => complaints.push(error.message));
      room.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
      room.on("request", (request) => /^(?:file|blob|data):/.test(request.url()) || complaints.push(`asked for ${request.url()}`));
      await room.goto(`${pathToFileURL(page)}#${name}`);
      const says = (source) => new RegExp(source).test(document.querySelector("main")?.innerText ?? "");
      await room.waitForFunction(says, { timeout: 120_000 }, expected.source);
      assert.deepEqual(complaints, []);
      await room.close();
    });
  }
});
