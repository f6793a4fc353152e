// All texts of the interface, with one file for each room.

import { chaos } from "./en/chaos.ts";
import { about } from "./en/about.ts";
import { derivations } from "./en/derivations.ts";
import { formulas } from "./en/formulas.ts";
import { laboratory } from "./en/laboratory.ts";
import { parts } from "./en/parts.ts";
import { pendulum } from "./en/pendulum.ts";
import { perturbation } from "./en/perturbation.ts";

export const text = {
  title: "Pendulum",
  skip: "Skip to the content",
  rooms: "Rooms",
  failed: "This room cannot be shown",
  engine: {
    endedEarly: "ended early: partial results are shown",
    fault: (reason: string) => `the computation failed (${reason}) and was restarted: try a smaller problem or other settings`,
  },
  titles: {
    pendulum: "The pendulum",
    formulas: "Formulas",
    perturbation: "Perturbation",
    derivations: "Derivations",
    laboratory: "Laboratory",
    chaos: "Order and chaos",
    about: "About",
  } as Readonly<Record<string, string>>,
  about,
  pendulum,
  formulas,
  perturbation,
  derivations,
  laboratory,
  chaos,
  parts,
} as const;
