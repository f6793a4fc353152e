import { build } from "esbuild";
import { readFileSync } from "node:fs";
import vm from "node:vm";
const stdin = { contents: `import "./engine/worker.ts"`, resolveDir: new URL("../src", import.meta.url).pathname, loader: "ts" };
const { outputFiles } = await build({ stdin, bundle: true, format: "iife", write: false });
const Q = [
 ["stability","vertically_driven_pendulum","--set","c=0.1","--map","omega=1.5:2.5,a=0.02:0.4","--json"],
 ["response","driven_pendulum","--set","A=0.15,c=0.1","--over","Omega=0.3:1.4","--json"],
 ["simulate","double_pendulum","--initial","theta1=120deg,theta2=120deg","--times","0:20:0.1","--csv"],
 ["section","driven_pendulum","--set","A=1.5,c=1/2","--initial","theta=0.2","--points","100","--skip","1","--csv"],
 ["expand","pendulum","--order","15","--json"],
 ["derive","--method","elliptic"],
 ["formulas","--amplitude","90deg","--tolerance","1e-3"],
];
for (const f of process.argv.slice(2)) {
  const messages = [];
  const context = vm.createContext({ WebAssembly, TextEncoder, TextDecoder, performance, postMessage: (m) => messages.push(m) });
  vm.runInContext(outputFiles[0].text, context);
  await context.onmessage({ data: { kind: "module", module: new WebAssembly.Module(readFileSync(f)) } });
  console.log(f);
  for (const words of Q) {
    const r=[];
    for (let k=0;k<2;k++){ messages.length=0; const t=process.cpuUsage(); await context.onmessage({ data: { kind: "question", words, files: new Map() } }); const u=process.cpuUsage(t); r.push(((u.user+u.system)/1e6).toFixed(2)); }
    console.log(words.slice(0,2).join(" ").padEnd(45), r.join(" "), JSON.stringify(messages.at(-1))?.slice(0,80));
  }
}
