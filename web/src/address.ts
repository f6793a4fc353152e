// The state of a room in the address, `#room?key=value&…`, so that a link or a bookmark restores it.

import { AddressHistory } from "./address_history.ts";

/** The content of the address: the room, and its values as they are written. Values that are absent have the room's defaults. */
export interface Address {
  readonly room: string;
  get(key: string): string | undefined;
  /** Puts values into the address and removes those that are `undefined`; the room stays open. */
  put(values: Readonly<Record<string, string | undefined>>): void;
  /** Former states of the room. */
  readonly history: AddressHistory;
  /** Opens the room in the state before, or after, the present one. */
  undo(): void;
  redo(): void;
  /** Opens the room with its defaults. */
  reset(): void;
  /** The fragment of the present state in a room. */
  fragment(room: string): string;
}

/** Values that pass by themselves: they are no step of the history. */
const PASSING = ["t", "speed"];

/** The room and the values of a fragment, with or without its `#`. */
export function parsed(fragment: string): { room: string; values: Map<string, string> } {
  const [room = "", query = ""] = split(fragment.replace(/^#/, ""));
  return { room: decoded(room), values: new Map(new URLSearchParams(query)) };
}

/** The fragment of a room with values, `#` included. */
export function written(room: string, values: Iterable<readonly [string, string]>): string {
  const pairs = Array.from(values, ([key, value]) => `${encoded(key)}=${encoded(value)}`);
  return `#${encoded(room)}${pairs.length > 0 ? "?" : ""}${pairs.join("&")}`;
}

function split(text: string): [string, string] {
  const at = text.indexOf("?");
  return at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at + 1)];
}

// Characters that are allowed in a fragment stay readable; + would be read as a space.
function encoded(text: string): string {
  return encodeURIComponent(text).replace(/%(2C|3A|2F|40|5E)/g, (code) => decodeURIComponent(code));
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** The address of the page. Changes by hand, by links and by the browser's buttons are passed to `changed`. */
export class PageAddress implements Address {
  #room = "";
  #values = new Map<string, string>();
  #shown = "";
  readonly history = new AddressHistory();
  readonly #changed: () => void;

  constructor(changed: () => void) {
    this.#changed = changed;
    this.#read();
    addEventListener("focusin", () => this.history.endStep());
    addEventListener("hashchange", () => {
      if (location.hash !== this.#shown) {
        const { room } = this;
        this.#read();
        if (this.#room !== room) this.history.clear();
        changed();
      }
    });
  }

  get room(): string {
    return this.#room;
  }

  get(key: string): string | undefined {
    return this.#values.get(key);
  }

  put(values: Readonly<Record<string, string | undefined>>): void {
    const before = this.#state;
    for (const [key, value] of Object.entries(values)) {
      if (value === undefined) this.#values.delete(key);
      else this.#values.set(key, value);
    }
    this.#write();
    if (this.#state !== before) this.history.remember(before);
  }

  undo(): void {
    this.#open(this.history.undo(this.#state));
  }

  redo(): void {
    this.#open(this.history.redo(this.#state));
  }

  reset(): void {
    const before = this.#state;
    if (before === written(this.#room, [])) return;
    this.history.remember(before);
    this.#open(written(this.#room, []));
  }

  fragment(room: string): string {
    return written(room, this.#values);
  }

  /** The state without what passes by itself. */
  get #state(): string {
    return written(this.#room, [...this.#values].filter(([key]) => !PASSING.includes(key)));
  }

  /** Opens the room in a former state; a motion that stands begins there and stands. */
  #open(state: string | undefined): void {
    if (state === undefined) return;
    const stands = this.#values.has("t");
    this.#values = parsed(state).values;
    if (stands) this.#values.set("t", "0");
    this.#write();
    this.#changed();
  }

  #write(): void {
    history.replaceState(null, "", written(this.#room, this.#values));
    this.#shown = location.hash;
  }

  #read(): void {
    ({ room: this.#room, values: this.#values } = parsed(location.hash));
    this.#shown = location.hash;
  }
}
