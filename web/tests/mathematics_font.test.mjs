// The font of the page has every sign of the formulas that it shows.

import assert from "node:assert/strict";
import { test } from "node:test";
import { signs } from "../mathematics_font.mjs";
import { command } from "./harness.mjs";

const FORMULAS = [
  ...["elliptic", "formulas", "perturbation", "averaging", "limit-cycle"].map((road) => ["derive", "--method", road, "--format", "html"]),
  ["derive", "--method", "perturbation", "x'' + x + x^3/10 = 0", "--order", "7", "--format", "html"],
  ["derive", "--method", "elliptic", "--amplitude", "40deg", "--length", "1m", "--exercises", "--format", "html"],
];

for (const words of FORMULAS) {
  test(words.join(" "), () => {
    const { status, output, error } = command(...words);
    assert.equal(status, 0, error);
    const formulas = output.match(/<math.*?<\/math>/gs) ?? [];
    assert.ok(formulas.length > 10);
    // Function application is invisible.
    const text = formulas.join("").replace(/<[^>]*>|&\w+;|\u2061/g, "");
    const missing = new Set([...text].filter((sign) => !signs.includes(sign)));
    assert.deepEqual([...missing], []);
  });
}
