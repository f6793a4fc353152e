// Compares the answers of a module, the first argument, with those of the native program, the second.

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";

const [wasm, native] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(wasm), {});
const { count, bits, sum_of_periods, sum_of_angles } = instance.exports;

const expected = execFileSync(native, { encoding: "utf8", maxBuffer: 1 << 28 }).trim().split("\n");
if (count() !== expected.length) {
    console.error(`${count()} answers on wasm32, ${expected.length} natively`);
    process.exit(1);
}
const hexadecimal = (index) => BigInt.asUintN(64, bits(index)).toString(16).padStart(16, "0");
const wrong = expected.flatMap((answer, index) => (hexadecimal(index) === answer ? [] : [index]));
for (const index of wrong.slice(0, 20)) {
    console.error(`answer ${index}: ${hexadecimal(index)} on wasm32, ${expected[index]} natively`);
}
console.log(`wasm32: ${expected.length} answers, ${wrong.length} with other bits than natively`);

if (process.argv.includes("--times")) {
    const times = execFileSync(native, ["--times"], { encoding: "utf8" }).trim().split("\n");
    const modules = { periods: sum_of_periods, angles: sum_of_angles };
    for (const [name, natively] of times.map((line) => line.split(" "))) {
        const begin = performance.now();
        modules[name](1_000_000);
        const here = performance.now() - begin;
        console.log(`1e6 ${name}: ${here.toFixed(0)} ms on wasm32, ${Number(natively).toFixed(1)} ms natively`);
    }
}
process.exit(wrong.length === 0 ? 0 : 1);
