// The first script of the page: decompresses the program, which is a third as large so, and runs it. The policy of the page names the hashes of both.

import { provideUnpack } from "./engine/unpack.ts";

provideUnpack();
const packed = document.getElementById("program");
if (packed === null) throw new Error("the page was built without its program");
const program = document.createElement("script");
program.textContent = new TextDecoder().decode(unpack(packed.textContent));
packed.replaceWith(program);
