// The LaTeX of formulas for the period as MathML: letters, numbers, fractions, roots, powers, indices, brackets and named functions.

const MATH = "http://www.w3.org/1998/Math/MathML";

/** Letters and signs by their names. */
const NAMED: Readonly<Record<string, string>> = {
  theta: "θ", lambda: "λ", pi: "π", omega: "ω", Omega: "Ω", epsilon: "ε", varepsilon: "ε", mu: "μ", phi: "φ", psi: "ψ", tau: "τ", alpha: "α", beta: "β", gamma: "γ",
  delta: "δ", kappa: "κ", sigma: "σ", eta: "η", chi: "χ", nu: "ν", rho: "ρ", zeta: "ζ", xi: "ξ", varphi: "φ", varpi: "ϖ", Gamma: "Γ", Delta: "Δ",
};
/** Signs between letters. */
const SIGNS: Readonly<Record<string, string>> = { le: "≤", ge: "≥", cdot: "·", pm: "±", infty: "∞", prime: "′" };
/** Marks above a letter. */
const ABOVE: Readonly<Record<string, string>> = { dot: "˙", ddot: "¨" };
const FUNCTIONS = new Set(["sin", "cos", "tan", "sinh", "cosh", "tanh", "arcsin", "arctan", "ln", "log", "exp"]);
const SPACES: Readonly<Record<string, string>> = { quad: "1em", ",": "0.17em", " ": "0.3em", ";": "0.28em", "!": "0em" };

/** A formula to be shown; commands that are not supported stay as they are written. */
export function fromLatex(source: string, display = true): Element {
  const parts = new Reader(tokens(source)).row();
  const math = node("math", ...parts);
  if (display) math.setAttribute("display", "block");
  math.setAttribute("aria-label", source);
  return math;
}

function tokens(source: string): string[] {
  return source.match(/\\text\{[^{}]* [^{}]*\}|\\[a-zA-Z]+|\\.|\d+(?:\.\d+)?|\S/g) ?? [];
}

function node(name: string, ...children: (Element | string)[]): Element {
  const made = document.createElementNS(MATH, name);
  made.append(...children);
  return made;
}

class Reader {
  readonly #tokens: string[];
  #at = 0;

  constructor(tokens: string[]) {
    this.#tokens = tokens;
  }

  /** Everything up to a closing token. */
  row(closing?: string): Element[] {
    const parts: Element[] = [];
    while (this.#at < this.#tokens.length && this.#tokens[this.#at] !== closing) {
      const isFunction = FUNCTIONS.has(this.#tokens[this.#at]?.slice(1) ?? "");
      if (isFunction && /^(?:mi|mn|msup|msub|msubsup|mfrac|msqrt)$/.test(parts.at(-1)?.localName ?? "")) parts.push(space("0.17em"));
      parts.push(this.#scripted(closing));
      if (isFunction && !["(", "\\left", closing].includes(this.#tokens[this.#at])) parts.push(space("0.17em"));
    }
    this.#at += 1;
    return parts;
  }

  // A piece with its index and its power.
  #scripted(closing?: string): Element {
    const base = this.#piece();
    let [below, above]: (Element | undefined)[] = [];
    while (this.#at < this.#tokens.length && this.#tokens[this.#at] !== closing) {
      const sign = this.#tokens[this.#at];
      if (sign !== "_" && sign !== "^") break;
      this.#at += 1;
      if (sign === "_") below = this.#argument();
      else above = this.#argument();
    }
    if (below !== undefined && above !== undefined) return node("msubsup", base, below, above);
    if (below !== undefined) return node("msub", base, below);
    return above === undefined ? base : node("msup", base, above);
  }

  // An argument as in LaTeX: without braces one digit only, so that \tfrac12 is a half.
  #argument(): Element {
    const [digit = "", ...rest] = this.#tokens[this.#at] ?? "";
    if (/^\d/.test(digit) && rest.length > 0) this.#tokens.splice(this.#at, 1, digit, rest.join(""));
    return this.#piece();
  }

  #piece(): Element {
    const token = this.#tokens[this.#at] ?? "";
    this.#at += 1;
    if (token === "{") return node("mrow", ...this.row("}"));
    if (token.startsWith("\\text{")) return node("mtext", token.slice(6, -1).replaceAll(" ", "\u00a0"));
    if (token.startsWith("\\")) return this.#command(token.slice(1));
    if (/^\d/.test(token)) return node("mn", token);
    if (/^[a-zA-Z]$/.test(token)) return node("mi", token);
    return node("mo", token === "-" ? "−" : token);
  }

  #command(name: string): Element {
    if (name === "frac" || name === "tfrac" || name === "dfrac") return node("mfrac", this.#argument(), this.#argument());
    if (name === "sqrt") return node("msqrt", this.#argument());
    if (name === "left") return this.#bracketed();
    const mark = ABOVE[name];
    if (mark !== undefined) return accented(this.#argument(), mark);
    if (name === "mathrm" || name === "text") return this.#upright();
    if (name === "max" || name === "min") return node("mi", name);
    const sign = SIGNS[name];
    if (sign !== undefined) return node("mo", sign);
    const letter = NAMED[name];
    if (letter !== undefined) return node("mi", letter);
    if (FUNCTIONS.has(name)) return upright(name);
    const width = SPACES[name];
    return width === undefined ? node("mtext", name) : space(width);
  }

  // A name in upright letters, which the tokens give without its spaces.
  #upright(): Element {
    const made = node("mi", this.#argument().textContent ?? "");
    if ((made.textContent ?? "").length === 1) made.setAttribute("mathvariant", "normal");
    return made;
  }

  #bracketed(): Element {
    const bracket = () => this.#tokens[this.#at++] ?? "";
    const open = bracket();
    const inside = this.row("\\right");
    return node("mrow", node("mo", open), ...inside, node("mo", bracket()));
  }
}

function accented(letter: Element, mark: string): Element {
  const made = node("mover", letter, node("mo", mark));
  made.setAttribute("accent", "true");
  return made;
}

function space(width: string): Element {
  const made = node("mspace");
  made.setAttribute("width", width);
  return made;
}

function upright(name: string): Element {
  const made = node("mi", name);
  made.setAttribute("mathvariant", "normal");
  return node("mrow", made, node("mo", "\u2061"));
}
