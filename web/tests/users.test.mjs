// The page in the hands of its users: what they see first, what fingers touch, and entries that nobody expects.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, DESK, enter, errors, settled, visit } from "./harness.mjs";

after(close);
const FINGER = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

test("powers and indices of a picture are raised and lowered as in the command's", () =>
  visit("formulas", async (room) => {
    const places = () => room.evaluate(() => [...document.querySelectorAll(".picture")].flatMap(({ shadowRoot }) => [...(shadowRoot?.querySelectorAll("text") ?? [])].map((it) => [it.textContent, Number(it.querySelector("tspan")?.getAttribute("dy"))])));
    await room.waitForFunction(() => [...document.querySelectorAll(".picture")].some(({ shadowRoot }) => shadowRoot?.querySelector("text.y-tick")));
    const all = new Map(await places());
    assert.ok(all.get("10−3") < 0, `${all.get("10−3")}`);
    assert.ok([...all].find(([text]) => text.startsWith("amplitude θ0"))[1] > 0);
  }));

for (const entries of ["angle=999999999999deg&second=yes", "angle=5deg&second=yes&angle2=-1e12deg", "velocity=1e12rad/s&second=yes", "t=1e300"]) {
  test(`the page lives with ${entries}`, () =>
    visit(`pendulum?t=0&${entries}`, async (room) => {
      for (const title of ["Angle", "Phase plane with separatrix"]) await room.locator(".plot", { hasText: title }).first().scrollIntoViewIfNeeded();
      assert.match(await room.locator(".readout.period strong").textContent(), /\d s$/);
    }));
}

test("a wrong force is refused at its field, in words", () =>
  visit("pendulum?t=0", async (room) => {
    await room.getByText("Damping and driving").click();
    const field = room.locator(".field", { has: room.getByLabel("Dry friction f in 1/s²") });
    for (const [entry, words] of [["fast", /^the value of f contains fast: give a constant/], ["1e400", /the motion is known up to there/]]) {
      await enter(room, "Dry friction f in 1/s²", entry);
      await room.waitForFunction(() => [...document.querySelectorAll(".error")].some((it) => it.textContent !== ""));
      assert.match(await field.locator(".error").textContent(), words);
      assert.equal((await errors(room)).length, 1);
    }
  }));

test("an order and a number of points that are too large are refused at once", async () => {
  await visit("perturbation", async (room) => {
    await enter(room, "Order", "999999999999");
    assert.deepEqual(await errors(room), ["give a whole number from 1 to 1000"]);
  });
  await visit("chaos?over=&sweep=&points=999999999999&intervals=20", async (room) => {
    assert.match((await errors(room)).join(), /10000000/);
  });
});

test("the settings of the first screen fit it, and its ruler leaves the bob free", () =>
  visit("pendulum?angle=10deg&t=0&ruler=yes", async (room) => {
    assert.equal(await room.locator(".bench-panel").evaluate((it) => it.scrollHeight - it.clientHeight), 0);
    const ruler = await room.locator(".ruler").boundingBox();
    const stage = await room.locator("canvas.stage").boundingBox();
    assert.ok(ruler.x + ruler.width < stage.x + stage.width / 2, `${ruler.x}`);
  }, { viewport: DESK }));

test("a finger meets controls of 44 px", async () => {
  for (const fragment of ["pendulum?t=0&gate=yes&stopwatch=yes", "formulas", "derivations", "laboratory"]) {
    await visit(fragment, async (room) => {
      const low = await room.locator("main :is(button:not(.term), select, input[type=text], input[type=range], .shown label), details.fields > summary").evaluateAll((all) => all.filter((it) => it.checkVisibility() && it.getBoundingClientRect().height < 43.5).map((it) => it.textContent || it.name || it.ariaLabel));
      assert.deepEqual(low, [], fragment);
    }, FINGER);
  }
});

test("on a phone the room that is open is seen in the navigation, and the motion before the fields", async () => {
  for (const fragment of ["derivations", "laboratory", "about"]) {
    await visit(fragment, async (room) => {
      const { left, right } = await room.locator("nav a[aria-current]").evaluate((it) => it.getBoundingClientRect().toJSON());
      assert.ok(left >= 0 && right <= 390, `${fragment}: from ${left} to ${right}`);
    }, FINGER);
  }
  await visit("chaos?over=&sweep=&points=50&intervals=20", async (room) => {
    const top = (it) => it.evaluate((element) => element.getBoundingClientRect().top);
    assert.ok((await top(room.getByRole("button", { name: "Run the ensemble" }))) < (await top(room.getByText("Values of parameters").or(room.locator("summary", { hasText: "System" })).first())));
  }, FINGER);
});

test("a table of trials with its times is as wide as a phone", () =>
  visit("pendulum?t=0&trials=10:0.2:10:9.01", async (room) => {
    const { right } = await room.getByLabel("time 1 / s, row 1").evaluate((it) => it.getBoundingClientRect().toJSON());
    assert.ok(right <= 390, `${right}`);
    await settled(room);
  }, FINGER));

