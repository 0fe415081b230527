import { JsonReader } from './json';
import { DataError } from './errors';

export type Vector = readonly [number, number, number];

export interface RunInfo {
  readonly id: number;
  readonly name: string;
  readonly isRun: boolean;
  readonly scans: number;
  readonly machine: string;
  readonly sensor: string;
  readonly start_s: number;
  readonly layers: ReadonlySet<string>;
}

export interface LabelName {
  readonly id: number;
  readonly name: string;
}

export interface EdgeLine {
  readonly line: number;
  readonly side: string;
  readonly kind: string;
  /** x y z, world less the origin. */
  readonly vertices: Float32Array;
  /** 0..1, one a vertex. */
  readonly confidence: Float64Array;
}

export interface Edges {
  readonly truth: boolean;
  readonly lines: readonly EdgeLine[];
}

export interface Tile {
  readonly id: number;
  readonly level: number;
  readonly min: Vector;
  readonly max: Vector;
  readonly points: number;
  readonly spacing_m: number;
}

export interface TileTree {
  readonly min: Vector;
  readonly max: Vector;
  readonly tiles: readonly Tile[];
}

/** Series over the firing order of one scan, and what the piste method saw in them. */
export interface Piste {
  readonly method: string;
  readonly first: number;
  readonly x: Float64Array;
  readonly z: Float64Array;
  readonly intensity: Float64Array;
  readonly interpolated: Float64Array;
  readonly steps: Float64Array;
  readonly petals: readonly (readonly [number, number])[];
  /** Index among the points of the scan, -1 where the sample is not among them. */
  readonly shown: Float64Array;
}

function vector(reader: JsonReader): Vector {
  const [x, y, z] = reader.numbers(3);
  return [x!, y!, z!];
}

export function parseRuns(json: unknown): RunInfo[] {
  return new JsonReader(json, 'runs').list().map((run) => {
    const layers = ['labels', 'edges', 'map', 'octree', 'trajectory', 'global_trajectory', 'piste'];
    return {
      id: run.at('id').count(),
      name: run.at('name').string(),
      isRun: run.at('is_run').flag(),
      scans: run.at('scans').count(),
      machine: run.at('machine').missing ? '' : run.at('machine').string(),
      sensor: run.at('sensor').missing ? '' : run.at('sensor').string(),
      start_s: run.at('start_ns').missing ? 0 : run.at('start_ns').number() * 1e-9,
      layers: new Set(layers.filter((layer) => run.at('layers').at(layer).flag())),
    };
  });
}

export function parseLabels(json: unknown): LabelName[] {
  return new JsonReader(json, 'labels').list().map((label) => {
    const id = label.at('id').count();
    if (id > 255) throw new DataError(`labels: id ${id}, expected one byte`);
    return { id, name: label.at('name').string() };
  });
}

export function parseEdges(json: unknown): Edges {
  const root = new JsonReader(json, 'edges');
  const lines = root
    .at('features')
    .list()
    .map((feature) => {
      const coordinates = feature.at('geometry').at('coordinates').list();
      const vertices = new Float32Array(3 * coordinates.length);
      coordinates.forEach((vertex, i) => vertices.set(vertex.numbers(3), 3 * i));
      const properties = feature.at('properties');
      return {
        line: properties.at('line').count(),
        side: properties.at('side').string(),
        kind: properties.at('kind').missing ? '' : properties.at('kind').string(),
        vertices,
        confidence: properties.at('confidence').numbers(coordinates.length),
      };
    });
  return { truth: root.at('truth').flag(), lines };
}

export function parseTiles(json: unknown): TileTree {
  const root = new JsonReader(json, 'map');
  const tiles = root
    .at('tiles')
    .list()
    .map((tile) => ({
      id: tile.at('id').count(),
      level: tile.at('level').count(),
      min: vector(tile.at('min')),
      max: vector(tile.at('max')),
      points: tile.at('points').count(),
      spacing_m: tile.at('spacing_m').missing ? 0.1 : tile.at('spacing_m').number(),
    }));
  return { min: vector(root.at('bounds').at('min')), max: vector(root.at('bounds').at('max')), tiles };
}

export function parsePiste(json: unknown): Piste {
  const root = new JsonReader(json, 'piste');
  const z = root.at('z').numbers();
  const sameLength = (key: string) =>
    root.at(key).missing ? new Float64Array(z.length) : root.at(key).numbers(z.length);
  return {
    method: root.at('method').missing ? '' : root.at('method').string(),
    first: root.at('first').count(),
    x: sameLength('x'),
    z,
    intensity: sameLength('intensity'),
    interpolated: sameLength('interpolated'),
    steps: root
      .at('steps')
      .numbers()
      .filter((k) => Number.isInteger(k) && k >= 0 && k < z.length),
    petals: root
      .at('petals')
      .list()
      .map((pair) => {
        const [first, last] = pair.numbers(2);
        return [first!, last!] as const;
      }),
    shown: root.at('shown').numbers(z.length),
  };
}
