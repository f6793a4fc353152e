// Room 6 compared with the command: diagrams, sections, neighbours and verdicts, and invalid entries.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, command, enter, errors, part, PHONE, saved, settled, visit } from "./harness.mjs";

after(close);
const SYSTEM = ["driven_pendulum", "--initial", "theta=0.2"];
const SMALL = "chaos?over=A%3D1:1.5:0.05&each=10&points=300&intervals=100";

test("pictures and verdict are the command's", () =>
  visit(SMALL, async (room) => {
    const at = ["driven_pendulum", "--set", "c=1/2,A=1.2"];
    const asked = [
      ["bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2", "--over", "A=1:1.5:0.05", "--points", "10", "--sweep", "both", "--figure", "-"],
      ["section", ...at, "--initial", "theta=0.2", "--initial", "theta=0.2001", "--points", "300", "--figure", "-"],
      ["figure", "trajectories", ...at, "--initial", "theta=0.2", "--initial", "theta=0.2001", "--to", "100", "--output", "-"],
      ["lyapunov", ...at, "--initial", "theta=0.2", "--intervals", "100", "--figure", "-"],
      ["orbit", ...at, "--initial", "theta=0.2", "--figure", "-"],
    ];
    const buttons = room.getByRole("button", { name: "Save the picture as SVG" });
    assert.equal(await buttons.count(), asked.length);
    for (const [place, words] of asked.entries()) {
      const [download] = await Promise.all([room.waitForEvent("download"), buttons.nth(place).click()]);
      const parts = [];
      for await (const part of await download.createReadStream()) parts.push(part);
      assert.equal(Buffer.concat(parts).toString(), command(...words).output, words[0]);
    }
    const { verdict, reason } = answer("lyapunov", ...at, "--initial", "theta=0.2", "--intervals", "100");
    assert.equal((await room.locator("p.verdict").textContent()).toLowerCase(), `${verdict}: ${reason}.`.toLowerCase());
  }));

test("a value is chosen in the diagram by keys and by the mouse, and a link shows it again", () =>
  visit(SMALL, async (room) => {
    const slider = room.getByRole("slider", { name: "in the diagram" });
    await slider.focus();
    await room.keyboard.press("ArrowRight");
    await settled(room);
    assert.equal(await slider.getAttribute("aria-valuetext"), "A = 1.25");
    const { width, height } = await slider.boundingBox();
    // By its own position: what is drawn above may still move it.
    await slider.click({ position: { x: width * 0.8, y: height / 2 } });
    await settled(room);
    const chosen = await slider.getAttribute("aria-valuetext");
    assert.notEqual(chosen, "A = 1.25");
    const verdict = await room.locator("p.verdict").textContent();
    await visit(new URL(room.url()).hash.slice(1), async (again) => {
      assert.equal(await again.getByRole("slider", { name: "in the diagram" }).getAttribute("aria-valuetext"), chosen);
      assert.equal(await again.locator("p.verdict").textContent(), verdict);
    });
  }));

test("what is shown stays when a long section is stopped", () =>
  visit("chaos?over=&value=&set=c%3D1/2,A%3D1.5&points=100", async (room) => {
    await room.getByLabel("Points of the section", { exact: true }).fill("10000000");
    await room.getByRole("button", { name: "Stop" }).click();
    await settled(room);
    const { bytes } = await saved(room, "Save the picture as SVG");
    assert.match(bytes.toString(), /<path class="markers"/);
    await enter(room, "Points of the section", "50");
    assert.deepEqual(await errors(room), []);
  }));

test("each system to begin with has its pictures and its verdict", () =>
  visit(SMALL, async (room) => {
    const begin = room.getByLabel("Example");
    for (const value of ["stars", "double", "upright", "threshold", "springs", "thirds", "jumps", "lorenz"]) {
      await begin.selectOption(value);
      await settled(room);
      assert.deepEqual(await errors(room), [], value);
      assert.match(await room.locator("p.verdict").textContent(), /^(Regular|Chaotic|Undecided): /);
      assert.equal(await begin.inputValue(), value);
    }
  }));

