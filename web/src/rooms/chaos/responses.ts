// The periodic responses of a driven system over a parameter in words: the jumps of slow sweeps, and the results of the search for subharmonic responses.

import { digits } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import type { Asking } from "./asked.ts";

const words = text.chaos.responses;

/** The result of `libration response`. */
interface Response {
  readonly parameter: string;
  readonly jumps: readonly { readonly parameter: number; readonly sweep: string; readonly from: number; readonly to: readonly number[] }[];
  readonly orders: readonly { readonly order: string; readonly branches: number; readonly finding: string; readonly share: number | null }[];
}

export const responses: Asking<Response> = { title: words.title, name: "response", fields: ["response", "orders"], said };

function said({ parameter, jumps, orders }: Response): string[] {
  const jumped = jumps.map((jump) => words.jump(parameter, digits(jump.parameter), jump.sweep, digits(jump.from, 4), jump.to.map((to) => digits(to, 4)).join(", ")));
  const sought = orders.map(({ order, branches, finding, share }) => words.sought(order, finding === "found" ? words.found(branches) : (words.findings[finding] ?? finding), share === null ? "" : words.share(digits(100 * share, 3))));
  return [...(jumped.length > 0 ? jumped : [words.noJumps]), ...sought];
}
