// Sentences that several rooms share.

export const parts = {
  computing: "Computing …",
  stop: "Stop",
  stopped: "Stopped. What is shown was computed until then.",
  copy: "Copy",
  copied: "Copied",
  notCopied: "Could not copy",
  equivalents: "The same as a command and in Python",
  asCommand: "As a command",
  inPython: "In Python",
  savePicture: (kind: string) => `Save the picture as ${kind}`,
  saveData: "Save the numbers as CSV",
  nothingToSave: "There is nothing to save.",
  unit: { label: "Angles in", degrees: "degrees", radians: "radians" },
} as const;