/** The verdict. */
const verdict = (room) => room.locator("p.verdict").textContent();
const entry = (room, label) => room.getByLabel(label, { exact: true }).inputValue();
const QUICKLY = "points=20&intervals=300&until=5&each=5";

test("the motion stays the same when the range of its parameter is taken away", () =>
  visit(`chaos?set=c%3D1/2&value=1.2&over=A%3D1:1.5:0.1&${QUICKLY}`, async (room) => {
    const chaotic = await verdict(room);
    assert.match(chaotic, /^Chaotic: /);
    await enter(room, "Range of a parameter", "");
    assert.equal(await verdict(room), chaotic);
    assert.equal(await entry(room, "Values of parameters"), "c=1/2,A=1.2");
    assert.equal(await entry(room, "Value of the parameter"), "");
    await visit(new URL(room.url()).hash.slice(1), async (again) => assert.equal(await verdict(again), chaotic));
    await enter(room, "Range of a parameter", "A=1:1.5:0.1");
    assert.equal(await verdict(room), chaotic);
    assert.equal(await entry(room, "Values of parameters"), "c=1/2");
    assert.equal(await entry(room, "Value of the parameter"), "1.2");
    assert.ok(await part(room, "Bifurcation diagram").locator(".picture-slider").evaluate((it) => it.querySelector(".picture").shadowRoot.querySelector("svg") !== null));
  }));

test("the motion stays the same when the range gets another parameter", () =>
  visit(`chaos?set=c%3D1/2,omega%3D0.7&value=1.2&over=A%3D1:1.5:0.1&${QUICKLY}`, async (room) => {
    const before = await verdict(room);
    await enter(room, "Range of a parameter", "omega=0.6:0.8:0.1");
    assert.equal(await verdict(room), before);
    const slider = room.getByRole("slider", { name: "Value of omega in the diagram" });
    assert.equal(await slider.getAttribute("aria-valuetext"), "omega = 0.7");
    assert.equal(await entry(room, "Values of parameters"), "c=1/2,A=1.2");
    assert.equal(await entry(room, "Value of the parameter"), "0.7");
    await enter(room, "Range of a parameter", "omega0=1:1.2:0.1");
    assert.equal(await verdict(room), before);
    assert.deepEqual(await errors(room), []);
    assert.equal(await room.getByRole("slider", { name: "Value of omega0 in the diagram" }).getAttribute("aria-valuetext"), "no value chosen");
    await enter(room, "Range of a parameter", "");
    assert.equal(await room.getByRole("slider", { name: "in the diagram" }).count(), 0);
  }));

test("letter by letter the range changes no more than at once", () =>
  visit(`chaos?set=c%3D1/2&value=1.2&over=A%3D1:1.5:0.1&${QUICKLY}`, async (room) => {
    const before = await verdict(room);
    const field = room.getByLabel("Range of a parameter", { exact: true });
    await field.focus();
    await room.keyboard.press("End");
    for (let left = (await field.inputValue()).length; left > 0; left -= 1) await room.keyboard.press("Backspace", { delay: left === 5 ? 500 : 20 });
    await settled(room);
    assert.equal(await verdict(room), before);
    await room.keyboard.type("omega=0.6:0.8:0.1", { delay: 60 });
    await settled(room);
    assert.equal(await verdict(room), before);
    assert.equal(await entry(room, "Values of parameters"), "c=1/2,A=1.2");
  }));

