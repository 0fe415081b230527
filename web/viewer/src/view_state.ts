import type { Vector } from './data/model';
import { kModes, type Mode } from './modes';

export const kCameras = ['follow', 'top', 'driver', 'free'] as const;
export type CameraName = (typeof kCameras)[number];

export const kTools = ['none', 'distance', 'profile'] as const;
export type ToolName = (typeof kTools)[number];

export const kLayers = ['scan', 'map', 'edges', 'octree', 'trajectory', 'global', 'piste', 'rings'] as const;
export type LayerName = (typeof kLayers)[number];

export const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4, 8] as const;

/** Where the camera is: on a sphere around a target, which moves along with the machine unless the camera is free. */
export interface CameraView {
  target: Vector;
  distance_m: number;
  azimuth_deg: number;
  elevation_deg: number;
}

/** All that a link must carry to show the same. */
export interface ViewState {
  time_s: number;
  speed: number;
  mode: Mode;
  pointSize: number;
  edl: boolean;
  trail: number;
  camera: CameraName;
  view: CameraView;
  layers: Set<LayerName>;
  /** Names of labels that are not drawn. */
  hidden: Set<string>;
  tool: ToolName;
  marks: Vector[];
  halfWidth_m: number;
}

export const kCameraPresets: Readonly<Record<CameraName, CameraView>> = {
  follow: { target: [6, 0, 0.5], distance_m: 26, azimuth_deg: 180, elevation_deg: 28 },
  top: { target: [10, 0, 0], distance_m: 75, azimuth_deg: 180, elevation_deg: 89.9 },
  driver: { target: [10, 0, 1.4], distance_m: 9, azimuth_deg: 180, elevation_deg: 6 },
  free: { target: [6, 0, 0.5], distance_m: 26, azimuth_deg: 180, elevation_deg: 28 },
};

export function defaultState(): ViewState {
  return {
    time_s: 0,
    speed: 1,
    mode: 'label',
    pointSize: 2.5,
    edl: true,
    trail: 1,
    camera: 'follow',
    view: kCameraPresets.follow,
    layers: new Set(['scan', 'map', 'edges', 'trajectory', 'global', 'rings']),
    hidden: new Set(),
    tool: 'none',
    marks: [],
    halfWidth_m: 0.5,
  };
}

const short = (value: number, digits = 3) => String(Number(value.toFixed(digits)));
const sameSet = <T>(a: ReadonlySet<T>, b: ReadonlySet<T>) =>
  a.size === b.size && [...a].every((item) => b.has(item));

/** The part of the address behind '#': what differs from the default. */
export function encodeState(state: ViewState): string {
  const base = defaultState();
  const fields = new URLSearchParams();
  fields.set('t', short(state.time_s, 6));
  if (state.speed !== base.speed) fields.set('speed', short(state.speed));
  if (state.mode !== base.mode) fields.set('colour', state.mode);
  if (state.pointSize !== base.pointSize) fields.set('size', short(state.pointSize));
  if (!state.edl) fields.set('edl', '0');
  if (state.trail !== base.trail) fields.set('trail', String(state.trail));
  fields.set('camera', state.camera);
  const { target, distance_m, azimuth_deg, elevation_deg } = state.view;
  fields.set(
    'view',
    [...target, distance_m, azimuth_deg, elevation_deg].map((value) => short(value, 2)).join(','),
  );
  if (!sameSet(state.layers, base.layers))
    fields.set('layers', kLayers.filter((layer) => state.layers.has(layer)).join(','));
  if (state.hidden.size > 0) fields.set('hide', [...state.hidden].sort().join(','));
  if (state.tool !== 'none') {
    fields.set('tool', state.tool);
    if (state.marks.length > 0)
      fields.set('marks', state.marks.map((mark) => mark.map((v) => short(v)).join(',')).join(';'));
    if (state.halfWidth_m !== base.halfWidth_m) fields.set('width', short(state.halfWidth_m));
  }
  return fields.toString().replace(/%2C/g, ',').replace(/%3B/g, ';');
}

const clamp = (value: number, low: number, high: number) => Math.min(high, Math.max(low, value));

/** Reads an address that anybody may have written: what makes no sense is left at its default. */
export function decodeState(hash: string): ViewState {
  const fields = new URLSearchParams(hash.replace(/^#/, ''));
  const state = defaultState();
  const number = (key: string, low: number, high: number, set: (value: number) => void) => {
    const text = fields.get(key);
    const value = text === null || text.trim() === '' ? NaN : Number(text);
    if (Number.isFinite(value)) set(clamp(value, low, high));
  };
  const choice = <T extends string>(key: string, choices: readonly T[], set: (value: T) => void) => {
    const found = choices.find((candidate) => candidate === fields.get(key));
    if (found !== undefined) set(found);
  };
  number('t', 0, 1e7, (value) => (state.time_s = value));
  number('speed', kSpeeds[0], kSpeeds[kSpeeds.length - 1]!, (value) => (state.speed = value));
  number('size', 1, 12, (value) => (state.pointSize = value));
  number('edl', 0, 1, (value) => (state.edl = value !== 0));
  number('trail', 1, 50, (value) => (state.trail = Math.round(value)));
  number('width', 0.05, 5, (value) => (state.halfWidth_m = value));
  choice(
    'colour',
    kModes.map((mode) => mode.id),
    (mode) => (state.mode = mode),
  );
  choice('camera', kCameras, (camera) => {
    state.camera = camera;
    state.view = kCameraPresets[camera];
  });
  choice('tool', kTools, (tool) => (state.tool = tool));
  const view = numbers(fields.get('view'));
  if (view.length === 6) {
    state.view = {
      target: [view[0]!, view[1]!, view[2]!],
      distance_m: clamp(view[3]!, 0.2, 1e5),
      azimuth_deg: view[4]!,
      elevation_deg: clamp(view[5]!, -89.9, 89.9),
    };
  }
  const layers = fields.get('layers');
  if (layers !== null) state.layers = new Set(kLayers.filter((layer) => layers.split(',').includes(layer)));
  state.hidden = new Set((fields.get('hide') ?? '').split(',').filter((name) => name !== ''));
  if (state.tool !== 'none') {
    const marks = (fields.get('marks') ?? '').split(';').map(numbers);
    state.marks = marks
      .filter((mark) => mark.length === 3)
      .slice(0, 2)
      .map(([x, y, z]) => [x!, y!, z!]);
  }
  return state;
}

/** The numbers of a list with commas; nothing if one of them is none. */
function numbers(text: string | null): number[] {
  if (text === null || text === '') return [];
  const values = text.split(',').map((item) => (item.trim() === '' ? NaN : Number(item)));
  return values.every(Number.isFinite) ? values : [];
}
