// Damped and driven motions, which have no formula: integrated by the command, further ahead as time advances.

import { type Engine, text as decoded } from "../../engine/engine.ts";
import { ask, type Command, extended, reason } from "../../parts/command.ts";
import { IntegratedCourse } from "./course.ts";

/** Time between two samples, in seconds. */
const STEP = 0.01;

/** The settings of the room, as entered. */
export interface Forces {
  readonly angle: string;
  readonly velocity: number;
  readonly angularFrequency: number;
  readonly damping: string;
  readonly drive: string;
  readonly driveFrequency: string;
}

/** The field of each parameter of the equation. */
export const FORCE_OF: Readonly<Record<string, "damping" | "drive" | "driveFrequency">> = { c: "damping", A: "drive", omega: "driveFrequency" };

export function command({ angle, velocity, angularFrequency, damping, drive, driveFrequency }: Forces, until: number): Command {
  const set = [`omega0=${angularFrequency}`, `c=${damping || "0"}`, `A=${drive || "0"}`, `omega=${driveFrequency || "2/3"}`];
  return {
    question: "simulate",
    arguments: ["driven_pendulum"],
    options: [
      ["set", set.join(",")],
      ["initial", `theta=${angle},theta'=${velocity}`],
      ["times", `0:${until}:${STEP}`],
    ],
  };
}

/** The motion until a time in seconds, or the reason why there is none. */
export async function integrated(engine: Engine, forces: Forces, until: number, signal: AbortSignal): Promise<IntegratedCourse | { readonly error: string; readonly item: string }> {
  const answer = await ask(engine, extended(command(forces, until), { csv: true, "no-errors": true }), { signal });
  if (answer.status !== 0) return { error: reason(answer), item: answer.error.item };
  const rows = decoded(answer).trim().split("\n").slice(1);
  const [angles, velocities] = [new Float64Array(rows.length), new Float64Array(rows.length)];
  rows.forEach((row, n) => {
    const [, angle = NaN, velocity = NaN] = row.split(",", 3).map(Number);
    [angles[n], velocities[n]] = [angle, velocity];
  });
  return new IntegratedCourse(STEP, { angles, velocities });
}
