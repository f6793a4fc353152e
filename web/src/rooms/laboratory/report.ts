// The report of a fit within the page: the command's own, with its pictures, each of which can be saved.

import { button, element } from "../../parts/element.ts";
import { fromHtml, styleOf } from "../../parts/markup.ts";
import { plain } from "../../parts/plain.ts";
import { png } from "../../parts/png.ts";
import { save } from "../../parts/save.ts";
import { scrolling } from "../../parts/scrolling.ts";
import { type Kind, labelIn } from "./fields.ts";
import { text } from "../../texts/en.ts";

const sheet = new CSSStyleSheet();

/** The report, with its titles below those of the room. */
export function report(page: string, kind: Kind): HTMLElement {
  const pictures = page.match(/<svg[^]*?<\/svg>/g) ?? [];
  // The pictures have their own colours for dark pages, which apply within the report.
  sheet.replaceSync(`.report { ${styleOf(pictures[0] ?? "")} }`);
  if (!document.adoptedStyleSheets.includes(sheet)) document.adoptedStyleSheets.push(sheet);
  const shown = element("div", { class: "report" }, ...fromHtml(page));
  for (const [from, to] of [["h3", "h4"], ["h2", "h3"], ["h1", "h2"]] as const) {
    shown.querySelectorAll(from).forEach((title) => title.replaceWith(element(to, {}, ...title.childNodes)));
  }
  shown.querySelectorAll("th:empty").forEach((nothing) => nothing.replaceWith(element("td")));
  inPageWords(shown, kind);
  scrolling(...shown.querySelectorAll(".wide"));
  shown.querySelectorAll("figure").forEach((figure, place) => figure.append(saving(pictures[place] ?? "", place)));
  return shown;
}

// The report names options for its readers at the command line; here their fields have labels.
function inPageWords(shown: HTMLElement, kind: Kind): void {
  const texts = document.createTreeWalker(shown, NodeFilter.SHOW_TEXT);
  for (let node = texts.nextNode(); node !== null; node = texts.nextNode()) {
    node.nodeValue = plain(node.nodeValue ?? "", labelIn(kind));
  }
}

function saving(picture: string, place: number): HTMLElement {
  // A picture in a file of its own needs its namespace.
  const whole = picture.replace(/^<svg(?! xmlns)/, '<svg xmlns="http://www.w3.org/2000/svg"');
  const name = `fit-${place + 1}`;
  const svg = button(text.parts.savePicture("SVG"), () => save(`${name}.svg`, whole, "image/svg+xml"));
  const painted = button(text.parts.savePicture("PNG"), async () => save(`${name}.png`, await png(whole), "image/png"));
  return element("p", { class: "buttons screen-only" }, svg, painted);
}