test("numbers are saved where there are some, and nowhere else", () =>
  visit(`chaos?set=c%3D1/2,A%3D0.5&value=&over=&${QUICKLY}`, async (room) => {
    const csv = (title) => part(room, title).getByRole("button", { name: "Save the numbers as CSV" });
    assert.equal(await csv("Bifurcation diagram").count(), 0);
    for (const title of ["Poincaré section", "Order or chaos?", "Periodic orbit"]) assert.ok((await saved(part(room, title), "Save the numbers as CSV")).bytes.length > 20, title);
    await enter(room, "Range of a parameter", "A=0.4:0.6:0.1");
    const { bytes } = await saved(part(room, "Bifurcation diagram"), "Save the numbers as CSV");
    assert.equal(bytes.toString(), command("bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2", "--over", "A=0.4:0.6:0.1", "--points", "5", "--sweep", "both", "--csv").output);
    await enter(room, "Range of a parameter", "A=0.4:0.6");
    assert.equal(await csv("Bifurcation diagram").count(), 0);
    await enter(room, "System or equation", "nonsense");
    for (const title of ["Poincaré section", "Order or chaos?", "Periodic orbit", "Bifurcation diagram"]) assert.equal(await csv(title).count(), 0, title);
  }));

test("what cannot be computed is answered beside its field", () =>
  visit(SMALL, async (room) => {
    for (const [label, entry, said] of [
      ["System or equation", "nonsense", /no system has the name/],
      ["System or equation", "driven_pendulum", undefined],
      ["Initial states", "q=1", /has no state variable/],
      ["Initial states", "theta=0.2", undefined],
      ["Values of parameters", "c=foo", /contains foo/],
      ["Values of parameters", "c=1/2", undefined],
      ["Range of a parameter", "A=1:2", /give START:STOP:STEP/],
      ["Range of a parameter", "A=1:1.5:0.05", undefined],
      ["Points of the section", "many", /give a whole number/],
    ]) {
      await enter(room, label, entry);
      if (said === undefined) assert.deepEqual(await errors(room), []);
      else assert.match((await errors(room))[0] ?? "", said);
      assert.equal((await room.getByLabel(label, { exact: true }).getAttribute("aria-invalid")) === "true", said !== undefined, entry);
    }
  }));

/** Records the first words of the queries of a room. */
async function listening(room) {
  await room.evaluate(() => {
    const post = Worker.prototype.postMessage;
    globalThis.asked = [];
    Worker.prototype.postMessage = function (message, ...more) {
      if (message.kind === "question") globalThis.asked.push(message.words[0]);
      return post.call(this, message, ...more);
    };
  });
  return () => room.evaluate(() => globalThis.asked.splice(0));
}

test("nothing further is asked unasked, nor again while it stays the same", () =>
  visit(SMALL, async (room) => {
    const asked = await listening(room);
    await enter(room, "Value of the parameter", "1.25");
    const first = await asked();
    assert.ok(first.includes("section") && first.includes("lyapunov"), first.join(" "));
    assert.deepEqual(first.filter((it) => ["response", "stability", "melnikov", "resonance"].includes(it)), []);
    // With keys, the part is unfolded, and its first field is next.
    await room.locator("summary", { hasText: "Thresholds of chaos" }).focus();
    await room.keyboard.press("Enter");
    await room.keyboard.press("Tab");
    await room.keyboard.type("A=0.1:1.5");
    await settled(room);
    assert.ok((await asked()).includes("melnikov"));
    assert.ok(await part(room, "Melnikov's thresholds").locator("svg").isVisible());
    await enter(room, "Value of the parameter", "1.3");
    const again = await asked();
    assert.ok(again.includes("section") && !again.includes("melnikov"), again.join(" "));
    await visit(new URL(room.url()).hash.slice(1), async (other) => {
      assert.ok(await part(other, "Melnikov's thresholds").locator("svg").isVisible());
      assert.ok(await other.getByLabel("Range of a parameter for thresholds").isVisible());
    });
  }));

