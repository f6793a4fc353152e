// Keeps of a module what the page calls: node reduce.mjs MODULE OUTPUT. (Optimising it once more takes minutes, and compressed it gains nothing.)
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

const imports = WebAssembly.Module.imports(new WebAssembly.Module(readFileSync(output)));
const strange = imports.filter(({ module }) => module !== "page" && module !== "fused");
if (strange.length > 0) throw new Error(`the module wants ${strange.map(({ module, name }) => `${module}.${name}`)}`);
