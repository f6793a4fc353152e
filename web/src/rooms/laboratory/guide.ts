// The way to g, or to another missing result: asks for the one number that the fit lacks.

import { button, element, identifier } from "../../parts/element.ts";
import { plain } from "../../parts/plain.ts";
import { text } from "../../texts/en.ts";
import type { Fitted } from "./headline.ts";
import { type Key, type Kind, labelIn } from "./fields.ts";
import type { Settings } from "./settings.ts";

const words = text.laboratory.guide;
type Step = keyof typeof words.steps;

/** The number that is missing, if the fit has less than it could. */
export function missing(kind: Kind, it: Fitted, value: (key: Key) => string): Step | undefined {
  if (kind === "gates" && it.t0_s == null && value("amplitude") === "" && value("diameter") === "") return "amplitude";
  if ((kind === "trace" || kind === "gates" || kind === "periods") && it.gravity_m_per_s2 == null && value("length") === "") return "length";
  return kind === "amplitudes" && it.quality == null && value("period") === "" ? "period" : undefined;
}

/** A question with a field and a button; the answer goes to the field of the same name. */
export function step(key: Step, kind: Kind, refusal: string, { value, put }: Settings): HTMLElement {
  const { why, label, hint, press } = words.steps[key];
  const [id, described] = [identifier(), identifier()];
  const input = element("input", { type: "text", id, autocomplete: "off", "aria-describedby": described });
  input.value = value(key);
  const form = element(
    "form",
    { class: "guide", "aria-label": why },
    element("p", {}, why),
    element("label", { for: id }, label),
    element("div", { class: "buttons" }, input, button(press, () => form.requestSubmit(), { class: "main" })),
    element("p", { class: "hint", id: described }, hint),
    ...(refusal === "" ? [] : [element("p", { class: "error", role: "alert" }, plain(refusal, labelIn(kind)))]),
  );
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    if (input.value.trim() !== "") put({ [key]: input.value.trim() });
  });
  return form;
}
