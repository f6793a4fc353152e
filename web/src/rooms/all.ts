import type { Room } from "../room.ts";
import { about } from "./about/about.ts";
import { chaos } from "./chaos/chaos.ts";
import { derivations } from "./derivations/derivations.ts";
import { formulas } from "./formulas/formulas.ts";
import { laboratory } from "./laboratory/laboratory.ts";
import { perturbation } from "./perturbation/perturbation.ts";
import { pendulum } from "./pendulum/pendulum.ts";

/** All rooms, in the order in which they are offered; the first is shown if the address names none. */
export const rooms: readonly Room[] = [pendulum, formulas, perturbation, derivations, laboratory, chaos, about];
