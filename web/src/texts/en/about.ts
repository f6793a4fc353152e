// What the page is, how good its numbers are, and whom it owes them.

export const about = {
  lead: "This page is one file. It works without a network, asks for nothing, and what you enter or drop stays on your machine.",
  accuracy: {
    title: "How good the numbers are",
    intro: "The page asks the same questions as the command libration, and gets the same answers, bit for bit. What is promised there holds here:",
    caption: "Largest errors, held against tables of 40 digits and millions of drawn inputs",
    columns: ["quantity", "largest error"],
    rows: [
      ["T / T₀, up to 1e-300 rad from the top", "0.56 ulp"],
      ["T / T₀ − 1", "0.9 ulp"],
      ["harmonics, energy", "0.56 ulp"],
      ["angle and velocity at a time, within a million periods", "2.2 ulp, and 2⁻⁵¹·|θ′t| or 2⁻⁵¹·|θ″t|"],
    ],
    ulp: "An ulp is the distance between two neighbouring floating-point numbers, about 1e-16 of the number. An angle is read as it is written: pi-1e-300 keeps its distance to the top.",
    others: "Perturbation series are exact fractions, checked along a second road. Integrated motions go by Taylor series to a tolerance of 1e-12 a step unless another is asked for. Fits state the uncertainty of what they find. Every answer says what it does not know.",
  },
  sources: {
    title: "Sources",
    intro: "Formulas for the period come with author, year and source in the room Formulas. The mathematics behind all of them:",
    entries: [
      ["NIST Digital Library of Mathematical Functions, chapters 19, 20 and 22: elliptic integrals, theta functions, Jacobi’s functions", "https://dlmf.nist.gov"],
      ["B. Black and V. Vel, American Journal of Physics 91, 776 (2023): Fourier perturbation of the pendulum", "https://doi.org/10.1119/5.0130943"],
      ["À. Jorba and M. Zou, Experimental Mathematics 14, 99 (2005): integration by Taylor series", "https://doi.org/10.1080/10586458.2005.10128904"],
    ],
  },
  licences: {
    title: "Licences",
    own: "libration and this page may be used under the MIT licence or the Apache Licence 2.0, as you like.",
    others: "The page contains parts of other works: Rust’s standard library, dashu, libm, clap, nalgebra, csv, rawzip, quick-xml and serde_json among them, and letters of STIX Two Math.",
    list: "All of them, and the texts of their licences",
  },
  cite: {
    title: "How to cite",
    intro: "If the page or its numbers helped you, cite the software with its version. CITATION.cff in the sources holds the same.",
    label: "For BibTeX",
  },
} as const;
