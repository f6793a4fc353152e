// The works contained in the page, with their licences: names, versions, owners, and each text of a licence once.

import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";

const here = (path) => new URL(path, import.meta.url).pathname;
/** Licences in order of preference, for works that may be used under several. */
const PREFERRED = ["MIT", "Zlib", "BSD-3-Clause", "BSD-2-Clause", "ISC", "Unicode-3.0", "0BSD", "CC0-1.0", "BSL-1.0", "MPL-2.0", "Apache-2.0"];
const FILE = /^(licen[cs]e|copying|notice|unlicense|copyright)/i;

/** The text of the works, then of the licences, for a page built from these crates. */
export function licences(crates) {
  const texts = new Map();
  const works = packages(crates).map(({ name, version, license, manifest_path, authors }) => {
    const chosen = licencesOf(license ?? "");
    const files = readdirSync(dirname(manifest_path)).filter((file) => FILE.test(file)).map((file) => readFileSync(join(dirname(manifest_path), file), "utf8"));
    for (const licence of chosen) {
      const own = files.find((text) => isTextOf(licence, text));
      if (own !== undefined && !texts.has(licence)) texts.set(licence, withoutOwners(own));
    }
    const found = [...new Set(files.flatMap(ownersIn))];
    const owners = found.length > 0 ? found : authors.map((author) => author.replace(/ <.*/, ""));
    return { chosen, line: `${name} ${version} (${chosen.join(" and ")})${owners.length > 0 ? `: ${owners.join("; ")}` : ""}` };
  });
  const missing = works.filter(({ chosen }) => chosen.some((licence) => !texts.has(licence)));
  if (missing.length > 0) throw new Error(`no text of the licence of ${missing.map(({ line }) => line).join(", ")}`);
  const lines = works.map(({ line }) => line);
  lines.unshift("Rust’s standard library (MIT): Copyright (c) The Rust Project Contributors");
  lines.push(`STIX Two Math (OFL-1.1): ${stixOwners()}`);
  texts.set("OFL-1.1", withoutOwners(readFileSync(here("node_modules/@fontsource/stix-two-math/LICENSE"), "utf8")));
  const chapters = [...texts].sort(([a], [b]) => a.localeCompare(b)).map(([name, text]) => `${name}\n\n${text}`);
  return [lines.join("\n"), ...chapters].join("\n\n\n");
}

/** The external crates compiled into these crates; macros leave no code of their own. */
function packages(crates) {
  const cargo = (...words) => execFileSync("cargo", [...words, "--locked", "--manifest-path", here("../Cargo.toml")], { maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"], encoding: "utf8" });
  const asked = crates.flatMap((name) => ["--package", name]);
  const tree = cargo("tree", ...asked, "--edges", "normal,no-proc-macro", "--target", "wasm32-unknown-unknown", "--prefix", "none", "--format", "{p}");
  const compiled = new Set(tree.split("\n").map((line) => line.split(" ").slice(0, 2).join(" ").replace(" v", " ")));
  const known = JSON.parse(cargo("metadata", "--format-version", "1", "--filter-platform", "wasm32-unknown-unknown")).packages;
  return known.filter(({ name, version, source }) => source !== null && compiled.has(`${name} ${version}`)).sort((a, b) => a.name.localeCompare(b.name));
}

/** The licences under which the work is taken: one of each choice. */
function licencesOf(expression) {
  return expression.split(/\s+AND\s+/).map((choice) => {
    const named = choice.split(/\s+OR\s+|\//).map((name) => name.replaceAll(/[()]/g, "").trim());
    return PREFERRED.find((name) => named.includes(name)) ?? named[0];
  });
}

function isTextOf(licence, text) {
  const signs = {
    MIT: /Permission is hereby granted, free of charge, to any\s+person/,
    "Apache-2.0": /Apache License\s+Version 2\.0/,
    Zlib: /This software is provided 'as-is'/,
    "BSD-3-Clause": /Neither the name/,
    "BSD-2-Clause": /Redistributions of source code/,
    "0BSD": /Permission to use, copy, modify, and\/or distribute/,
    "Unicode-3.0": /UNICODE LICENSE V3/i,
    "BSL-1.0": /Boost Software License/,
  };
  return signs[licence]?.test(text) === true && (licence !== "MIT" || text.length < 3000);
}

const OWNER = /^[\s#/*]*((?:Portions? )?Copyright(?! \[| notice| and | owner| holder| law| license| statement|s? in).*?)\s*$/gim;

function ownersIn(text) {
  return [...text.matchAll(OWNER)].map(([, owner]) => owner.replace(/\s+/g, " ").replace(/\.? All rights reserved\.?| or$/i, "").trim()).filter((owner) => /\d{4}|©|\(c\)|Copyright [A-Z]/i.test(owner) && owner.length < 160 && !/[{[]/.test(owner));
}

/** The text without its owners, who are named with the works. */
function withoutOwners(text) {
  return text.replaceAll(OWNER, "").replaceAll(/\r/g, "").replaceAll(/\n{3,}/g, "\n\n").trim();
}

function stixOwners() {
  return ownersIn(readFileSync(here("node_modules/@fontsource/stix-two-math/LICENSE"), "utf8")).join("; ");
}
