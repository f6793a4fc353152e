// A picture as PNG: the browser renders the SVG, as on a light page.

/** Pixels per unit of the picture; 96 units are an inch, so this is 288 pixels per inch. */
const SCALE = 3;

/** The bytes of the PNG file. */
export async function png(svg: string): Promise<Uint8Array> {
  const light = svg.replaceAll(/<style[^>]*>[^]*?<\/style>/g, "");
  const [width = 0, height = 0] = /viewBox="0 0 ([\d.]+) ([\d.]+)"/.exec(light)?.slice(1).map(Number) ?? [];
  const place = URL.createObjectURL(new Blob([sized(light, width, height)], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = place;
    await image.decode();
    return await painted(image, width, height);
  } finally {
    URL.revokeObjectURL(place);
  }
}

// Sets the size, which a picture within a page may lack.
function sized(svg: string, width: number, height: number): string {
  return svg.replace(/^[^]*?<svg(?![^>]* width=)/, `<svg width="${width}" height="${height}"`);
}

async function painted(image: HTMLImageElement, width: number, height: number): Promise<Uint8Array> {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [Math.round(width * SCALE), Math.round(height * SCALE)];
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
  if (blob === null) throw new Error("the browser could not paint the picture");
  return new Uint8Array(await blob.arrayBuffer());
}
