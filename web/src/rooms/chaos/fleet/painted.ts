// Several canvases side by side as one picture.

import { colours } from "../../../parts/colours.ts";

/** The gap between them, in pixels. */
const GAP = 16;

/** The bytes of a PNG file. */
export async function painted(canvases: readonly HTMLCanvasElement[]): Promise<Uint8Array> {
  const whole = document.createElement("canvas");
  whole.width = canvases.reduce((width, canvas) => width + canvas.width + GAP, GAP);
  whole.height = Math.max(...canvases.map((canvas) => canvas.height)) + 2 * GAP;
  const context = whole.getContext("2d");
  if (context !== null) {
    context.fillStyle = colours().ground;
    context.fillRect(0, 0, whole.width, whole.height);
    let left = GAP;
    for (const canvas of canvases) {
      context.drawImage(canvas, left, GAP);
      left += canvas.width + GAP;
    }
  }
  const blob = await new Promise<Blob | null>((resolve) => whole.toBlob(resolve, "image/png"));
  return new Uint8Array((await blob?.arrayBuffer()) ?? []);
}
