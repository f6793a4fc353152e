// Pictures drawn by the command: shown, described in words, and saved.

import { type Answer, type Engine, NO_ERROR, text as decoded } from "../engine/engine.ts";
import { text } from "../texts/en.ts";
import { parsed, type Read } from "./answers.ts";
import { ask, type Command, extended } from "./command.ts";
import { button, element } from "./element.ts";
import { isWanted } from "./latest.ts";
import { fromSvg } from "./markup.ts";
import { png } from "./png.ts";
import { save } from "./save.ts";

/** The width in CSS pixels below which the picture has the size of a column, with relatively larger text. */
const COLUMN = 480;

type Files = ReadonlyMap<string, Uint8Array>;

/** The axes of a panel, in the units of the picture. */
export interface Frame {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** A place for a picture. */
export class Picture {
  readonly element: HTMLElement;
  /** The picture shown, for drawing into it. */
  svg: SVGSVGElement | undefined;
  readonly #engine: Engine;
  readonly #name: string;
  readonly #option: "figure" | "output";
  readonly #place = element("div", { class: "picture" });
  readonly #caption = element("figcaption", { class: "unseen" });
  readonly #buttons: HTMLElement;
  #drawn: Uint8Array | undefined;

  /** `name` is that of the saved files, `option` names the file in the query. */
  constructor(engine: Engine, name: string, option: "figure" | "output" = "figure") {
    [this.#engine, this.#name, this.#option] = [engine, name, option];
    this.#place.attachShadow({ mode: "open" });
    this.#buttons = element("p", { class: "buttons screen-only", hidden: true }, this.#button("SVG", () => this.#saveSvg()), " ", this.#button("PNG", () => void this.#savePng()));
    this.element = element("figure", {}, this.#place, this.#caption, this.#buttons);
  }

  /** The query that draws the picture as it is shown here. */
  command(command: Command): Command {
    const size = this.#place.clientWidth > 0 && this.#place.clientWidth < COLUMN ? "column" : undefined;
    return extended(command, { size, [this.#option]: `${this.#name}.svg` });
  }

  /** Queries the picture and shows it; the previous picture stays if there is none. */
  async draw(command: Command, signal: AbortSignal, files: Files = new Map()): Promise<Answer> {
    const answer = await this.#fitted(command, signal, (asked) => ask(this.#engine, named(asked, this.#option, "-"), { signal, files }));
    if (answer.output.length > 0 && isWanted(signal)) this.#show(answer.output);
    return answer;
  }

  /** Queries the result and its picture together, so that long computations run once, and shows the picture. */
  async beside(command: Command, signal: AbortSignal, files: Files = new Map()): Promise<Answer> {
    const answer = await this.#fitted(command, signal, (asked) => ask(this.#engine, asked, { signal, files }));
    const drawn = answer.files.get(`${this.#name}.svg`);
    if (drawn !== undefined && isWanted(signal)) this.#show(drawn);
    return answer;
  }

  /** The same with the result as JSON. */
  async read<T>(command: Command, signal: AbortSignal, files: Files = new Map()): Promise<Read<T>> {
    const answer = await this.beside(extended(command, { json: true }), signal, files);
    return { answer, value: parsed<T>(decoded(answer)) };
  }

  /** The axes of a panel, by default the first. */
  frame(panel = 0): Frame | undefined {
    const path = this.svg?.querySelectorAll("path.frame")[panel]?.getAttribute("d");
    const numbers = path?.match(/-?[\d.]+/g)?.map(Number) ?? [];
    const [xs, ys] = [0, 1].map((parity) => numbers.filter((_, place) => place % 2 === parity)) as [number[], number[]];
    if (xs.length === 0 || ys.length === 0) return undefined;
    return { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
  }

  /** The values at both ends of the horizontal axis, from two of its ticks, to a thousandth of its length, because positions are rounded. */
  axis(): { from: number; to: number } | undefined {
    const frame = this.frame();
    const ticks = [...(this.svg?.querySelectorAll("text.x-tick") ?? [])].map((tick) => [Number(tick.getAttribute("x")), Number(tick.textContent?.replace("−", "-"))] as const);
    const [[x1, value1] = [0, 0], [x2, value2] = [0, 0]] = [ticks[0], ticks.at(-1)];
    if (frame === undefined || x1 === x2 || !Number.isFinite(value1 + value2)) return undefined;
    const valueAt = (x: number) => value1 + ((x - x1) / (x2 - x1)) * (value2 - value1);
    const [from, to] = [valueAt(frame.left), valueAt(frame.right)];
    const decimals = Math.min(100, Math.max(0, Math.ceil(3 - Math.log10(Math.abs(to - from)))));
    return { from: Number(from.toFixed(decimals)), to: Number(to.toFixed(decimals)) };
  }

  /** The position of the pointer, in the units of the picture. */
  at(event: MouseEvent): { x: number; y: number } | undefined {
    const matrix = this.svg?.getScreenCTM();
    return matrix == null ? undefined : new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  }

  /** Lines over the picture: each a path of this class, in the units of the picture. */
  overlay(paths: readonly (readonly [name: string, path: string])[]): void {
    this.svg?.querySelectorAll(".overlay").forEach((old) => old.remove());
    for (const [name, path] of paths) {
      const made = document.createElementNS("http://www.w3.org/2000/svg", "path");
      made.setAttribute("class", `overlay ${name}`);
      made.setAttribute("d", path);
      this.svg?.append(made);
    }
  }

  /** Removes the picture. */
  clear(): void {
    this.#place.shadowRoot?.replaceChildren();
    this.#caption.textContent = "";
    this.#buttons.hidden = true;
    this.svg = undefined;
  }

  // Some pictures do not fit into the column.
  async #fitted(command: Command, signal: AbortSignal, of: (asked: Command) => Promise<Answer>): Promise<Answer> {
    const answer = await of(this.command(command));
    const { parameters, suggestion: least } = answer.error;
    if (!parameters.includes("--width") || least === "" || signal.aborted) return answer;
    return of(extended(command, { width: least, [this.#option]: `${this.#name}.svg` }));
  }

  #show(bytes: Uint8Array): void {
    const read = fromSvg(decoded({ status: 0, output: bytes, error: NO_ERROR, files: new Map() }));
    const root = this.#place.shadowRoot;
    if (read === undefined || root === null) return;
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(`${read.style}\n${LOOKS}`);
    root.adoptedStyleSheets = [sheet];
    root.replaceChildren(read.svg);
    [this.svg, this.#drawn] = [read.svg, bytes];
    this.#caption.textContent = ["title", "desc"].map((name) => read.svg.querySelector(name)?.textContent ?? "").join(". ");
    this.#buttons.hidden = false;
  }

  #button(kind: string, pressed: () => void): HTMLButtonElement {
    return button(text.parts.savePicture(kind), pressed);
  }

  #saveSvg(): void {
    if (this.#drawn !== undefined) save(`${this.#name}.svg`, this.#drawn, "image/svg+xml");
  }

  async #savePng(): Promise<void> {
    if (this.#drawn !== undefined) save(`${this.#name}.png`, await png(new TextDecoder().decode(this.#drawn)), "image/png");
  }
}

const LOOKS = `
svg { display: block; width: 100%; height: auto; }
.overlay { fill: none; stroke: CanvasText; stroke-width: 1.5; }
.overlay.limit { stroke-dasharray: 6 4; opacity: .7; }
`;

/** The same query, with another file. */
function named(command: Command, option: string, file: string): Command {
  return { ...command, options: (command.options ?? []).map(([name, value]) => (name === option ? [name, file] : [name, value])) };
}
