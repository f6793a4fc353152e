// A thousand answers of each module beside those of the command on this machine: the same bits, the same bytes. In node they are found without a
// fused multiply-add, in chromium with that of the processor. Sentences are read without the marks of the page, as they are in the files it saves.

import assert from "node:assert/strict";
import { build } from "esbuild";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import vm from "node:vm";
import { answer, close, command, EXAMPLES, visit } from "./harness.mjs";

after(close);
const here = (path) => fileURLToPath(new URL(path, import.meta.url));

async function bundled(contents, define = {}) {
  const stdin = { contents, resolveDir: here("../src"), loader: "ts" };
  const { outputFiles } = await build({ stdin, bundle: true, format: "iife", write: false, define });
  return outputFiles[0].text;
}
const WORKER = await bundled(`import "./engine/worker.ts"`);
const page = vm.createContext({});
vm.runInContext(await bundled(`import { unmarked } from "./parts/marks.ts"; Object.assign(globalThis, { unmarked });`), page);

/** Numbers from 0 to 1 by the congruences of Knuth's MMIX, always the same. */
let state = 7n;
function draw(from, to) {
  state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
  return from + ((to - from) * Number(state >> 32n)) / 2 ** 32;
}

/** 25 motions at 40 times each, some of them next to the top. */
const TIMES = 40;
const MOTIONS = Array.from({ length: 25 }, (_, n) => ({
  angle: n % 5 === 4 ? `pi-${10 ** draw(-300, -1)}` : `${draw(-3.1, 3.1)}`,
  velocity: n % 3 === 0 ? 0 : draw(-9, 9),
  first: draw(0, 100),
  step: draw(0, 10),
}));

/** The states that the command has, from decimals that read back as the same numbers. */
const STATES = MOTIONS.map(({ angle, velocity, first, step }) => {
  const times = Array.from({ length: TIMES }, (_, n) => first + n * step);
  const { output, error, status } = command("motion", `--velocity=${velocity}`, "--times", times.join(","), "--json", "--", angle);
  assert.equal(status, 0, error);
  return JSON.parse(output).samples.map((sample) => [sample.angle_rad, sample.velocity_rad_per_s]);
});

const QUESTIONS = [
  ["period", "60deg", "1.2", "pi-1e-300", "--json"],
  ["period", "1deg:179deg:0.18deg", "--csv"],
  ["motion", "150deg", "--times", "0:10:0.1", "--compare", "small-angle,fourier-7", "--csv"],
  ["motion", "0", "--velocity", "7rad/s", "--times", "0,1,2", "--figure", "-"],
  ["fourier", "170deg", "--json"],
  ["formulas", "--amplitude", "90deg", "--tolerance", "1e-3"],
  ["expand", "pendulum", "--order", "9", "--json"],
  ["decay", "60deg", "--linear", "0.1", "--cycles", "3", "--json"],
  ["simulate", "double_pendulum", "--initial", "theta1=120deg,theta2=120deg", "--times", "0:10:0.1", "--csv"],
  ["simulate", "driven_pendulum", "--set", "A=1.2,c=1/2", "--initial", "theta=0.1", "--times", "0:60:1", "--json"],
  ["section", "driven_pendulum", "--set", "A=1.5,c=1/2", "--initial", "theta=0.2", "--points", "20", "--skip", "1", "--csv"],
  ["lyapunov", "driven_pendulum", "--set", "A=1.5,c=1/2", "--initial", "theta=0.2", "--time", "50", "--json"],
  ["derive", "--method", "elliptic"],
  ["inspect", "swing_synthetic.csv", "--json"],
  ["fit", "periods", "period_table_synthetic.csv", "--length", "0.9940(5) m", "--json"],
  ["fit", "lengths", "lengths_synthetic.csv", "--amplitude", "10deg", "--json"],
  ["fit", "trace", "swing_synthetic.csv", "--length", "0.56m±0.002m", "--json"],
  ["figure", "errors", "--output", "-"],
  ["period", "60degg"],
  ["period", "200deg"],
];
const FILES = Object.fromEntries(["swing_synthetic.csv", "period_table_synthetic.csv", "lengths_synthetic.csv"].map((name) => [name, readFileSync(EXAMPLES + name, "utf8")]));
const ANSWERS = QUESTIONS.map((words) => command(...words));