test("on paper the words of a sentence and the names of a table stay, and the stage keeps to its place", async () => {
  const onPaper = (fragment, use) => visit(fragment, async (room) => {
    await room.emulateMedia({ media: "print" });
    await use(room);
  }, { viewport: { width: 718, height: 1000 }, isMobile: false });
  await onPaper("pendulum?t=0&angle=10deg", async (room) => {
    assert.match(await room.locator(".plot", { hasText: "Phase plane" }).innerText(), /outside the dashed separatrix the pendulum/);
    const [stage, next] = await room.locator("canvas.stage, .how").evaluateAll((all) => all.map((it) => it.getBoundingClientRect().toJSON()));
    assert.ok(stage.bottom <= next.top && stage.right <= 718, JSON.stringify([stage, next]));
    assert.equal(await room.locator(".adding:visible, .try:visible").count(), 0);
  });
  await onPaper("formulas", async (room) => {
    await room.getByRole("cell", { name: "yes" }).first().waitFor();
    assert.match(await room.locator("table", { hasText: "The chosen formulas" }).innerText(), /Bernoulli/);
  });
  await onPaper("chaos?over=&sweep=&points=50&intervals=20", async (room) => assert.equal(await room.locator("details.fields:visible").count(), 0));
});

test("with forced colours it is seen what is chosen, and the energy", () =>
  visit("pendulum?t=0&angle=40deg&arrows=yes", async (room) => {
    const colour = (it) => it.evaluate((element) => getComputedStyle(element).backgroundColor);
    const label = (name) => room.locator(".shown label", { hasText: name });
    assert.notEqual(await colour(label("Arrows")), await colour(label("Ruler")));
    assert.notEqual(await colour(room.locator(".bar i.potential")), await colour(room.locator(".bar .track").first()));
    const border = (it) => it.evaluate((element) => getComputedStyle(element).borderBottomColor);
    assert.notEqual(await border(room.getByRole("link", { name: "The pendulum" })), await border(room.getByRole("link", { name: "About" })));
  }, { forcedColors: "active" }));

test("on a phone on its side the circle fills the height of the stage", () =>
  visit("pendulum?t=0&angle=40deg&ruler=yes", async (room) => {
    const [canvas, stage, ruler] = await room.locator("canvas.stage, .bench-stage, .ruler").evaluateAll((all) => ["canvas.stage", ".bench-stage", ".ruler"].map((kind) => all.find((it) => it.matches(kind)).getBoundingClientRect().toJSON()));
    assert.equal(canvas.height, stage.height);
    assert.ok(ruler.right < canvas.x + canvas.width / 2 && ruler.right > canvas.x + canvas.width / 2 - 20, JSON.stringify([ruler, canvas]));
  }, { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true }));

test("a measured time is announced with the way to the table", () =>
  visit("pendulum?t=0&stopwatch=yes&speed=4", async (room) => {
    const stopwatch = room.getByRole("group", { name: "Stopwatch" });
    await stopwatch.getByRole("button", { name: "Start" }).click();
    await room.getByRole("button", { name: "Run", exact: true }).click();
    await room.waitForTimeout(300);
    await stopwatch.getByRole("button", { name: "Into the table" }).click();
    await room.getByRole("status").getByRole("button", { name: "To the table: 1 trial" }).click();
    const { top } = await room.getByRole("heading", { name: "Table of trials" }).evaluate((it) => it.getBoundingClientRect().toJSON());
    assert.ok(top >= 0 && top < 400, `${top}`);
  }));

test("pasted text is read with semicolons too, and what is not a number is named", () =>
  visit("pendulum?t=0", async (room) => {
    const cell = room.getByLabel("amplitude / °, row 1");
    const paste = (text) => cell.evaluate((it, data) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData("text/plain", data);
      it.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
    }, text);
    await paste("Amplitude\tLänge\n\n????");
    assert.equal(await room.locator(".trials .error:visible").textContent(), "The pasted text has no line with a number.");
    await paste("Winkel;l / m;n;t\n10;0,2;10;9,01\n10;0,4;10;12,7o\n10;0,6;10;15,6");
    assert.equal(await room.getByLabel("time 1 / s, row 1").inputValue(), "9,01");
    await room.getByRole("button", { name: "Find g" }).click();
    assert.equal(await room.locator(".trials .error:visible").textContent(), "time 1 / s, row 2: “12,7o” is not a number.");
  }));

test("an unknown system and a force without limits are answered without keys and commands", () =>
  visit("chaos?over=&sweep=&points=50&intervals=20&until=5&system=nonsense", async (room) => {
    const shown = () => room.waitForFunction(() => [...document.querySelectorAll(".error")].some((it) => it.checkVisibility() && it.textContent !== ""));
    const all = () => room.locator(".error:visible").allTextContents().then((texts) => texts.filter((it) => it !== "").join("\n"));
    await shown();
    assert.match(await all(), /no system has the name “nonsense”; write its equations, as x'' = y - x/);
    assert.doesNotMatch(await all(), /keys|_/);
    await enter(room, "System or equation", "driven_pendulum");
    await enter(room, "Values of parameters", "c=1e400");
    await shown();
    assert.match(await all(), /^a part of the equations of motion is beyond/);
  }));
