// The room that the address names, and navigation between rooms.

import { PageAddress } from "./address.ts";
import { WorkerEngine } from "./engine/worker_engine.ts";
import type { Room } from "./room.ts";
import { rooms } from "./rooms/all.ts";
import { text } from "./texts/en.ts";

const engine = new WorkerEngine();
const address = new PageAddress(show);
let leave = () => {};

function show(): void {
  const room = rooms.find(({ name }) => name === address.room) ?? rooms[0];
  if (room === undefined) return;
  leave();
  leave = () => {};
  document.documentElement.classList.toggle("embed", address.room === "embed");
  const focused = (document.activeElement as HTMLElement | null)?.dataset["state"];
  const place = document.createElement("main");
  place.id = "room";
  place.tabIndex = -1;
  document.getElementById("room")?.replaceWith(place);
  showLinks(room);
  document.title = `${text.titles[room.name]} – ${text.title}`;
  try {
    leave = room.open(place, address, engine, focused);
  } catch (error) {
    place.textContent = `${text.failed}: ${error instanceof Error ? error.message : error}`;
  }
}

function showLinks(current: Room): void {
  const links = rooms.map(({ name }) => {
    const link = document.createElement("a");
    link.href = `#${name}`;
    link.textContent = text.titles[name] ?? name;
    if (name === current.name) link.setAttribute("aria-current", "page");
    return link;
  });
  document.getElementById("rooms")?.replaceChildren(...links);
  links.find((link) => link.ariaCurrent !== null)?.scrollIntoView({ block: "nearest", inline: "center" });
}

show();
