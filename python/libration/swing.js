// Draws what `swing.py` has calculated: a pendulum in time, its angle over a period, and sliders for the start.

const WIDTH = 660;
const HEIGHT = 260;
const PIVOT = { x: 125, y: 130 };
const ROD = 100;
const BOB = 13;
const PLOT = { left: 320, right: 645, top: 26, bottom: 228 };

function drawing(tag, attributes, parent, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
}

function control(tag, properties, parent) {
  const element = Object.assign(document.createElement(tag), properties);
  parent.append(element);
  return element;
}

/** The angle at a time, by a cubic through angles and velocities, in radians. */
export function angleAt(course, time) {
  const { span, angles, velocities, repeats, advance } = course;
  const periods = repeats ? Math.floor(time / span) : 0;
  const steps = angles.length - 1;
  const place = Math.min(Math.max((time - periods * span) / span, 0), 1) * steps;
  const at = Math.min(Math.floor(place), steps - 1);
  const part = place - at;
  const h = span / steps;
  const rest = 1 - part;
  const from = angles[at] * (1 + 2 * part) * rest * rest + h * velocities[at] * part * rest * rest;
  const to = angles[at + 1] * (3 - 2 * part) * part * part - h * velocities[at + 1] * rest * part * part;
  return from + to + periods * advance;
}

/** What the formula of small swings says of the same start. */
export function smallAngleAt(course, time) {
  const omega = (2 * Math.PI) / course.small_angle_period;
  return course.angles[0] * Math.cos(omega * time) + (course.velocities[0] / omega) * Math.sin(omega * time);
}

/** How much faster than in reality it is shown, a round number. */
export function rateOf(course) {
  const period = course.repeats ? course.span : course.small_angle_period;
  if (period >= 0.5 && period <= 10) return 1;
  const exact = period / 3;
  const power = 10 ** Math.floor(Math.log10(exact));
  return [1, 2, 5].reverse().find((digit) => digit * power <= exact * (1 + 1e-12)) * power;
}

function told(rate) {
  const times = (factor) => `${Number(factor.toPrecision(1)).toLocaleString("en")} times`;
  if (rate === 1) return "";
  return rate < 1 ? `; slowed down ${times(1 / rate)}` : `; sped up ${times(rate)}`;
}

/** A pendulum of a class of the style sheet, whose `to` turns it to an angle. */
function arm(parent, name) {
  const group = drawing("g", { class: name }, parent);
  drawing("line", { x1: 0, y1: 0, x2: 0, y2: ROD }, group);
  const bob = drawing("circle", { cx: 0, cy: ROD, r: BOB }, group);
  const to = (angle) =>
    group.setAttribute("transform", `translate(${PIVOT.x} ${PIVOT.y}) rotate(${((-180 / Math.PI) * angle).toFixed(3)})`);
  return { bob, to };
}

/** The angle against the time, and the dot that moves along it. */
function plot(parent) {
  const frame = { x: PLOT.left, y: PLOT.top, width: PLOT.right - PLOT.left, height: PLOT.bottom - PLOT.top };
  drawing("rect", { class: "frame", ...frame }, parent);
  // All pendulums of a page share the frame, and may share its name.
  const name = "libration-swing-frame";
  drawing("rect", frame, drawing("clipPath", { id: name }, parent));
  const small = drawing("path", { class: "small", "clip-path": `url(#${name})` }, parent);
  const exact = drawing("path", { class: "exact" }, parent);
  drawing("text", { class: "legend", x: PLOT.left, y: PLOT.top - 7 }, parent, "exact");
  drawing("text", { x: PLOT.left + 50, y: PLOT.top - 7 }, parent, "small swings, dashed");
  const dot = drawing("circle", { class: "dot", r: 5 }, parent);
  const labels = drawing("g", { class: "labels" }, parent);
  let [window, lowest, highest] = [1, -1, 1];
  const x = (time) => PLOT.left + ((PLOT.right - PLOT.left) * time) / window;
  const y = (angle) => PLOT.bottom - ((PLOT.bottom - PLOT.top) * (angle - lowest)) / (highest - lowest);

  function line(course, law) {
    const POINTS = 400;
    const points = Array.from({ length: POINTS + 1 }, (_, n) => (n * window) / POINTS);
    return points.map((time, n) => `${n ? "L" : "M"}${x(time).toFixed(1)} ${y(law(course, time)).toFixed(1)}`).join("");
  }

  function show(course) {
    window = course.repeats ? 2 * course.span : course.span;
    const ends = [angleAt(course, 0), angleAt(course, window), ...course.angles];
    [lowest, highest] = [Math.min(...ends), Math.max(...ends)];
    const margin = 0.06 * Math.max(highest - lowest, 1e-9);
    [lowest, highest] = [lowest - margin, highest + margin];
    small.setAttribute("d", line(course, smallAngleAt));
    exact.setAttribute("d", line(course, angleAt));
    labels.replaceChildren();
    const text = (at, words, anchor) => drawing("text", { ...at, "text-anchor": anchor }, labels, words);
    const degrees = (angle) => `${Number(((180 / Math.PI) * angle).toPrecision(3))}°`.replace("-", "−");
    text({ x: PLOT.left - 6, y: y(highest - margin) + 4 }, degrees(highest - margin), "end");
    text({ x: PLOT.left - 6, y: y(lowest + margin) + 4 }, degrees(lowest + margin), "end");
    text({ x: PLOT.left, y: PLOT.bottom + 18 }, "0", "start");
    text({ x: PLOT.right, y: PLOT.bottom + 18 }, `${Number(window.toPrecision(3))} s`, "end");
  }

  function move(course, time) {
    const shown = course.repeats ? time % window : Math.min(time, window);
    dot.setAttribute("cx", x(shown).toFixed(2));
    dot.setAttribute("cy", y(angleAt(course, shown)).toFixed(2));
  }
  return { show, move };
}

