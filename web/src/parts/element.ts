// Elements of the page, built without markup: text stays text.

type Attribute = string | boolean | undefined;

/** An element with attributes and children; attributes that are `false` or `undefined` are left out. */
export function element<K extends keyof HTMLElementTagNameMap>(
  name: K,
  attributes: Readonly<Record<string, Attribute>> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}

/** A button with its action. */
export function button(label: string, pressed: () => void, attributes: Readonly<Record<string, Attribute>> = {}): HTMLButtonElement {
  const made = element("button", { type: "button", ...attributes }, label);
  made.addEventListener("click", pressed);
  return made;
}

let made = 0;

/** An identifier that is unique on the page. */
export function identifier(): string {
  made += 1;
  return `part-${made}`;
}
