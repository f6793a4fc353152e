// The parts of the room that need searches: how far the formulas hold, and where one overtakes another.

import type { Address } from "../../address.ts";
import type { Engine } from "../../engine/engine.ts";
import { read } from "../../parts/answers.ts";
import { type Command, given } from "../../parts/command.ts";
import { element } from "../../parts/element.ts";
import type { Form } from "../../parts/form.ts";
import { angle } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import type { Catalogue, Crossovers, Formula, Periods } from "./catalogue.ts";
import { OnDemand } from "./on_demand.ts";
import { crossovers, limit, ranges } from "./results.ts";

const words = text.formulas;

export class Searches {
  readonly elements: readonly HTMLElement[];
  readonly #engine: Engine;
  readonly #form: Form;
  readonly #ranges: OnDemand;
  readonly #crossovers: OnDemand;

  /** `opened` is called when the reader opens a part. */
  constructor(address: Address, engine: Engine, form: Form, opened: () => void) {
    [this.#engine, this.#form] = [engine, form];
    this.#ranges = new OnDemand(address, "ranges", words.ranges, opened);
    this.#crossovers = new OnDemand(address, "crossovers", words.crossovers, opened);
    this.elements = [this.#ranges.element, this.#crossovers.element];
  }

  /** The queries for the simplest formula that suffices, and for the crossovers. */
  commands(keys: readonly string[]): Command[] {
    return [this.#sufficing(), this.#crossing(keys)];
  }

  /** The query for the amplitudes up to which formulas are within the tolerance. */
  holding(keys: readonly string[]): Command {
    return { question: "formulas", options: given({ tolerance: this.#form.value("tolerance"), formulas: keys.join(",") }) };
  }

  /** Shows, if it is open, which formula suffices at the amplitude of these values, and how far each holds. */
  async range(keys: readonly string[], values: Periods["results"][number] | undefined, signal: AbortSignal): Promise<void> {
    const [amplitude, tolerance, unit] = ["amplitude", "tolerance", "unit"].map((key) => this.#form.value(key)) as [string, string, string];
    await this.#ranges.show(JSON.stringify([keys, amplitude, tolerance, unit]), async () => {
      const held = await read<Catalogue>(this.#engine, this.holding(keys), signal);
      const enough = await read<Catalogue>(this.#engine, this.#sufficing(), signal);
      if (signal.aborted || held.value === undefined || enough.value === undefined || values === undefined) return undefined;
      const [simplest] = enough.value.formulas;
      const at = angle(values.amplitude_rad, unit);
      const verdict = simplest === undefined ? words.noneSuffices(tolerance, at) : words.suffices(simplest.name, tolerance, at, limit(simplest, unit));
      return [element("p", {}, verdict), ranges(held.value.formulas, tolerance, unit)];
    });
  }

  /** Shows the crossovers of the formulas, if they are open. */
  async cross(keys: readonly string[], catalogue: ReadonlyMap<string, Formula>, signal: AbortSignal): Promise<void> {
    const unit = this.#form.value("unit");
    await this.#crossovers.show(JSON.stringify([keys, unit]), async () => {
      if (keys.length < 2) return [element("p", {}, words.onlyOne)];
      const { value } = await read<Crossovers>(this.#engine, this.#crossing(keys), signal);
      return signal.aborted || value === undefined ? undefined : [crossovers(value, catalogue, unit)];
    });
  }

  #sufficing(): Command {
    return { question: "formulas", options: given({ amplitude: this.#form.value("amplitude"), tolerance: this.#form.value("tolerance") }) };
  }

  #crossing(keys: readonly string[]): Command {
    return { question: "formulas", options: given({ crossovers: true, formulas: keys.join(",") }) };
  }
}
