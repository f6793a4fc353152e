import type { Address } from "./address.ts";
import type { Engine } from "./engine/engine.ts";

/** One part of the page, with its own state in the address. */
export interface Room {
  /** As in the address, and the key of its title in the texts. */
  readonly name: string;
  /** Shows the room in a place that is empty; the result is how it is left. */
  open(place: HTMLElement, address: Address, engine: Engine): () => void;
}
