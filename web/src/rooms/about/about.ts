// The room About: accuracy, sources, licences and citation.

import { unpacked } from "../../engine/module.ts";
import { copyButton } from "../../parts/equivalents.ts";
import { element } from "../../parts/element.ts";
import { table } from "../../parts/table.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";

/** The version of the workspace, as determined by `web/build`. */
declare const VERSION: string;

const words = text.about;

export const about: Room = {
  name: "about",
  open(place) {
    const { accuracy, sources, licences, cite } = words;
    const [quantity = "", error = ""] = accuracy.columns;
    place.append(
      element("h1", {}, text.titles["about"] ?? ""),
      element("p", { class: "lead" }, words.lead),
      section(accuracy.title, accuracy.intro, table(accuracy.caption, [{ title: quantity }, { title: error }], accuracy.rows), accuracy.ulp, accuracy.others),
      section(sources.title, sources.intro, element("ul", { class: "lead" }, ...sources.entries.map(([name = "", link = ""]) => element("li", {}, `${name}. `, element("a", { href: link, rel: "noreferrer" }, link))))),
      section(licences.title, licences.own, licences.others, texts(licences.list)),
      section(cite.title, cite.intro, element("pre", { tabindex: "0", "aria-label": cite.label }, element("code", {}, bibtex())), copyButton(bibtex, cite.label)),
    );
    return () => {};
  },
};

function section(title: string, ...parts: (string | Node)[]): HTMLElement {
  const paragraphs = parts.map((part) => (typeof part === "string" ? element("p", { class: "lead" }, part) : part));
  return element("section", {}, element("h2", {}, title), ...paragraphs);
}

/** The works and the texts of their licences, which are long: decompressed on demand. */
function texts(title: string): HTMLElement {
  const place = element("pre", { class: "licences", tabindex: "0", "aria-label": title });
  const made = element("details", {}, element("summary", {}, title), place);
  made.addEventListener("toggle", () => void unpacked("licences").then((all) => (place.textContent = all)), { once: true });
  return made;
}

function bibtex(): string {
  return `@software{libration,
  author  = {{The authors of libration}},
  title   = {libration: the large-amplitude pendulum and other nonlinear oscillators, each answer with its error},
  version = {${VERSION}},
}`;
}
