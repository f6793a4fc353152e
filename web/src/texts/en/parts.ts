// Texts shared by several rooms.

export const parts = {
  computing: "Computing …",
  stop: "Stop",
  stopped: "Stopped. Partial results are shown.",
  copy: "Copy",
  copied: "Copied",
  notCopied: "Could not copy",
  equivalents: "Equivalent command and Python code",
  asCommand: "Command",
  inPython: "Python",
  savePicture: (kind: string) => `Save the picture as ${kind}`,
  saveData: "Save the numbers as CSV",
  numbers: "Numbers as a table",
  rows: (shown: number, all: number) => (shown < all ? `The first ${shown} of ${all} rows` : `${all} rows`),
  seeField: "No result: see the message in the fields.",
  nothingToSave: "Nothing to save.",
  more: "more",
  emptyEntry: "an empty entry",
  /** Rooms that do what a query does. */
  queries: { period: "Formulas" } as Readonly<Record<string, string>>,
  alternatives: (values: readonly string[]) => [values.slice(0, -1).join(", "), ...values.slice(-1)].filter((it) => it !== "").join(" or "),
  /** Keys in sentences of the command, each with its words. */
  keys: [
    [/(?:the nearest are [^;]*; )?the keys are [^;]*; or /g, ""],
    [/; the keys of oscillators are [^;\n]*/g, ""],
    [/has the key /g, "has the name "],
    [/^no system has the name an empty entry; /g, ""],
    [/\bx_max\b/g, "largest displacement"],
    [/\bhalf_swing\b/g, "half the swing"],
    [/\bblack_vel_(\d)\b/g, "Fourier-perturbation ($1)"],
    [/\bpower_series_(\d)\b/g, "power series ($1)"],
    [/\bkidd_fogg\b/g, "Kidd-Fogg"],
    [/\bcarvalhaes_suppes\b/g, "Carvalhaes-Suppes"],
  ] as readonly (readonly [key: RegExp, words: string])[],
  terms: {
    equilibrium: "The place where the pendulum can stay at rest: hanging straight down, or, balanced, straight up.",
    "restoring force": "The part of gravity along the arc. It pulls the bob back towards the lowest point, and grows with the sine of the angle.",
    "small-angle approximation": "For small angles the sine is nearly the angle itself. The period is then the same for all amplitudes: T₀ = 2π√(l/g).",
    separatrix: "The curve between swinging and going over the top. On it the bob approaches the top and never reaches it.",
  } as Readonly<Record<string, string>>,
  unit: { label: "Angles in", degrees: "degrees", radians: "radians" },
} as const;