function compareStates(found) {
  MOTIONS.forEach(({ angle, velocity }, n) => assert.deepEqual(found[n], STATES[n], `${angle}, ${velocity} rad/s`));
}

/** The message of an error without parameters, which the messages of these questions do not name. */
const reasonOf = (error) => error.message.join("");

function compareAnswers(found) {
  QUESTIONS.forEach((words, n) => {
    const { status, output, error } = found[n];
    assert.equal(page.unmarked(output), ANSWERS[n].output, words.join(" "));
    assert.equal(status, ANSWERS[n].status, words.join(" "));
    const said = ANSWERS[n].error.replace(/^note: .*\n/gm, "").replace(/^error: /, "");
    assert.ok(said.includes(error) && (error === "") === (said === ""), `${error} instead of ${said}`);
  });
}

test("a thousand states in node", async () => {
  const script = await bundled(`import { Mathematics } from "./engine/mathematics.ts"; globalThis.Mathematics = Mathematics;`);
  const context = vm.createContext({ WebAssembly, TextEncoder, TextDecoder, URLSearchParams });
  vm.runInContext(script, context);
  const mathematics = await context.Mathematics.from(new WebAssembly.Module(readFileSync(here("../dist/pendulum.wasm"))));
  compareStates(MOTIONS.map(({ angle, velocity, first, step }) => {
    assert.equal(mathematics.launch(angle, velocity, 1, 9.80665).error, undefined);
    const { angles, velocities } = mathematics.states(first, step, TIMES);
    return Array.from(angles, (it, n) => [it, velocities[n]]);
  }));
});

test("a thousand periods and every kind of question in node", async () => {
  const messages = [];
  const context = vm.createContext({ WebAssembly, TextEncoder, TextDecoder, postMessage: (message) => messages.push(message) });
  vm.runInContext(WORKER, context);
  await context.onmessage({ data: { kind: "module", module: new WebAssembly.Module(readFileSync(here("../dist/whole.wasm"))) } });
  const files = new Map(Object.entries(FILES).map(([name, text]) => [name, Buffer.from(text)]));
  const found = [];
  for (const words of QUESTIONS) {
    messages.length = 0;
    await context.onmessage({ data: { kind: "question", words, files } });
    const end = messages.at(-1);
    assert.equal(end.kind, "end", JSON.stringify(end));
    const output = Buffer.concat(messages.filter(({ kind }) => kind === "output").map(({ chunk }) => chunk)).toString();
    found.push({ status: end.status, error: reasonOf(end.error), output });
  }
  compareAnswers(found);
});

test("the same in chromium, with both modules of the page", () =>
  visit("about", async (room) => {
    const probe = `import { WorkerEngine } from "./engine/worker_engine.ts"; import { Mathematics } from "./engine/mathematics.ts";
      Object.assign(globalThis, { WorkerEngine, Mathematics });`;
    await room.addScriptTag({ content: await bundled(probe, { WORKER_SOURCE: JSON.stringify(WORKER) }) });
    compareStates(await room.evaluate(async ({ motions, times }) => {
      const mathematics = await Mathematics.load();
      return motions.map(({ angle, velocity, first, step }) => {
        mathematics.launch(angle, velocity, 1, 9.80665);
        const { angles, velocities } = mathematics.states(first, step, times);
        return Array.from(angles, (it, n) => [it, velocities[n]]);
      });
    }, { motions: MOTIONS, times: TIMES }));
    compareAnswers(await room.evaluate(async ({ questions, given }) => {
      const files = new Map(Object.entries(given).map(([name, text]) => [name, new TextEncoder().encode(text)]));
      const engine = new WorkerEngine();
      const answers = await Promise.all(questions.map((words) => engine.ask({ words, files })));
      return answers.map(({ status, error, output }) => ({ status, error: error.message.join(""), output: new TextDecoder().decode(output) }));
    }, { questions: QUESTIONS, given: FILES }));
  }, { bypassCSP: true }));

