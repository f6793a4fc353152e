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
  nothingToSave: "Nothing to save.",
  unit: { label: "Angles in", degrees: "degrees", radians: "radians" },
} as const;
