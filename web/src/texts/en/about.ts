// The room About: accuracy, sources, licences and citation.

export const about = {
  lead: "This page is a single file. It works without a network and loads nothing; all inputs and files stay on your machine.",
  accuracy: {
    title: "Accuracy",
    intro: "The page runs the same computations as the command libration and returns the same results, bit for bit. The same accuracy holds:",
    caption: "Largest errors, compared with tables of 40 digits, over millions of random inputs",
    columns: ["quantity", "largest error"],
    rows: [
      ["T / T₀, up to 1e-300 rad from the top", "0.56 ulp"],
      ["T / T₀ − 1", "0.9 ulp"],
      ["harmonics, energy", "0.56 ulp"],
      ["angle and velocity at a time, within a million periods", "2.2 ulp, and 2⁻⁵¹·|θ′t| or 2⁻⁵¹·|θ″t|"],
    ],
    ulp: "An ulp is the distance between two neighbouring floating-point numbers, about 1e-16 of the number. Angles are parsed exactly: pi-1e-300 keeps its distance from the top.",
    others: "Perturbation series have exact rational coefficients, verified by a second method. Motions are integrated by Taylor series with a default tolerance of 1e-12 per step. Fits state the uncertainties of their parameters. Every result states what is not known.",
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
    own: "libration and this page may be used under the MIT licence or the Apache Licence 2.0, at your choice.",
    others: "The page contains parts of other works: Rust’s standard library, dashu, libm, clap, nalgebra, csv, rawzip, quick-xml and serde_json among them, and glyphs of STIX Two Math.",
    list: "All of them, and the texts of their licences",
  },
  cite: {
    title: "How to cite",
    intro: "If you use the page or its results in your work, cite the software with its version. CITATION.cff in the source code contains the same entry.",
    label: "For BibTeX",
  },
} as const;
