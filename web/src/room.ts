import type { Address } from "./address.ts";
import type { Engine } from "./engine/engine.ts";

/** One part of the page, with its own state in the address. */
export interface Room {
  /** The name in the address, and the key of the title in the texts. */
  readonly name: string;
  /** Shows the room in an empty place; returns a function that closes it. `focused` names the button of the state that is to keep the focus. */
  open(place: HTMLElement, address: Address, engine: Engine, focused?: string): () => void;
}
