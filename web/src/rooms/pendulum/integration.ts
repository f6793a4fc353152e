// Damped and driven motions, which have no formula: integrated by the command, further ahead as time advances.

import { type Engine, text as decoded } from "../../engine/engine.ts";
import { ask, type Command, extended } from "../../parts/command.ts";
import { explained } from "../../parts/marks.ts";
import { IntegratedCourse } from "./course.ts";

/** Time between two samples, in seconds. */
const STEP = 0.01;

/** The settings of the room, as entered. */
export interface Forces {
  readonly angle: string;
  readonly velocity: number;
  readonly angularFrequency: number;
  readonly damping: string;
  /** Coefficients of quadratic drag and of dry friction. */
  readonly drag: string;
  readonly dry: string;
  readonly drive: string;
  readonly driveFrequency: string;
}

/** The field of each parameter of the equation. */
export const FORCE_OF: Readonly<Record<string, "damping" | "drag" | "dry" | "drive" | "driveFrequency">> = { c: "damping", q: "drag", f: "dry", A: "drive", omega: "driveFrequency" };

/** The equation with quadratic drag and dry friction; without them the system has a name. */
const EQUATION = "theta'' = -c*theta' - q*abs(theta')*theta' - f*sign(theta') - omega0^2*sin(theta) + A*cos(omega*t)";

export function isNone(entry: string): boolean {
  return entry === "" || Number(entry) === 0;
}

export function command({ angle, velocity, angularFrequency, damping, drag, dry, drive, driveFrequency }: Forces, until: number): Command {
  const isNamed = isNone(drag) && isNone(dry);
  const friction = isNamed ? [] : [`q=${drag || "0"}`, `f=${dry || "0"}`];
  const set = [`omega0=${angularFrequency}`, `c=${damping || "0"}`, ...friction, `A=${drive || "0"}`, `omega=${driveFrequency || "2/3"}`];
  return {
    question: "simulate",
    arguments: [isNamed ? "driven_pendulum" : EQUATION],
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
  if (answer.status !== 0) return { error: explained(answer.error), item: answer.error.item };
  const rows = decoded(answer).trim().split("\n").slice(1);
  const [angles, velocities] = [new Float64Array(rows.length), new Float64Array(rows.length)];
  rows.forEach((row, n) => {
    const [, angle = NaN, velocity = NaN] = row.split(",", 3).map(Number);
    [angles[n], velocities[n]] = [angle, velocity];
  });
  return new IntegratedCourse(STEP, { angles, velocities });
}
