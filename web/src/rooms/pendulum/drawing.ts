// The picture of the bench: degree marks, pendulums to scale, their traces and arrows.

import type { Colour, Colours } from "../../parts/colours.ts";

/** A pendulum as it is drawn. */
export interface Drawn {
  readonly angle: number;
  /** Angular velocity, in rad/s. */
  readonly velocity: number;
  /** Length, in metres. */
  readonly length: number;
  readonly colour: Colour;
  /** Radius of the bob relative to the usual one. */
  readonly bob: number;
  /** The largest speed that is drawn as a full arrow, in rad/s. */
  readonly fastest: number;
  /** Earlier angles, the newest last. */
  readonly trace: ArrayLike<number>;
}

export interface Shown {
  readonly pendulums: readonly Drawn[];
  readonly ghosts: readonly { readonly angle: number; readonly colour: Colour }[];
  readonly arrows: boolean;
  /** A photogate at the lowest point, and `true` if its beam is interrupted; `undefined` for none. */
  readonly gate: boolean | undefined;
  /** The angle of the first pendulum, read to half a degree. */
  readonly protractor: boolean;
  /** `deg` or `rad`, for the degree marks. */
  readonly unit: string;
}

/** The pivot, and the circle of the degree marks, in px; `metres` is the radius of the circle to scale. */
export interface Frame {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly metres: number;
}

/** The smallest of 1, 2, 5, 10 … that is not below the length. */
function roundAbove(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  return [1, 2, 5, 10].map((factor) => factor * power).find((it) => it >= length * (1 - 1e-9)) ?? 10 * power;
}

/** The space for the names of marks next to the circle, in px. */
const BESIDE = 48;

export function framed(width: number, height: number, pendulums: readonly Drawn[]): Frame {
  const margin = 12 + 0.055 * Math.min(width, height);
  const longest = Math.max(...pendulums.map(({ length }) => length).filter((it) => it > 0 && Number.isFinite(it)), 1e-12);
  return { x: width / 2, y: height / 2, radius: Math.max(20, Math.min(0.5 * height - margin, 0.5 * width - Math.max(margin, BESIDE))), metres: roundAbove(longest) };
}

export function draw(context: CanvasRenderingContext2D, width: number, height: number, shown: Shown, all: Colours, letters: string): void {
  context.clearRect(0, 0, width, height);
  const frame = framed(width, height, shown.pendulums);
  drawMarks(context, frame, shown, all, letters);
  const [first] = shown.pendulums;
  for (const ghost of shown.ghosts) drawGhost(context, frame, ghost.angle, lengthIn(frame, first?.length ?? frame.metres), all[ghost.colour]);
  for (const pendulum of shown.pendulums) drawTrace(context, frame, pendulum, all[pendulum.colour]);
  if (first !== undefined && shown.protractor) drawProtractor(context, frame, first.angle, shown.unit, all, letters);
  for (const pendulum of [...shown.pendulums].reverse()) drawPendulum(context, frame, pendulum, all);
  if (shown.arrows) for (const pendulum of shown.pendulums) drawArrows(context, frame, pendulum, all, letters);
  if (first !== undefined && shown.gate !== undefined) drawGate(context, frame, first, shown.gate, all);
  context.fillStyle = all.ink;
  context.fillRect(frame.x - 22, frame.y - 9, 44, 5);
  disc(context, frame.x, frame.y, 4, all.ink);
}

/** The length of a rod, in px. */
export function lengthIn({ radius, metres }: Frame, length: number): number {
  return (radius * Math.min(length, metres)) / metres;
}

/** The place of a bob, in px. */
export function bobOf(frame: Frame, { angle, length }: Drawn): [x: number, y: number] {
  const size = lengthIn(frame, length);
  return [frame.x + size * Math.sin(angle), frame.y + size * Math.cos(angle)];
}

function drawMarks(context: CanvasRenderingContext2D, { x, y, radius }: Frame, { unit, gate }: Shown, all: Colours, letters: string): void {
  context.strokeStyle = all.line;
  context.lineWidth = 1;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.stroke();
  context.beginPath();
  context.setLineDash([2, 5]);
  context.moveTo(x, y);
  context.lineTo(x, y + radius);
  context.stroke();
  context.setLineDash([]);
  context.font = letters;
  context.textBaseline = "middle";
  for (let degrees = -175; degrees <= 180; degrees += 5) {
    const [sin, cos] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
    const isNamed = degrees % 30 === 0;
    const inner = radius - (isNamed ? 11 : degrees % 10 === 0 ? 7 : 4);
    context.strokeStyle = isNamed ? all.quiet : all.line;
    context.beginPath();
    context.moveTo(x + inner * sin, y + inner * cos);
    context.lineTo(x + radius * sin, y + radius * cos);
    context.stroke();
    context.fillStyle = all.quiet;
    // The photogate stands where the lowest mark has its name.
    if (isNamed && (degrees !== 0 || gate === undefined)) {
      context.textAlign = Math.abs(sin) < 0.1 ? "center" : sin > 0 ? "left" : "right";
      context.fillText(markName(degrees, unit), x + (radius + 6) * sin, y + (radius + 4 + 0.8 * parseFloat(letters)) * cos);
    }
  }
  context.textAlign = "center";
}

const FRACTIONS: Readonly<Record<number, string>> = { 0: "0", 30: "π/6", 60: "π/3", 90: "π/2", 120: "2π/3", 150: "5π/6", 180: "π" };

function markName(degrees: number, unit: string): string {
  const size = Math.abs(degrees);
  const name = unit === "rad" ? (FRACTIONS[size] ?? "") : `${size}°`;
  return degrees < 0 ? `−${name}` : name;
}

