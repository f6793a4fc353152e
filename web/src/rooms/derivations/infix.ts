// Formulas as they are typed, such as T0*(1 + theta0^2/16), as LaTeX.

const GREEK = /^(alpha|beta|gamma|delta|epsilon|theta|kappa|lambda|mu|pi|rho|sigma|tau|phi|psi|omega|Delta|Omega)$/;
const FUNCTION = /^(sin|cos|tan|ln|exp)$/;
const TOKEN = /\s*(\d+(?:\.\d+)?|[A-Za-z]\w*'*|<=|>=|<|>|\.\.\.|[-+*/^()=|,])/y;

/** A differential, such as dtheta. */
const DIFFERENTIAL = /^d(theta|psi|v|t|x)$/;

/** The formula as LaTeX; `undefined` if it is not a formula of these signs. */
export function latexOf(formula: string): string | undefined {
  try {
    return new Reader(tokens(formula)).all();
  } catch {
    return undefined;
  }
}

function tokens(formula: string): string[] {
  const found: string[] = [];
  TOKEN.lastIndex = 0;
  for (let at = 0; at < formula.length; at = TOKEN.lastIndex) {
    const token = TOKEN.exec(formula)?.[1];
    if (token === undefined) throw new Error("no such sign");
    found.push(token);
  }
  return found;
}

class Reader {
  readonly #tokens: readonly string[];
  #at = 0;

  constructor(tokens: readonly string[]) {
    this.#tokens = tokens;
  }

  all(): string {
    const parts = [this.#sum()];
    for (let sign = this.#next(); sign !== undefined; sign = this.#next()) {
      const relation = { "=": "=", "<=": "\\le", ">=": "\\ge", "<": "<", ">": ">", ",": ",\\quad " }[sign];
      if (relation === undefined) throw new Error("unexpected sign");
      parts.push(relation, this.#sum());
    }
    return parts.join(" ");
  }

  #next(...wanted: string[]): string | undefined {
    const token = this.#tokens[this.#at];
    if (token === undefined || (wanted.length > 0 && !wanted.includes(token))) return undefined;
    this.#at += 1;
    return token;
  }

  #sum(): string {
    let sum = (this.#next("-", "+") ?? "") + this.#product();
    for (let sign = this.#next("+", "-"); sign !== undefined; sign = this.#next("+", "-")) sum += ` ${sign} ${this.#product()}`;
    return sum;
  }

  // A fraction ends with its denominator: a/b*c/d is a fraction times another.
  #product(): string {
    let [fractions, product] = ["", this.#power()];
    for (let sign = this.#next("*", "/"); sign !== undefined; sign = this.#next("*", "/")) {
      const factor = this.#power();
      if (sign === "/") [fractions, product] = [product === "" ? `\\frac{${fractions}}{${bare(factor)}}` : `${fractions}\\frac{${bare(product)}}{${bare(factor)}} `, ""];
      else product += `${/\d$/.test(product) && /^\d/.test(factor) ? " \\cdot" : ""} ${factor}`;
    }
    return (fractions + product.trim()).trim();
  }

  #power(): string {
    const name = this.#tokens[this.#at] ?? "";
    if (FUNCTION.test(name)) {
      this.#at += 1;
      const argument = this.#bracketed();
      return `\\${name}${this.#exponent()}${argument}`;
    }
    const base = this.#base();
    return base + this.#exponent();
  }

  #exponent(): string {
    return this.#next("^") === undefined ? "" : `^{${bare((this.#next("-") ?? "") + this.#base())}}`;
  }

  #base(): string {
    const token = this.#next() ?? "";
    if (token === "(") {
      this.#at -= 1;
      return this.#bracketed();
    }
    if (token === "|") return `\\left|${this.#until("|")}\\right|`;
    if (token === "...") return "...";
    if (/^\d/.test(token)) return token;
    const [, name, index, primes] = /^([A-Za-z]+?)(\d*)('*)$/.exec(token) ?? [];
    if (name === undefined) throw new Error("not a value");
    if (name === "sqrt") return `\\sqrt{${bare(this.#bracketed())}}`;
    const variable = DIFFERENTIAL.exec(name)?.[1];
    if (variable !== undefined) return `d${GREEK.test(variable) ? "\\" : " "}${variable}`;
    const letter = GREEK.test(name) ? `\\${name}` : name.length > 1 ? `\\mathrm{${name}}` : name;
    const call = this.#tokens[this.#at] === "(" ? this.#bracketed() : "";
    const indexed = `${letter}${index === "" ? "" : `_{${index}}`}`;
    // In braces, so that a power is that of the derivative.
    return `${primes === "" ? indexed : `{${indexed}^{${"\\prime".repeat(primes?.length ?? 0)}}}`}${call}`;
  }

  #bracketed(): string {
    if (this.#next("(") === undefined) throw new Error("no bracket");
    return `\\left(${this.#until(")")}\\right)`;
  }

  #until(closing: string): string {
    const inside = this.#sum();
    if (this.#next(closing) === undefined) throw new Error("not closed");
    return inside;
  }
}

// A fraction, a root or an exponent needs no brackets around the whole.
function bare(part: string): string {
  if (!part.startsWith("\\left(") || !part.endsWith("\\right)")) return part;
  const inside = part.slice(6, -7);
  let depth = 0;
  for (const [sign] of inside.matchAll(/\\left|\\right/g)) {
    depth += sign === "\\left" ? 1 : -1;
    if (depth < 0) return part;
  }
  return inside;
}
