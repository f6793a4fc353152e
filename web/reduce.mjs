// Keeps of a module what the page calls, and orders it: node reduce.mjs MODULE OUTPUT. Functions and locals that are used most get the smallest
// numbers, stores of what a local has and second copies of functions go: eight seconds, a seventieth of the compressed bytes. (Optimising it
// anew takes minutes, and compressed it gains nothing.)
//
// A package far below asks for random numbers by functions of a browser that nothing calls; they go with the exports that are not ours.

import { execFileSync } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";

const [made, output] = process.argv.slice(2);
const tool = (name) => new URL(`node_modules/binaryen/bin/${name}`, import.meta.url).pathname;
const features = ["bulk-memory", "bulk-memory-opt", "nontrapping-float-to-int", "sign-ext", "mutable-globals", "reference-types", "multivalue", "call-indirect-overlong"];
const enabled = features.map((feature) => `--enable-${feature}`);

const foreign = /^__|^fma$/;
const roots = WebAssembly.Module.exports(new WebAssembly.Module(readFileSync(made))).map(({ name }) => name).filter((name) => !foreign.test(name));
const graph = [{ name: "page", root: true, reaches: roots }, ...roots.map((name) => ({ name, export: name }))];
const graphFile = `${output}.graph`;
writeFileSync(graphFile, JSON.stringify(graph));
execFileSync(process.execPath, [tool("wasm-metadce"), made, `--graph-file=${graphFile}`, "-o", output, ...enabled], { stdio: ["ignore", "ignore", "inherit"] });
rmSync(graphFile);
const passes = ["duplicate-function-elimination", "rse", "vacuum", "reorder-functions", "reorder-locals"].map((pass) => `--${pass}`);
execFileSync(process.execPath, [tool("wasm-opt"), output, ...passes, "-o", output, ...enabled], { stdio: ["ignore", "ignore", "inherit"] });

const imports = WebAssembly.Module.imports(new WebAssembly.Module(readFileSync(output)));
const strange = imports.filter(({ module }) => module !== "page" && module !== "fused");
if (strange.length > 0) throw new Error(`the module wants ${strange.map(({ module, name }) => `${module}.${name}`)}`);
