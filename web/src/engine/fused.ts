// The fused multiply-add. WebAssembly has one only as a relaxed instruction, which rounds once or twice depending on the processor, and not
// everywhere. It has a module of its own, is tested, and is passed to the large modules where it rounds once.

// (module (func (export "multiply_add") (param f64 f64 f64) (result f64)
//   (f64x2.extract_lane 0 (f64x2.relaxed_madd (f64x2.splat (local.get 0)) (f64x2.splat (local.get 1)) (f64x2.splat (local.get 2))))))
const RELAXED = [
  0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x01, 0x60, 0x03, 0x7c, 0x7c, 0x7c, 0x01, 0x7c, 0x03, 0x02, 0x01, 0x00,
  0x07, 0x10, 0x01, 0x0c, 0x6d, 0x75, 0x6c, 0x74, 0x69, 0x70, 0x6c, 0x79, 0x5f, 0x61, 0x64, 0x64, 0x00, 0x00, 0x0a, 0x16, 0x01, 0x14,
  0x00, 0x20, 0x00, 0xfd, 0x14, 0x20, 0x01, 0xfd, 0x14, 0x20, 0x02, 0xfd, 0x14, 0xfd, 0x87, 0x02, 0xfd, 0x21, 0x00, 0x0b,
];

type MultiplyAdd = (x: number, y: number, z: number) => number;

/** A module with the fused multiply-add of this browser, or with its own if the browser has none that rounds once. */
export function instantiated(module: WebAssembly.Module, imports: WebAssembly.Imports = {}): WebAssembly.Exports {
  const fused = relaxed();
  const multiply_add = fused ?? (() => NaN);
  const { exports } = new WebAssembly.Instance(module, { ...imports, fused: { multiply_add } });
  if (fused !== undefined) (exports["use_fused"] as () => void)();
  return exports;
}

/** `undefined` if there is none, or if it rounds twice. */
function relaxed(): MultiplyAdd | undefined {
  const bytes = new Uint8Array(RELAXED);
  if (!WebAssembly.validate(bytes)) return undefined;
  const multiplyAdd = new WebAssembly.Instance(new WebAssembly.Module(bytes)).exports["multiply_add"] as MultiplyAdd;
  // (1 + 2⁻³⁰)² = 1 + 2⁻²⁹ + 2⁻⁶⁰; with two roundings the last term is lost.
  const x = 1 + 2 ** -30;
  return multiplyAdd(x, x, -1 - 2 ** -29) === 2 ** -60 ? multiplyAdd : undefined;
}