test("a picture that needs more room than a phone has is drawn smaller", () =>
  visit(`${SMALL}&value=1.407&motions=20`, async (room) => {
    assert.notEqual(command("section", SYSTEM[0], "--set", "c=1/2,A=1.407", "--initial", "theta=0.2", "--initial", "theta=0.2001", "--points", "300", "--size", "column", "--figure", "-").status, 0);
    assert.deepEqual(await errors(room), []);
    assert.ok(await room.locator("p.verdict").isVisible());
  }, { viewport: PHONE }));

test("the numbers of the section are saved", () =>
  visit(SMALL, async (room) => {
    const button = room.locator("section", { hasText: "Poincaré section" }).getByRole("button", { name: "CSV" });
    const [download] = await Promise.all([room.waitForEvent("download"), button.click()]);
    const parts = [];
    for await (const part of await download.createReadStream()) parts.push(part);
    const words = ["section", SYSTEM[0], "--set", "c=1/2,A=1.2", "--initial", "theta=0.2", "--initial", "theta=0.2001", "--points", "300", "--csv"];
    assert.equal(Buffer.concat(parts).toString(), command(...words).output);
  }));

const DRIVEN = "chaos?over=&value=&set=c%3D1/2,A%3D1.2&initial=theta%3D0.2;theta%3D0.2001&points=20&intervals=10&until=5&motions=20";

test("sliders change the drive and the friction, and a pendulum that runs swings on", () =>
  visit(DRIVEN, async (room) => {
    const time = () => room.evaluate(() => Number(/t = ([\d.]+) s/.exec(document.querySelector(".fleet-words")?.textContent ?? "")?.[1]));
    const after = (least) => room.waitForFunction((least) => Number(/t = ([\d.]+) s/.exec(document.querySelector(".fleet-words")?.textContent ?? "")?.[1]) > least, least, { timeout: 60_000 });
    const slider = room.getByRole("slider", { name: "Strength of the drive" });
    assert.equal(await slider.getAttribute("aria-valuetext"), "A = 1.2 1/s²");
    await room.getByLabel("Speed").selectOption("5");
    await room.getByRole("button", { name: "Run the ensemble" }).click();
    await after(5);
    await slider.focus();
    await room.keyboard.press("ArrowLeft");
    assert.equal(await slider.getAttribute("aria-valuetext"), "A = 1.195 1/s²");
    await room.waitForFunction(() => Number(/t = ([\d.]+) s/.exec(document.querySelector(".fleet-words").textContent)?.[1]) < 5);
    await after(1);
    assert.ok(await room.getByRole("button", { name: "Pause the ensemble" }).isVisible());
    assert.equal(await entry(room, "Values of parameters"), "c=1/2,A=1.195");
    await slider.fill("0.9");
    await room.getByRole("slider", { name: "Friction" }).fill("0.5");
    await settled(room);
    assert.equal(await entry(room, "Values of parameters"), "A=0.9,c=0.5");
    assert.match(await room.locator("p.verdict").textContent(), /^(Regular|Undecided)/);
    const { hash } = new URL(room.url());
    await visit(`${hash.slice(1)}&time=10`, async (again) => {
      await again.waitForFunction(() => document.querySelector(".fleet-words")?.textContent.includes("t = 10.00 s"), null, { timeout: 60_000 });
      const { bytes } = await saved(again, "Save the states as CSV");
      const [, , theta, velocity] = bytes.toString().split("\n")[1].split(",").map(Number);
      // θ″ = −θ′/2 − sin θ + 0.9 cos(2t/3) from θ = 0.2 at rest, by mpmath's Taylor integration with 25 digits.
      assert.ok(Math.abs(theta - 1.6471867024) < 1e-6 && Math.abs(velocity - 0.8544171885) < 1e-6, `${theta} ${velocity}`);
    });
    assert.ok((await time()) >= 0);
  }));