function drawGhost(context: CanvasRenderingContext2D, { x, y }: Frame, angle: number, size: number, colour: string): void {
  const [bobX, bobY] = [x + size * Math.sin(angle), y + size * Math.cos(angle)];
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  stroke(context, x, y, bobX, bobY);
  context.beginPath();
  context.arc(bobX, bobY, 11, 0, 2 * Math.PI);
  context.lineWidth = 2;
  context.stroke();
}

function drawTrace(context: CanvasRenderingContext2D, frame: Frame, { trace, length }: Drawn, colour: string): void {
  const size = lengthIn(frame, length);
  context.strokeStyle = colour;
  for (let n = 1; n < trace.length; n++) {
    const [from, to] = [trace[n - 1] ?? NaN, trace[n] ?? NaN];
    if (!Number.isFinite(from + to)) continue;
    context.globalAlpha = 0.55 * (n / trace.length) ** 1.5;
    context.lineWidth = 1 + (7 * n) / trace.length;
    context.beginPath();
    context.arc(frame.x, frame.y, size, Math.PI / 2 - from, Math.PI / 2 - to, to > from);
    context.stroke();
  }
  context.globalAlpha = 1;
}

function drawPendulum(context: CanvasRenderingContext2D, frame: Frame, pendulum: Drawn, all: Colours): void {
  const [x, y] = bobOf(frame, pendulum);
  context.strokeStyle = all.ink;
  context.lineWidth = 2.5;
  stroke(context, frame.x, frame.y, x, y);
  const radius = bobRadius(frame, pendulum);
  disc(context, x, y, radius, all[pendulum.colour]);
  // A highlight, as light from the upper left leaves it.
  const light = context.createRadialGradient(x - radius / 3, y - radius / 3, 0, x - radius / 3, y - radius / 3, 1.2 * radius);
  light.addColorStop(0, "rgb(255 255 255 / 55%)");
  light.addColorStop(1, "rgb(255 255 255 / 0%)");
  context.fillStyle = light;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}

export function bobRadius({ radius }: Frame, { bob }: Drawn): number {
  return Math.max(11, 0.068 * radius) * bob;
}

/** Two posts with a beam between them, in the way of the bob. */
function drawGate(context: CanvasRenderingContext2D, frame: Frame, pendulum: Drawn, isBroken: boolean, all: Colours): void {
  const [y, size] = [frame.y + lengthIn(frame, pendulum.length), bobRadius(frame, pendulum)];
  context.fillStyle = all.quiet;
  context.fillRect(frame.x - 4, y + size + 3, 8, 10);
  context.fillRect(frame.x - 22, y + size + 11, 44, 5);
  disc(context, frame.x, y, 5, isBroken ? all["curve-2"] : all.ground);
  context.strokeStyle = all["curve-2"];
  context.lineWidth = 2;
  context.beginPath();
  context.arc(frame.x, y, 5, 0, 2 * Math.PI);
  context.stroke();
}

function drawProtractor(context: CanvasRenderingContext2D, { x, y, radius }: Frame, angle: number, unit: string, all: Colours, letters: string): void {
  const turn = angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  const size = 0.34 * radius;
  context.strokeStyle = all["curve-5"];
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, size, Math.PI / 2 - turn, Math.PI / 2, turn < 0);
  context.stroke();
  context.font = letters;
  context.fillStyle = all.ink;
  // The marks are read to half a degree.
  const read = unit === "rad" ? `${turn.toFixed(2)} rad` : `${(Math.round((turn * 360) / Math.PI) / 2).toFixed(1)}°`;
  context.fillText(read.replace("-", "−"), x + (size + 26) * Math.sin(turn / 2), y + (size + 16) * Math.cos(turn / 2));
}

function drawArrows(context: CanvasRenderingContext2D, frame: Frame, pendulum: Drawn, all: Colours, letters: string): void {
  const [x, y] = bobOf(frame, pendulum);
  const most = 0.4 * frame.radius;
  context.font = letters;
  arrow(context, x, y, 0, 0.6 * most, all["curve-2"], "g");
  const speed = pendulum.fastest > 0 ? (most * pendulum.velocity) / pendulum.fastest : 0;
  arrow(context, x, y, speed * Math.cos(pendulum.angle), -speed * Math.sin(pendulum.angle), all["curve-3"], "v");
}

function arrow(context: CanvasRenderingContext2D, x: number, y: number, across: number, down: number, colour: string, name: string): void {
  const size = Math.hypot(across, down);
  if (size < 4) return;
  const [ux, uy] = [across / size, down / size];
  const [endX, endY] = [x + across, y + down];
  const head = Math.min(12, 0.6 * size);
  context.strokeStyle = context.fillStyle = colour;
  context.lineWidth = 4;
  stroke(context, x, y, endX - head * ux, endY - head * uy);
  context.beginPath();
  context.moveTo(endX, endY);
  context.lineTo(endX - head * ux - 0.6 * head * uy, endY - head * uy + 0.6 * head * ux);
  context.lineTo(endX - head * ux + 0.6 * head * uy, endY - head * uy - 0.6 * head * ux);
  context.fill();
  context.fillText(name, endX + 12 * ux + 8 * uy, endY + 12 * uy + 8 * ux);
}

function stroke(context: CanvasRenderingContext2D, x1: number, y1: number, x2: number, y2: number): void {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}

function disc(context: CanvasRenderingContext2D, x: number, y: number, radius: number, colour: string): void {
  context.fillStyle = colour;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}
