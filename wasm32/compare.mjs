// Compares the results of modules with those of the native program, the first argument. The modules are the portable one and, if given, one
// compiled for relaxed vector instructions, which is skipped if node or the processor does not support them.

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";

const [native, plain, relaxed] = process.argv.slice(2).filter((argument) => !argument.startsWith("--"));
const expected = execFileSync(native, { encoding: "utf8", maxBuffer: 1 << 28 }).trim().split("\n");

/** The module's functions; a message if they are not available, or round twice. */
async function functions(file) {
    try {
        const { instance } = await WebAssembly.instantiate(readFileSync(file), {});
        return instance.exports.rounds_once() ? instance.exports : "this processor rounds sums of products twice";
    } catch (error) {
        if (error instanceof WebAssembly.CompileError) return "this version of node has no relaxed vector instructions";
        throw error;
    }
}

/** The number of wrong results. */
function compare(name, { count, bits }) {
    if (count() !== expected.length) {
        console.error(`${count()} answers on ${name}, ${expected.length} natively`);
        return 1;
    }
    const hexadecimal = (index) => BigInt.asUintN(64, bits(index)).toString(16).padStart(16, "0");
    const wrong = expected.flatMap((answer, index) => (hexadecimal(index) === answer ? [] : [index]));
    for (const index of wrong.slice(0, 20)) {
        console.error(`answer ${index}: ${hexadecimal(index)} on ${name}, ${expected[index]} natively`);
    }
    console.log(`${name}: ${expected.length} answers, ${wrong.length} with other bits than natively`);
    return wrong.length;
}

function times(name, { sum_of_periods, sum_of_angles }) {
    const natively = execFileSync(native, ["--times"], { encoding: "utf8" }).trim().split("\n");
    const functions = { periods: sum_of_periods, angles: sum_of_angles };
    for (const [what, milliseconds] of natively.map((line) => line.split(" "))) {
        const begin = performance.now();
        functions[what](1_000_000);
        const here = performance.now() - begin;
        console.log(`1e6 ${what}: ${here.toFixed(0)} ms on ${name}, ${Number(milliseconds).toFixed(1)} ms natively`);
    }
}

let wrong = 0;
for (const [name, file] of [["wasm32", plain], ["relaxed wasm32", relaxed]].filter(([, file]) => file)) {
    const module = await functions(file);
    if (typeof module === "string") {
        if (file === plain) throw new Error(module);
        console.log(`${name}: left out, ${module}`);
        continue;
    }
    wrong += compare(name, module);
    if (process.argv.includes("--times")) times(name, module);
}
process.exit(wrong === 0 ? 0 : 1);
