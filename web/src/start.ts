// The first script of the page: decompresses the program, which is a third as large so, and runs it. The policy of the page names the hashes of both.

import { bytes } from "./engine/base91.ts";
import { decompressed } from "./engine/lzma.ts";

const packed = document.getElementById("program");
if (packed === null) throw new Error("the page was built without its program");
const program = document.createElement("script");
program.textContent = new TextDecoder().decode(decompressed(bytes(packed.textContent)));
packed.replaceWith(program);
