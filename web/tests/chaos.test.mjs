// Room 6 beside the command: diagrams, sections, neighbours and verdicts, and what cannot be computed.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { answer, close, command, enter, errors, PHONE, saved, settled, visit } from "./harness.mjs";

after(close);
const SYSTEM = ["driven_pendulum", "--initial", "theta=0.2"];
const SMALL = "chaos?over=A%3D1:1.5:0.05&each=10&points=300&intervals=100";

test("pictures and verdict are the command's", () =>
  visit(SMALL, async (room) => {
    const at = ["driven_pendulum", "--set", "c=1/2,A=1.2"];
    const asked = [
      ["bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2", "--over", "A=1:1.5:0.05", "--points", "10", "--figure", "-"],
      ["section", ...at, "--initial", "theta=0.2", "--initial", "theta=0.2001", "--points", "300", "--figure", "-"],
      ["figure", "trajectories", ...at, "--initial", "theta=0.2", "--initial", "theta=0.2001", "--until", "100", "--output", "-"],
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
    const slider = room.getByRole("slider");
    await slider.focus();
    await room.keyboard.press("ArrowRight");
    await settled(room);
    assert.equal(await slider.getAttribute("aria-valuetext"), "A = 1.25");
    const { x, y, width, height } = await slider.boundingBox();
    await room.mouse.click(x + width * 0.8, y + height / 2);
    await settled(room);
    const chosen = await slider.getAttribute("aria-valuetext");
    assert.notEqual(chosen, "A = 1.25");
    const verdict = await room.locator("p.verdict").textContent();
    await visit(new URL(room.url()).hash.slice(1), async (again) => {
      assert.equal(await again.getByRole("slider").getAttribute("aria-valuetext"), chosen);
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
    const begin = room.getByLabel("Begin with");
    for (const value of ["stars", "double", "upright"]) {
      await begin.selectOption(value);
      await settled(room);
      assert.deepEqual(await errors(room), [], value);
      assert.match(await room.locator("p.verdict").textContent(), /^(Regular|Chaotic|Undecided): /);
      assert.equal(await begin.inputValue(), value);
    }
  }));

test("what cannot be computed is answered beside its field", () =>
  visit(SMALL, async (room) => {
    for (const [label, entry, said] of [
      ["System or equation", "nonsense", /no system has the key/],
      ["System or equation", "driven_pendulum", undefined],
      ["Starts", "q=1", /has no state variable/],
      ["Starts", "theta=0.2", undefined],
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

test("the periodic orbit and the answers over a parameter are the command's", () =>
  visit("chaos?set=A%3D0.15,c%3D0.1&initial=theta%3D0&over=&value=&points=20&intervals=10&until=5&response=omega%3D0.75:0.9", async (room) => {
    const part = (title) => room.locator("section", { has: room.getByRole("heading", { name: title }) });
    await room.waitForFunction(() => document.querySelector(".results")?.getAttribute("aria-busy") === "false");
    const system = ["driven_pendulum", "--set", "A=0.15,c=0.1", "--initial", "theta=0"];
    const orbit = answer("orbit", ...system);
    assert.match(await part("Periodic orbit").innerText(), new RegExp(`period is ${orbit.period_s.toPrecision(9)} s. It is stable`));
    const { jumps } = answer("response", ...system, "--over", "omega=0.75:0.9");
    assert.equal(jumps.length, 2);
    const said = await part("Periodic answers over a parameter").innerText();
    for (const { parameter, sweep } of jumps) assert.ok(said.includes(`Swept ${sweep}, the amplitude jumps at omega = ${parameter.toPrecision(6)}`), said);
    for (const [title, words] of [["Periodic orbit", ["orbit", ...system, "--figure", "-"]], ["Periodic answers over a parameter", ["response", ...system, "--over", "omega=0.75:0.9", "--figure", "-"]]]) {
      const { bytes } = await saved(part(title), "Save the picture as SVG");
      assert.equal(bytes.toString(), command(...words).output, title);
    }
    await enter(room, "Range of a parameter for the response", "omega=1:2:0.1");
    assert.match((await errors(room)).join(" "), /FROM:TO/);
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
