// The motion as a picture and as numbers to save, both by the command, and the equivalent lines.

import type { Engine } from "../../engine/engine.ts";
import { ask, type Command, extended } from "../../parts/command.ts";
import { reason } from "../../parts/marks.ts";
import { plain } from "../../parts/plain.ts";
import { button, element } from "../../parts/element.ts";
import { Equivalents } from "../../parts/equivalents.ts";
import { Picture } from "../../parts/picture.ts";
import { saveAnswer } from "../../parts/save.ts";
import { text } from "../../texts/en.ts";

const words = text.pendulum.keep;

/** Number of samples in a table. */
const ROWS = 1000;

export class Keep {
  readonly element: HTMLElement;
  readonly #engine: Engine;
  readonly #picture: Picture;
  readonly #equivalents = new Equivalents();
  readonly #failure = element("p", { class: "error", role: "alert" });
  #command: Command | undefined;

  constructor(engine: Engine) {
    this.#engine = engine;
    this.#picture = new Picture(engine, "motion");
    this.element = element(
      "section",
      { class: "keep" },
      element("h2", {}, words.title),
      element("p", { class: "buttons screen-only" }, button(words.draw, () => void this.#draw()), button(words.csv, () => void this.#save())),
      this.#failure,
      this.#picture.element,
      this.#equivalents.element,
    );
  }

  /** Shows this motion, with approximate ones, for this number of seconds or by default for a time chosen by the command. */
  show(command: Command, compared: readonly string[], seconds: number | undefined): void {
    const times = seconds === undefined ? undefined : `0:${Number(seconds.toPrecision(6))}:${Number((seconds / ROWS).toPrecision(6))}`;
    this.#command = extended(command, { times, compare: compared.join(",") });
    this.#picture.clear();
    this.#failure.textContent = "";
    this.#equivalents.show([this.#command]);
  }

  async #draw(): Promise<void> {
    if (this.#command === undefined) return;
    const answer = await this.#picture.draw(this.#command, new AbortController().signal);
    this.#failure.textContent = plain(reason(answer.error));
  }

  async #save(): Promise<void> {
    if (this.#command === undefined) return;
    const answer = await ask(this.#engine, extended(this.#command, { csv: true }));
    this.#failure.textContent = saveAnswer("motion.csv", answer, "text/csv");
  }
}
