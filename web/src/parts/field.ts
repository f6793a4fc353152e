// One value that the reader gives: its label, where it is entered, what it may be, and what is wrong with it, beside it.

import { element, identifier } from "./element.ts";

/** A field of a form. */
export interface Field {
  /** In the address. */
  readonly key: string;
  /** As the command's errors name it, such as `--order` or `OSCILLATOR|EQUATION`. */
  readonly option: string | undefined;
  readonly element: HTMLElement;
  readonly initial: string;
  value: string;
  /** Says what is wrong with the value; nothing is wrong where the reason is empty. */
  refuse(reason: string): void;
  /** Calls when the reader has changed the value. */
  onChange(changed: () => void): void;
}

export interface FieldWords {
  readonly label: string;
  /** What may be given, with an example. */
  readonly hint?: string;
}

interface Description {
  readonly key: string;
  readonly option?: string;
  readonly words: FieldWords;
  readonly initial?: string;
}

type Control = HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement;

/** A line of text; `suggestions` are offered as it is typed. */
export function textField(description: Description, suggestions: readonly string[] = []): Field {
  const input = element("input", { type: "text", autocomplete: "off", spellcheck: "false", autocapitalize: "off" });
  const list = element("datalist", { id: identifier() }, ...suggestions.map((value) => element("option", { value })));
  if (suggestions.length > 0) input.setAttribute("list", list.id);
  return controlled(description, input, "input", suggestions.length > 0 ? [list] : []);
}

/** One of several values, each with a name. */
export function choiceField(description: Description, choices: readonly (readonly [value: string, name: string])[]): Field {
  const select = element("select", {}, ...choices.map(([value, name]) => element("option", { value }, name)));
  return controlled(description, select, "change");
}

/** Yes or no: `yes` in the address, or nothing. */
export function tickField(description: Description): Field {
  const input = element("input", { type: "checkbox" });
  const { words, key, initial = "" } = description;
  const error = element("p", { class: "error", id: identifier(), hidden: true });
  return {
    key,
    option: description.option,
    initial,
    element: element("div", { class: "field tick" }, element("label", {}, input, ` ${words.label}`), hint(words, identifier()), error),
    get value() {
      return input.checked ? "yes" : "";
    },
    set value(value) {
      input.checked = value !== "";
    },
    refuse: (reason) => say(error, input, reason),
    onChange: (changed) => input.addEventListener("change", changed),
  };
}

function controlled(description: Description, control: Control, event: string, beside: Node[] = []): Field {
  const { key, option, words, initial = "" } = description;
  control.id = identifier();
  control.name = key;
  control.value = initial;
  const described = identifier();
  const error = element("p", { class: "error", id: identifier(), hidden: true });
  control.setAttribute("aria-describedby", `${described} ${error.id}`);
  return {
    key,
    option,
    initial,
    element: element("div", { class: "field" }, element("label", { for: control.id }, words.label), control, ...beside, hint(words, described), error),
    get value() {
      return control.value.trim();
    },
    set value(value) {
      control.value = value;
    },
    refuse: (reason) => say(error, control, reason),
    onChange: (changed) => control.addEventListener(event, changed),
  };
}

function hint(words: FieldWords, id: string): HTMLElement {
  return element("p", { class: "hint", id, hidden: words.hint === undefined }, words.hint ?? "");
}

function say(error: HTMLElement, control: Control, reason: string): void {
  error.textContent = reason;
  error.hidden = reason === "";
  if (reason === "") control.removeAttribute("aria-invalid");
  else control.setAttribute("aria-invalid", "true");
}
