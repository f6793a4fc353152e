// Builds the page: node bundle.mjs OUTPUT [ID=MODULE.wasm …]. Prints the size of each part.

import { build } from "esbuild";
import { licences } from "./licences.mjs";
import { mathematicsFont } from "./mathematics_font.mjs";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

const [output, ...given] = process.argv.slice(2);
const here = (path) => new URL(path, import.meta.url).pathname;
const target = ["chrome120", "firefox125", "safari17.4"];

async function bundled(path, define = {}) {
  const options = { entryPoints: [here(path)], bundle: true, minify: true, write: false, charset: "utf8" };
  const { outputFiles } = await build({ ...options, target, define, format: "iife", legalComments: "none" });
  return outputFiles[0].text.trimEnd();
}

/** The compressed bytes, in the format that `src/engine/lzma.ts` decompresses. */
function lzma(bytes) {
  const made = execFileSync("xz", ["--format=lzma", "--lzma1=preset=9e,lc=4,pb=0,nice=128", "--stdout"], { input: bytes, maxBuffer: 1 << 28 });
  // xz, which writes to a pipe, leaves the size open.
  made.writeBigUInt64LE(BigInt(bytes.length), 5);
  return made;
}

/** The text that `src/engine/base94.ts` reads; zeros fill the last block. */
function base94(bytes) {
  const letter = (value) => String.fromCharCode(value + (value < 28 ? 32 : 33));
  const block = (from) => {
    let number = BigInt(`0x${bytes.subarray(from, from + 9).toString("hex").padEnd(18, "0")}`);
    let text = "";
    for (let place = 0; place < 11; place++, number /= 94n) text = letter(Number(number % 94n)) + text;
    return text;
  };
  return Array.from({ length: Math.ceil(bytes.length / 9) }, (_, n) => block(9 * n)).join("");
}

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const version = readFileSync(here("../Cargo.toml"), "utf8").match(/^version = "(.+)"$/m)[1];
const worker = await bundled("src/engine/worker.ts");
const program = await bundled("src/main.ts", { WORKER_SOURCE: JSON.stringify(worker), VERSION: JSON.stringify(version) });
// A script element must not contain its end tag.
const script = (await bundled("src/start.ts")).replaceAll("</script", "<\\/script");
// What stands in the page itself is not shown before the style sheet is there.
const style = "header,.skip{visibility:hidden}";
const sizes = [["script", Buffer.byteLength(script), gzipSync(script, { level: 9 }).length, Buffer.byteLength(script)]];

/** Compressed parts, in script elements that are not executed. */
const packed = new Map();
function pack(id, raw) {
  const compressed = lzma(raw);
  const text = base94(compressed);
  packed.set(id, `<script type="text/plain" id="${id}">${text}</script>`);
  sizes.push([id, raw.length, compressed.length, text.length]);
}
const streams = await build({ entryPoints: [here("src/engine/streams.ts")], bundle: true, write: false, format: "esm" });
const { joined, split } = await import(`data:text/javascript;base64,${Buffer.from(streams.outputFiles[0].contents).toString("base64")}`);

/** The streams of a module, from which the page makes the module again. */
function inStreams(module) {
  const made = split(module);
  const again = joined(made);
  if (again.length !== module.length || !WebAssembly.validate(again) || Buffer.compare(split(again), made) !== 0) throw new Error("the module does not come back from its streams");
  return made;
}
for (const [id, path] of given.map((pair) => pair.split("="))) {
  const module = readFileSync(path);
  // The small module, which the first picture waits for, stays as it is.
  pack(id, id === "whole" ? inStreams(module) : module);
}
pack("style", Buffer.from(await bundled("src/style.css")));
pack("font", await mathematicsFont());
pack("program", Buffer.from(program));
pack("licences", Buffer.from(licences(["libration-web", "libration-web-questions"])));
const [first, ...rest] = ["pendulum", "whole", "licences"].flatMap((id) => packed.get(id) ?? []);

const policy = [
  "default-src 'none'",
  `script-src ${hash(script)} ${hash(program)} 'wasm-unsafe-eval'`,
  `style-src ${hash(style)}`,
  "worker-src blob:",
  "img-src data: blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");
const needed = ["style", "font", "program"].map((id) => packed.get(id)).join("\n");
const parts = { policy, style, needed, script, first, rest: rest.join("\n") };
const page = readFileSync(here("src/page.html"), "utf8").replace(/\{\{(\w+)\}\}/g, (_, part) => parts[part]);
writeFileSync(output, page);

const bytes = (count) => count.toLocaleString("en").padStart(11);
console.log(`${"bytes of".padEnd(16)}        raw compressed    in page`);
for (const [name, ...counts] of sizes) console.log(name.padEnd(16) + counts.map(bytes).join(""));
console.log("the page".padEnd(38) + bytes(Buffer.byteLength(page)));
