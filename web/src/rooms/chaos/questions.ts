// The queries of the room, made from its fields.

import { type Command, extended, given, type Option } from "../../parts/command.ts";
import type { Form } from "../../parts/form.ts";

export class Questions {
  readonly #form: Form;

  constructor(form: Form) {
    this.#form = form;
  }

  starts(): string[] {
    return this.#form.value("initial").split(";").map((it) => it.trim()).filter((it) => it !== "");
  }

  diagram(over = this.#form.value("over")): Command {
    const value = (key: string) => this.#form.value(key);
    return extended(this.#system("bifurcation", this.#first(), [value("set")]), { over, points: value("each"), sweep: value("sweep"), at: value("at") });
  }

  section(points = this.#form.value("points")): Command {
    return extended(this.chosen("section", this.starts()), { at: this.#form.value("at"), points });
  }

  neighbours(): Command {
    return extended(this.chosen("figure trajectories", this.starts()), { to: this.#form.value("until") });
  }

  /** The first of the neighbouring motions at equally spaced times. */
  followed(): Command {
    const until = this.#form.value("until");
    return extended(this.chosen("simulate", this.#first()), { times: `0:${until}:${Number(until) / 50}`, csv: true });
  }

  lyapunov(): Command {
    return extended(this.chosen("lyapunov", this.#first()), { intervals: this.#form.value("intervals") });
  }

  orbit(): Command {
    return this.chosen("orbit", this.#first());
  }

  response(): Command | undefined {
    const over = this.#form.value("response");
    return over === "" ? undefined : extended(this.#over(over, "response", this.#first()), { over, orders: this.#form.value("orders") });
  }

  /** Stability over two parameters, with its own state at rest. */
  map(): Command | undefined {
    const [map, rest] = [this.#form.value("map"), this.#form.value("rest")];
    return map === "" ? undefined : extended(this.#over(map, "stability", rest === "" ? [] : [rest]), { map, lines: this.#form.value("lines") });
  }

  thresholds(): Command | undefined {
    const over = this.#form.value("thresholds");
    return over === "" ? undefined : extended(this.#over(over, "melnikov", []), { over, "max-drive-periods": this.#form.value("periods") });
  }

  exchange(): Command | undefined {
    const order = this.#form.value("order");
    return order === "" ? undefined : extended(this.chosen("resonance", this.#first()), { order, about: this.#form.value("about") });
  }

  /** The query at the chosen value of the parameter. */
  chosen(question: string, starts: readonly string[]): Command {
    return this.#system(question, starts, [this.#form.value("set"), this.#value()]);
  }

  /** The query at the values of all parameters but those of these ranges, as `omega=1:3,a=0:0.5`. */
  #over(ranges: string, question: string, starts: readonly string[]): Command {
    const named = ranges.split(",").map(nameOf);
    const set = [...this.#form.value("set").split(","), this.#value()];
    return this.#system(question, starts, set.filter((it) => !named.includes(nameOf(it))));
  }

  #value(): string {
    const [name, value] = [nameOf(this.#form.value("over")), this.#form.value("value")];
    return name === "" || value === "" ? "" : `${name}=${value}`;
  }

  #system(question: string, starts: readonly string[], set: readonly string[]): Command {
    const initial = starts.map((start): Option => ["initial", start]);
    return { question, arguments: [this.#form.value("system")], options: [...given({ set: set.filter((it) => it !== "").join(",") }), ...initial] };
  }

  #first(): string[] {
    return this.starts().slice(0, 1);
  }
}

/** The name in `NAME=…`. */
export function nameOf(given: string): string {
  return given.split("=")[0]?.trim() ?? "";
}
