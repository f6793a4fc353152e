import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";

export const about: Room = {
  name: "about",
  open(place) {
    const title = document.createElement("h1");
    title.textContent = text.titles["about"] ?? "";
    place.append(title);
    return () => {};
  },
};
