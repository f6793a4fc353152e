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
