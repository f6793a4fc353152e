// The report of a fit within the page: the command's own, with its pictures, each of which can be saved.

import { button, element } from "../../parts/element.ts";
import { fromHtml } from "../../parts/markup.ts";
import { save } from "../../parts/save.ts";
import { text } from "../../texts/en.ts";

const sheet = new CSSStyleSheet();

/** The report, whose titles stand below those of the room. */
export function report(page: string): HTMLElement {
  const read = new DOMParser().parseFromString(page, "text/html");
  const sources = [...read.querySelectorAll("svg")];
  // The pictures bring their colours for dark pages, which hold within the report.
  sheet.replaceSync(`.report { ${sources[0]?.querySelector("style")?.textContent ?? ""} }`);
  if (!document.adoptedStyleSheets.includes(sheet)) document.adoptedStyleSheets.push(sheet);
  const shown = element("div", { class: "report" }, ...fromHtml(read.body.innerHTML));
  for (const [from, to] of [["h3", "h4"], ["h2", "h3"], ["h1", "h2"]] as const) {
    shown.querySelectorAll(from).forEach((title) => title.replaceWith(element(to, {}, ...title.childNodes)));
  }
  shown.querySelectorAll(".wide").forEach((wide) => wide.setAttribute("tabindex", "0"));
  shown.querySelectorAll("figure").forEach((figure, place) => figure.append(saving(sources[place], place)));
  return shown;
}

function saving(picture: SVGSVGElement | undefined, place: number): HTMLElement {
  const pressed = () => {
    if (picture !== undefined) save(`fit-${place + 1}.svg`, new XMLSerializer().serializeToString(picture), "image/svg+xml");
  };
  return element("p", { class: "buttons screen-only" }, button(text.laboratory.saveSvg, pressed));
}
