import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";

export const pendulum: Room = {
  name: "pendulum",
  open(place) {
    const title = document.createElement("h1");
    title.textContent = text.titles["pendulum"] ?? "";
    place.append(title);
    return () => {};
  },
};
