// Room 1: one pendulum, moved by the exact solution.

import type { Address } from "../../address.ts";
import type { Engine } from "../../engine/engine.ts";
import { Mathematics } from "../../engine/mathematics.ts";
import { element } from "../../parts/element.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import { Swing } from "./swing.ts";

export const pendulum: Room = {
  name: "pendulum",
  open(place, address, engine, focused) {
    let close: (() => void) | undefined;
    let isLeft = false;
    place.append(element("h1", { class: "unseen" }, text.titles["pendulum"] ?? ""));
    const waiting = element("p", { class: "quiet", role: "status" }, text.pendulum.loading);
    place.append(waiting);
    begun(place, address, engine)
      .then((swing) => {
        waiting.remove();
        close = () => swing.close();
        if (isLeft) close();
        else if (focused !== undefined) place.querySelector<HTMLElement>(`[data-state="${focused}"]`)?.focus();
      })
      .catch((error: unknown) => {
        waiting.textContent = `${text.failed}: ${error instanceof Error ? error.message : String(error)}`;
      });
    return () => {
      isLeft = true;
      close?.();
    };
  },
};

let mathematics: Promise<Mathematics> | undefined;

async function begun(place: HTMLElement, address: Address, engine: Engine): Promise<Swing> {
  return new Swing(place, address, engine, await (mathematics ??= Mathematics.load()));
}