test("the diagram follows one attractor at a time, or both in two colours", () =>
  visit(`${SMALL}&motions=20`, async (room) => {
    const diagram = part(room, "Bifurcation diagram");
    const colours = () => diagram.locator(".picture").evaluate((it) => it.shadowRoot.querySelectorAll("path.markers").length);
    assert.equal(await colours(), 2);
    await diagram.getByRole("button", { name: "up", exact: true }).click();
    await settled(room);
    assert.equal(await colours(), 1);
    assert.match(new URL(room.url()).hash, /sweep=up/);
    assert.equal(await diagram.getByRole("button", { name: "up", exact: true }).getAttribute("aria-pressed"), "true");
    const { bytes } = await saved(diagram, "Save the picture as SVG");
    assert.equal(bytes.toString(), command("bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2", "--over", "A=1:1.5:0.05", "--points", "10", "--sweep", "up", "--figure", "-").output);
  }));

test("pictures have their numbers as tables", () =>
  visit(`${SMALL}&motions=20`, async (room) => {
    for (const title of ["Bifurcation diagram", "Poincaré section", "Neighbouring motions", "Order or chaos?", "Periodic orbit", "The motion and its neighbours"]) {
      const found = part(room, title);
      await found.getByText("Numbers as a table").click();
      await found.locator("tbody tr").first().waitFor();
    }
    const { samples } = answer("simulate", "driven_pendulum", "--set", "c=1/2,A=1.2", "--initial", "theta=0.2", "--times", "0:100:2");
    const shown = await part(room, "Neighbouring motions").locator("tbody tr").nth(3).locator("th, td").allTextContents();
    assert.equal(Number(shown[0]), 6);
    assert.ok(Math.abs(Number(shown[1].replace("−", "-")) - samples[3].state[0]) < 1e-3);
  }));

test("out of sight nothing is drawn", () =>
  visit(DRIVEN, async (room) => {
    await room.evaluate(() => {
      globalThis.drawn = 0;
      const { clearRect } = CanvasRenderingContext2D.prototype;
      CanvasRenderingContext2D.prototype.clearRect = function (...all) {
        globalThis.drawn += 1;
        return clearRect.apply(this, all);
      };
    });
    await room.getByRole("button", { name: "Run the ensemble" }).click();
    await room.waitForFunction(() => globalThis.drawn > 20);
    await room.getByText("Equivalent command").scrollIntoViewIfNeeded();
    const seen = () => room.evaluate(() => new Promise((resolve) => {
      const sight = new IntersectionObserver((all) => resolve(all.some((it) => it.isIntersecting)));
      document.querySelectorAll(".fleet canvas").forEach((it) => sight.observe(it));
    }));
    assert.equal(await seen(), false);
    const before = await room.evaluate(() => globalThis.drawn);
    const text = await room.locator(".fleet-words").textContent();
    await room.waitForFunction((text) => document.querySelector(".fleet-words").textContent !== text, text);
    assert.equal(await room.evaluate(() => globalThis.drawn), before);
    await room.locator(".fleet").scrollIntoViewIfNeeded();
    await room.waitForFunction((before) => globalThis.drawn > before, before);
  }));

test("neither examples nor messages have options, keys or backticks", () =>
  visit(`${SMALL}&motions=20`, async (room) => {
    for (const name of await room.getByLabel("Example").locator("option").allTextContents()) assert.doesNotMatch(name, /_|`|--/);
    for (const [label, wrong] of [["System or equation", "nonsense"], ["System or equation", "x'' = q"], ["Initial states", "q=1"], ["Values of parameters", "c="], ["Values of parameters", "c=foo"], ["Range of a parameter", "A=1:2"], ["Points of the section", "many"], ["Section at zeros of the formula", "1/"]]) {
      const before = await entry(room, label);
      await enter(room, label, wrong);
      const said = [...(await errors(room)), ...(await room.locator(".results .quiet:visible").allTextContents())].join(" ");
      assert.ok(said.length > 10, wrong);
      assert.doesNotMatch(said, /`|--[a-z]/, wrong);
      await enter(room, label, before);
    }
  }));
