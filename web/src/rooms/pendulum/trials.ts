// The trials of a class as data: amplitude, length, number of swings, readings of the time, and columns with names of their own.

import type { Address } from "../../address.ts";

/** A trial with a period: amplitude in degrees and length in metres, NaN where they are not entered, and the period of each reading. */
export interface Trial {
  readonly amplitude: number;
  readonly length: number;
  readonly swings: number;
  readonly periods: readonly number[];
}

/** Columns before the readings: amplitude, length, swings. */
export const FIXED = 3;
/** Most readings of one trial, and most trials. */
export const [MOST_READINGS, MOST_TRIALS] = [10, 500];

/** The number of a cell, with a decimal point or comma. */
export function numberOf(cell: string): number {
  const written = cell.trim().replace("\u2212", "-").replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(written) ? Number(written) : NaN;
}

export class Trials {
  rows: string[][] = [];
  /** Number of columns for readings. */
  readings = 1;
  /** The names of further columns. */
  names: string[] = [];
  readonly #address: Address;

  constructor(address: Address) {
    this.#address = address;
    const [readings = "1", ...names] = (address.get("columns") ?? "1").split(":");
    this.readings = Math.min(MOST_READINGS, Math.max(1, Math.floor(Number(readings)) || 1));
    this.names = names;
    this.rows = (address.get("trials") ?? "").split("/").filter((row) => row !== "").slice(0, MOST_TRIALS).map((row) => row.split(":"));
    this.#square();
  }

  get width(): number {
    return FIXED + this.readings + this.names.length;
  }

  /** Puts the table into the address. */
  keep(): void {
    const clean = (text: string) => text.replaceAll(/[:/]/g, " ").trim();
    const rows = this.rows.map((row) => row.map(clean)).filter((row) => row.some((cell) => cell !== ""));
    const columns = [String(this.readings), ...this.names.map(clean)].join(":");
    this.#address.put({ trials: rows.length === 0 ? undefined : rows.map((row) => row.join(":")).join("/"), columns: columns === "1" ? undefined : columns });
  }

  set(row: number, column: number, value: string): void {
    while (this.rows.length <= row) this.rows.push([]);
    const cells = this.rows[row];
    if (cells !== undefined) cells[column] = value;
    this.#square();
  }

  /** Adds a measured time; a trial with the same settings gets a further reading. */
  add(amplitude: string, length: string, swings: number, seconds: string): void {
    const filled = this.rows.filter((row) => row.some((cell) => cell !== ""));
    this.rows = filled;
    const last = filled.at(-1);
    const isSame = last !== undefined && last[0] === amplitude && last[1] === length && last[2] === String(swings);
    const free = isSame ? this.#free(last) : undefined;
    // A further column makes new rows.
    const place = this.rows.at(-1);
    if (place !== undefined && free !== undefined) place[free] = seconds;
    else if (this.rows.length < MOST_TRIALS) this.rows.push([amplitude, length, String(swings), seconds]);
    this.#square();
  }

  addReading(): void {
    if (this.readings >= MOST_READINGS) return;
    for (const row of this.rows) row.splice(FIXED + this.readings, 0, "");
    this.readings += 1;
    this.#square();
  }

  addColumn(name: string): void {
    this.names.push(name);
    this.#square();
  }

  /** Fills cells from a spreadsheet's text, from a cell on; lines without any number are headings and left out. Returns the number of lines, `undefined` if not all of it has room. */
  paste(text: string, row: number, column: number): number | undefined {
    const lines = text.replace(/\r/g, "").split("\n").filter((line) => line.trim() !== "");
    const cells = lines.map((line) => line.split(/[\t;]/).map((cell) => cell.trim())).filter((line) => line.some((cell) => Number.isFinite(numberOf(cell))));
    const widest = Math.max(0, ...cells.map((line) => line.length));
    while (column + widest > this.width && this.readings < MOST_READINGS) this.addReading();
    cells.slice(0, MOST_TRIALS - row).forEach((line, down) => line.forEach((cell, across) => this.set(row + down, column + across, cell)));
    return cells.length <= MOST_TRIALS - row && column + widest <= this.width ? cells.length : undefined;
  }

  clear(): void {
    [this.rows, this.readings, this.names] = [[], 1, []];
  }

  /** The trial of a row; `undefined` if it has no period. */
  trial(row: readonly string[]): Trial | undefined {
    const [amplitude = NaN, length = NaN, swings = NaN] = row.slice(0, FIXED).map(numberOf);
    const count = Number.isFinite(swings) ? swings : row[2]?.trim() === "" ? 1 : NaN;
    const times = row.slice(FIXED, FIXED + this.readings).map(numberOf).filter((time) => time > 0);
    if (times.length === 0 || !(count > 0)) return undefined;
    return { amplitude: Math.abs(amplitude), length, swings: count, periods: times.map((time) => time / count) };
  }

  get all(): Trial[] {
    return this.rows.flatMap((row) => this.trial(row) ?? []);
  }

  #free(row: readonly string[]): number | undefined {
    for (let n = FIXED; n < FIXED + this.readings; n++) if (row[n] === "") return n;
    if (this.readings >= MOST_READINGS) return undefined;
    this.addReading();
    return FIXED + this.readings - 1;
  }

  /** Gives all rows the same number of cells. */
  #square(): void {
    this.rows = this.rows.map((row) => Array.from({ length: this.width }, (_, n) => row[n] ?? ""));
  }
}

/** The mean of periods. */
export function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}
