// Every sentence of the interface. A room has its own section in a file of its own.

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
  skip: "To the room",
  rooms: "Rooms",
  failed: "This room cannot be shown",
  engine: {
    endedEarly: "ended early: what is shown was computed until then",
    fault: (reason: string) => `the computation broke down (${reason}) and was started afresh: ask for less, or in another way`,
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
