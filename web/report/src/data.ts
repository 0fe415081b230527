import { readTerrain, type Terrain } from './terrain';

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type Numbers = (number | null)[];

/** Columns over a common x; a long table has two values for every so many rows. */
export interface Table {
  rows: number;
  rowsPerValue: number;
  x: number[];
  columns: Record<string, Numbers>;
}

/** How many scans took how long: bin i begins at first * 10^(i / binsPerDecade) ms. */
export interface Histograms {
  firstMs: number;
  binsPerDecade: number;
  scans: Record<string, number[]>;
}

export interface Path {
  poses: number;
  lengthM: number;
  timeS: number[];
  x: number[];
  y: number[];
  z: number[];
}

export interface EdgeLine {
  side: string;
  x: number[];
  y: number[];
}

export interface Report {
  version: string;
  run: Json;
  evaluation: Json;
  scans?: Table;
  times?: Table;
  histograms?: Histograms;
  road?: Table;
  /** Of its column `health` 0 is good, 1 starting, 2 weak, 3 lost. */
  odometry?: Table;
  trajectory?: Path;
  globalTrajectory?: Path;
  edges: EdgeLine[];
  terrain?: Terrain;
  originM: number[];
  trouble: string[];
}

/** What stands at a path of keys; null where there is nothing. */
export function at(json: Json | undefined, ...keys: (string | number)[]): Json {
  let value: Json = json ?? null;
  for (const key of keys) {
    if (Array.isArray(value) && typeof key === 'number') value = value[key] ?? null;
    else if (isObject(value) && Object.hasOwn(value, key)) value = value[key] ?? null;
    else return null;
  }
  return value;
}

export function isObject(json: Json | undefined): json is { [key: string]: Json } {
  return typeof json === 'object' && json !== null && !Array.isArray(json);
}

/** The number at a path, `otherwise` if there is none. */
export function num(json: Json | undefined, keys: (string | number)[], otherwise = 0): number {
  const value = at(json, ...keys);
  return typeof value === 'number' && Number.isFinite(value) ? value : otherwise;
}

export function text(json: Json | undefined, ...keys: (string | number)[]): string {
  const value = at(json, ...keys);
  return typeof value === 'string' ? value : '';
}

export function list(json: Json | undefined, ...keys: (string | number)[]): Json[] {
  const value = at(json, ...keys);
  return Array.isArray(value) ? value : [];
}

export function entries(json: Json | undefined, ...keys: (string | number)[]): [string, Json][] {
  const value = at(json, ...keys);
  return isObject(value) ? Object.entries(value) : [];
}

const numbers = (json: Json): number[] =>
  Array.isArray(json) ? json.map((v) => (typeof v === 'number' ? v : NaN)) : [];
const withGaps = (json: Json): Numbers =>
  Array.isArray(json) ? json.map((v) => (typeof v === 'number' ? v : null)) : [];

/** A table of which every column is as long as x; none if there is nothing in it. */
function readTable(json: Json): Table | undefined {
  const x = numbers(at(json, 'x'));
  const columns: Record<string, Numbers> = {};
  for (const [name, values] of entries(json, 'columns')) {
    const column = withGaps(values);
    if (column.length === x.length) columns[name] = column;
  }
  if (x.length === 0 || Object.keys(columns).length === 0) return undefined;
  return { rows: num(json, ['rows']), rowsPerValue: num(json, ['rows_per_value'], 1), x, columns };
}

function readHistograms(json: Json): Histograms | undefined {
  const scans = Object.fromEntries(entries(json, 'scans').map(([name, bins]) => [name, numbers(bins)]));
  if (Object.keys(scans).length === 0) return undefined;
  return { firstMs: num(json, ['first_ms'], 1e-3), binsPerDecade: num(json, ['bins_per_decade'], 10), scans };
}

