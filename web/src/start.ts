// The first script of the page: decompresses the style sheet, the font and the program, which are a third as large so, and runs the program. The policy
// of the page names the hashes of both scripts.

import { provideUnpack } from "./engine/unpack.ts";

provideUnpack();

/** Takes a part out of the page. */
function taken(id: string): Uint8Array<ArrayBuffer> {
  const packed = document.getElementById(id);
  if (packed === null) throw new Error(`the page was built without its ${id}`);
  packed.remove();
  return unpack(packed.textContent);
}

const text = (id: string) => new TextDecoder().decode(taken(id));
const sheet = new CSSStyleSheet();
sheet.replaceSync(text("style"));
document.adoptedStyleSheets.push(sheet);
document.fonts.add(new FontFace("Mathematics", taken("font")));
const program = document.createElement("script");
program.textContent = text("program");
document.body.append(program);
