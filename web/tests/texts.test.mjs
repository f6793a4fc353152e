// Sentences that a reader sees stand in src/texts, so that a translation is one file for each room. The sources of three rooms are searched for others.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { transformSync } from "esbuild";

/** Literals, with the code before them, which tells their use. */
const LITERAL = /"((?:[^"\\]|\\.)*)"|`((?:[^`\\]|\\.)*)`/g;
/** Properties, attributes and arguments that readers see or hear: any word is for them. */
const SEEN = /(?:\b(?:label|title|hint|caption|placeholder|text|xLabel|yLabel)|"aria-label"):$|\.textContent=$|\bbutton\($|\belement\("\w+",\{[^{}]*\},$/;
/** Names: of classes, commands, elements and files. */
const NAMED = /\b(?:class|question):$|\b(?:querySelector|querySelectorAll|closest|matches)\($|\bnew Error\($|\bfrom$/;
const WORD = /[A-Za-z]{2}/;
const SENTENCE = /[A-Za-z]{2,},? [A-Za-z]{2,}/;

/** The literals of a source that are words for a reader. */
function sentences(source) {
  const { code } = transformSync(source, { loader: "ts", minifyWhitespace: true, charset: "utf8" });
  return [...code.matchAll(LITERAL)].flatMap(({ index, 1: quoted, 2: template }) => {
    const before = code.slice(0, index);
    const written = (quoted ?? template).replace(/\$\{[^}]*\}/g, "…");
    return !NAMED.test(before) && (SEEN.test(before) ? WORD : SENTENCE).test(written) ? [written] : [];
  });
}

test("the search finds sentences, labels and words of buttons, and no names", () => {
  const wrong = 'button("Save", f); element("p", { class: "a bc", "aria-label": "Name" }, "the result"); it.textContent = `up to ${n}`; const all = ["one of them"]; element("p", {}, f(`${n} of them all`));';
  assert.deepEqual(sentences(wrong), ["Save", "Name", "the result", "up to …", "one of them", "… of them all"]);
  const right = 'import { a } from "./some words.ts"; element("p", { class: "quiet under" }, words.title); ask({ question: "figure errors" }); it.querySelector("details a"); throw new Error("no such key");';
  assert.deepEqual(sentences(right), []);
});

for (const room of ["formulas", "derivations", "perturbation"]) {
  test(`all sentences of the room ${room} are among the texts`, () => {
    const folder = fileURLToPath(new URL(`../src/rooms/${room}/`, import.meta.url));
    const sources = readdirSync(folder).filter((name) => name.endsWith(".ts"));
    assert.ok(sources.length > 3);
    for (const name of sources) assert.deepEqual(sentences(readFileSync(folder + name, "utf8")), [], name);
  });
}