function readPath(json: Json): Path | undefined {
  const [timeS, x, y, z] = ['t_s', 'x_m', 'y_m', 'z_m'].map((key) => numbers(at(json, key))) as [
    number[],
    number[],
    number[],
    number[],
  ];
  if (timeS.length === 0 || [x, y, z].some((values) => values.length !== timeS.length)) return undefined;
  return { poses: num(json, ['poses']), lengthM: num(json, ['path_m']), timeS, x, y, z };
}

function readEdges(json: Json): EdgeLine[] {
  return list(json).map((line) => ({
    side: text(line, 'side'),
    x: numbers(at(line, 'x_m')),
    y: numbers(at(line, 'y_m')),
  }));
}

/** Undefined members are left out: what is not there has no key. */
function present<Part extends object>(part: Part): { [Key in keyof Part]?: NonNullable<Part[Key]> } {
  return Object.fromEntries(Object.entries(part).filter(([, value]) => value !== undefined)) as {
    [Key in keyof Part]?: NonNullable<Part[Key]>;
  };
}

/** Takes what `berm report` wrote into the page. Throws an Error that says what is wrong with it. */
export function readReport(source: string): Report {
  const json = JSON.parse(source) as Json;
  if (json === null) throw new Error('This page holds no run yet: berm report OUT writes one into it.');
  const schema = text(json, 'schema');
  if (schema !== 'berm.report/1')
    throw new Error(`The data are of another version of berm (${schema || 'none'}).`);
  return {
    version: text(json, 'version'),
    run: at(json, 'run'),
    evaluation: at(json, 'evaluation'),
    edges: readEdges(at(json, 'edges')),
    originM: numbers(at(json, 'origin_m')),
    trouble: list(json, 'trouble').map(String),
    ...present({
      scans: readTable(at(json, 'scans')),
      times: readTable(at(json, 'times')),
      histograms: readHistograms(at(json, 'times', 'histogram')),
      road: readTable(at(json, 'road')),
      odometry: readTable(at(json, 'odometry')),
      trajectory: readPath(at(json, 'trajectory')),
      globalTrajectory: readPath(at(json, 'global_trajectory')),
      terrain: readTerrain(at(json, 'terrain')),
    }),
  };
}

/** Stretches of x where `column` is `value`, each from its first to its last row. */
export function stretches(table: Table, column: string, value: number): [number, number][] {
  const found: [number, number][] = [];
  let open = false;
  (table.columns[column] ?? []).forEach((entry, i) => {
    const x = table.x[i]!;
    if (entry !== value) open = false;
    else if (open) found[found.length - 1]![1] = x;
    else {
      found.push([x, x]);
      open = true;
    }
  });
  return found;
}

/** Smallest, median and largest of what is known; null if nothing is. */
export function spread(values: Numbers): { low: number; median: number; high: number } | null {
  const known = values.filter((value): value is number => value !== null).sort((a, b) => a - b);
  if (known.length === 0) return null;
  return { low: known[0]!, median: known[(known.length - 1) >> 1]!, high: known[known.length - 1]! };
}

/** At most `most` places out of `count`, evenly, with the first and the last. */
export function everyNth(count: number, most: number): number[] {
  if (count <= most) return Array.from({ length: count }, (_, i) => i);
  return Array.from({ length: most }, (_, i) => Math.round((i * (count - 1)) / (most - 1)));
}

/** The value of `column` in the last row of `table` that is not after `x`; null without one. */
export function before(table: Table | undefined, column: string, x: number): number | null {
  const values = table?.columns[column];
  if (!table || !values) return null;
  let [low, high] = [0, table.x.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (table.x[middle]! <= x) low = middle + 1;
    else high = middle;
  }
  return values[low - 1] ?? null;
}

/** Sums from below, so that each area ends where the next begins. */
export function stack(columns: readonly Numbers[]): Numbers[] {
  let below: Numbers = [];
  return columns.map((column) => {
    below = column.map((value, i) => (value === null ? null : value + (below[i] ?? 0)));
    return below;
  });
}