test("a question that is stopped is answered as the interrupted command does it, and its worker goes on", () =>
  visit("about", async (room) => {
    await room.addScriptTag({ content: await bundled(`import { WorkerEngine } from "./engine/worker_engine.ts"; Object.assign(globalThis, { WorkerEngine });`, { WORKER_SOURCE: JSON.stringify(WORKER) }) });
    const words = ["section", "driven_pendulum", "--set", "A=1.5,c=1/2", "--initial", "theta=0.2", "--points", "10000000", "--json"];
    const found = await room.evaluate(async (words) => {
      const engine = new WorkerEngine();
      await engine.ask({ words: ["period", "60deg"] });
      const told = [];
      const { status, error, output } = await engine.ask({ words, signal: AbortSignal.timeout(2500), onProgress: (howFar) => told.push(howFar) });
      return { status, error: error.text, told, output: new TextDecoder().decode(output) };
    }, words);
    assert.deepEqual([found.status, found.error], [130, "interrupted: the points up to then are written"]);
    const points = JSON.parse(found.output).points;
    assert.ok(points.length > 10, `${points.length} points`);
    const whole = answer(...words.slice(0, -2), String(points.length));
    assert.deepEqual(points, whole.points);
    assert.match(found.told[0], /^\d+ of 10000000 points$/);
  }, { bypassCSP: true }));

test("hostile questions end in a sentence, and what comes after is answered", () =>
  visit("about", async (room) => {
    await room.addScriptTag({ content: await bundled(`import { WorkerEngine } from "./engine/worker_engine.ts"; Object.assign(globalThis, { WorkerEngine });`, { WORKER_SOURCE: JSON.stringify(WORKER) }) });
    const statuses = await room.evaluate(async () => {
      const engine = new WorkerEngine();
      const deep = (count) => `x'' + ${"(".repeat(count)}x${")".repeat(count)} = 0`;
      const answers = [
        await engine.ask({ words: ["expand", deep(1e5)] }),
        await engine.ask({ words: ["simulate", `x'' = ${"sin(".repeat(2e4)}x${")".repeat(2e4)}`, "--initial", "x=1", "--times", "0,1"] }),
        await engine.ask({ words: ["period", "9".repeat(40_000)] }),
        await engine.ask({ words: ["inspect", "a.zip"], files: new Map([["a.zip", new Uint8Array([0x50, 0x4b, 3, 4, 255, 255, 255, 255])]]) }),
        await engine.ask({ words: ["fit", "trace", "-"], files: new Map([["-", new Uint8Array(1e6).fill(255)]]) }),
        await engine.ask({ words: ["sweep", "period", "--over", "amplitude=1:2:1", "--output", "store"] }),
        await engine.ask({ words: ["lyapunov", "double_pendulum", "--initial", "theta1=3", "--time", "1e6"], signal: AbortSignal.timeout(1000) }),
        await engine.ask({ words: ["period", "60deg"] }),
      ];
      const last = new TextDecoder().decode(answers.at(-1).output);
      return [last, ...answers.map(({ status, error }) => [status, error.text.length > 0 && error.text.length < 4000])];
    });
    assert.match(statuses.shift(), /^amplitude/);
    assert.deepEqual(statuses.slice(-2), [[130, true], [0, false]]);
    for (const [status, isSaid] of statuses.slice(0, -2)) assert.ok(isSaid && (status === 1 || status === 2), JSON.stringify(statuses));
  }, { bypassCSP: true }));
