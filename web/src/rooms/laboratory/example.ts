// A simulated swing as an example: computed by the command, rounded to tenths of a degree like the readings of an instrument.

import { type Engine, text as decoded } from "../../engine/engine.ts";
import { ask, given } from "../../parts/command.ts";

const QUESTION = {
  question: "simulate",
  arguments: ["damped_pendulum"],
  options: given({ set: "omega0=4.2,c1=0.03", initial: "theta=60deg", times: "0:20:0.04", csv: true, "no-errors": true }),
};

/** The file. */
export async function example(engine: Engine): Promise<{ name: string; bytes: Uint8Array }> {
  const [, ...rows] = decoded(await ask(engine, QUESTION)).trim().split("\n");
  const lines = rows.map((row) => {
    const [time = 0, angle = 0] = row.split(",").map(Number);
    return `${time},${((angle * 180) / Math.PI).toFixed(1)}`;
  });
  return { name: "swing.csv", bytes: new TextEncoder().encode(`t (s),theta (deg)\n${lines.join("\n")}\n`) };
}
