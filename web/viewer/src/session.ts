import { api } from './data/api';
import type { LabelName, Piste, RunInfo, TileTree } from './data/model';
import { scanKey, type OpenedRun } from './data/opening';
import type { PointBlock } from './data/points';
import type { PoseTable } from './data/poses';
import { RunView } from './scene/run_view';
import { kGlobalPathColour, kPathColour } from './colours';
import { makeEdges, makePath, makeVoxels } from './scene/layers';
import { groundIds } from './tools/ground_distance';
import type { LayerName } from './view_state';
import { kModes, type Mode } from './modes';

/** One run: what the server said about it, and what is drawn of it. */
export class RunSession {
  readonly view: RunView;
  readonly ground: ReadonlySet<number>;
  tiles: TileTree | undefined;
  private readonly asked = new Set<LayerName>();

  readonly info: RunInfo;
  readonly table: PoseTable;
  readonly labels: readonly LabelName[];

  constructor({ info, table, labels }: OpenedRun) {
    this.info = info;
    this.table = table;
    this.labels = labels;
    this.view = new RunView(table);
    this.ground = groundIds(labels);
  }

  /** Fetches a layer when it is wanted for the first time. */
  async load(layer: LayerName): Promise<void> {
    if (this.asked.has(layer)) return;
    this.asked.add(layer);
    const { id, layers } = this.info;
    if (layer === 'edges' && layers.has('edges')) this.view.setLayer(layer, makeEdges(await api.edges(id)));
    if (layer === 'octree' && layers.has('octree'))
      this.view.setLayer(layer, makeVoxels(await api.octree(id)));
    if (layer === 'trajectory' && layers.has('trajectory')) {
      this.view.setLayer(layer, makePath(await api.trajectory(id), kPathColour));
    }
    if (layer === 'global' && layers.has('global_trajectory')) {
      this.view.setLayer(layer, makePath(await api.globalTrajectory(id), kGlobalPathColour));
    }
    if (layer === 'map' && layers.has('map')) this.tiles = await api.tiles(id);
  }

  scanKey(scan: number): string {
    return scanKey(this.info.id, scan);
  }

  tileKey(tile: number): string {
    return `${this.info.id}/tile/${tile}`;
  }

  wantScan(scan: number) {
    return { key: this.scanKey(scan), fetch: (signal: AbortSignal) => api.scan(this.info.id, scan, signal) };
  }

  wantTile(tile: number) {
    return { key: this.tileKey(tile), fetch: (signal: AbortSignal) => api.tile(this.info.id, tile, signal) };
  }

  piste(scan: number, signal: AbortSignal): Promise<Piste> {
    return api.piste(this.info.id, scan, signal);
  }

  labelName(id: number): string {
    return this.labels.find((label) => label.id === id)?.name ?? String(id);
  }
}

export type Range = readonly [number, number];

/** Bounds of the colours that show most of a scan: from its first to its 99th percentile. `height_m`: of the machine. */
export function autoRange(
  mode: Mode,
  block: PointBlock | undefined,
  height_m: number,
  tiles: TileTree | undefined,
): Range {
  if (mode === 'ground') return [-1.5, 1.5];
  if (mode === 'height' && tiles !== undefined) return [tiles.min[2], tiles.max[2]];
  if (block === undefined || block.count === 0 || mode === 'time' || mode === 'label') return [0, 1];
  const values: ArrayLike<number> =
    mode === 'height' ? block.z : mode === 'ring' ? block.ring : block.intensity;
  const step = Math.max(1, Math.floor(block.count / 5000));
  const sample: number[] = [];
  for (let i = 0; i < block.count; i += step) sample.push(values[i]!);
  sample.sort((a, b) => a - b);
  const at = (share: number) => sample[Math.round(share * (sample.length - 1))]!;
  const low = at(0.01) + (mode === 'height' ? height_m : 0);
  const high = at(0.99) + (mode === 'height' ? height_m : 0);
  return [low, Math.max(high, low + 0.1)];
}

export const rampOf = (mode: Mode) => kModes.find((candidate) => candidate.id === mode)!.ramp;