/** A slider with its value beside it, bound to a trait. */
function slider(model, parent, trait, { label, unit, least, most, step, digits }) {
  const row = control("label", {}, parent);
  control("span", { textContent: label }, row);
  const input = control("input", { type: "range", min: least, max: most, step }, row);
  const value = control("output", {}, row);
  input.addEventListener("input", () => {
    model.set(trait, Number(input.value));
    model.save_changes();
  });
  const show = () => {
    input.value = String(model.get(trait));
    value.textContent = `${model.get(trait).toFixed(digits)} ${unit}`;
  };
  model.on(`change:${trait}`, show);
  show();
  return () => model.off(`change:${trait}`, show);
}

function render({ model, el }) {
  el.classList.add("libration-swing");
  const picture = drawing("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" }, el);
  const title = drawing("title", {}, picture);
  const small = arm(picture, "small");
  const exact = arm(picture, "exact");
  drawing("circle", { class: "pivot", cx: PIVOT.x, cy: PIVOT.y, r: 3 }, picture);
  const curve = plot(picture);
  const caption = control("p", { className: "caption" }, el);
  const controls = control("div", { className: "controls" }, el);
  const button = control("button", { type: "button" }, controls);
  const again = control("button", { type: "button", textContent: "From the start" }, controls);

  let course = model.get("_course");
  let rate = 1;
  let time = 0;
  let last;
  let frame = 0;
  let runs = !matchMedia("(prefers-reduced-motion: reduce)").matches;

  const draw = () => {
    exact.to(angleAt(course, time));
    small.to(smallAngleAt(course, time));
    curve.move(course, time);
  };
  const tick = (now) => {
    /** Longer pauses, of a page that was out of sight, are not made up for, in milliseconds. */
    const LONGEST = 250;
    time += (rate * Math.min(now - (last ?? now), LONGEST)) / 1000;
    last = now;
    draw();
    frame = requestAnimationFrame(tick);
  };
  const run = (wanted) => {
    runs = wanted;
    button.textContent = runs ? "Pause" : "Run";
    cancelAnimationFrame(frame);
    last = undefined;
    if (runs) frame = requestAnimationFrame(tick);
  };
  const begin = () => {
    course = model.get("_course");
    rate = rateOf(course);
    time = 0;
    title.textContent = model.get("caption");
    caption.textContent = model.get("caption") + told(rate);
    curve.show(course);
    draw();
  };
  button.addEventListener("click", () => run(!runs));
  again.addEventListener("click", () => {
    time = 0;
    draw();
  });

  const start = (event) => {
    const { left, top, width } = picture.getBoundingClientRect();
    const scale = WIDTH / width;
    const across = (event.clientX - left) * scale - PIVOT.x;
    const down = (event.clientY - top) * scale - PIVOT.y;
    model.set("angle", Math.round((180 / Math.PI) * Math.atan2(across, down)));
    model.set("velocity", 0);
    model.save_changes();
  };
  let resumes = false;
  exact.bob.addEventListener("pointerdown", (event) => {
    exact.bob.setPointerCapture(event.pointerId);
    resumes = runs;
    run(false);
  });
  exact.bob.addEventListener("pointermove", (event) => exact.bob.hasPointerCapture(event.pointerId) && start(event));
  exact.bob.addEventListener("pointerup", () => run(resumes));
  exact.bob.addEventListener("pointercancel", () => run(resumes));

  const fastest = Math.ceil((6 * Math.PI) / course.small_angle_period);
  const loosen = [
    slider(model, controls, "angle", { label: "angle", unit: "°", least: -180, most: 180, step: 1, digits: 1 }),
    slider(model, controls, "velocity", { label: "velocity", unit: "rad/s", least: -fastest, most: fastest, step: fastest / 200, digits: 2 }),
  ];
  model.on("change:_course", begin);
  begin();
  run(runs);
  return () => {
    cancelAnimationFrame(frame);
    model.off("change:_course", begin);
    loosen.forEach((loose) => loose());
  };
}

export default { render };
