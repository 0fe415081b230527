/** Data as the server sends them, made up: a ramp of ground with banks left and right, a wall, flakes; 20 scans. */

export interface MadePoints {
  readonly x: readonly number[];
  readonly y: readonly number[];
  readonly z: readonly number[];
  readonly label: readonly number[];
}

export const kLabels = [
  { id: 0, name: 'unlabeled' },
  { id: 2, name: 'falling_snow' },
  { id: 3, name: 'drivable' },
  { id: 4, name: 'terrain' },
  { id: 5, name: 'obstacle' },
];

/** The same numbers every time. */
export function randomNumbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

export function madeScan(i: number, count = 6000): MadePoints {
  const random = randomNumbers(i + 1);
  const points = { x: [] as number[], y: [] as number[], z: [] as number[], label: [] as number[] };
  for (let k = 0; k < count; ++k) {
    const phase = (2 * Math.PI * k * 7) / count;
    const range = 4 + 36 * Math.abs(Math.sin(3.6 * phase)) ** 1.3;
    const bearing = 0.55 * Math.sin(phase * 1.7 + i);
    const x = range * Math.cos(bearing);
    const y = range * Math.sin(bearing);
    const bank = Math.max(0, Math.abs(y) - 5);
    const flake = random() < 0.03;
    const wall = x > 30 && Math.abs(y) < 2;
    points.x.push(wall ? 30 : x);
    points.y.push(y);
    points.z.push(
      flake ? 0.5 + 3 * random() : wall ? 3 * random() : Math.min(1.5, 0.5 * bank) + 0.02 * (random() - 0.5),
    );
    points.label.push(flake ? 2 : wall ? 5 : bank > 0.3 ? 4 : 3);
  }
  return points;
}

export function encodePoints({ x, y, z, label }: MadePoints, channels = 15): ArrayBuffer {
  const n = x.length;
  const buffer = new ArrayBuffer(16 + 16 * n);
  new DataView(buffer).setUint32(0, 0x314d5242, true);
  new DataView(buffer).setUint32(4, n, true);
  new DataView(buffer).setUint32(12, channels, true);
  [x, y, z].forEach((values, k) => new Float32Array(buffer, 16 + 4 * n * k, n).set(values));
  const bytes = (k: number) => new Uint8Array(buffer, 16 + n * (12 + k), n);
  bytes(0).set(x.map((_, k) => (k * 37) % 200));
  bytes(1).set(label);
  bytes(2).set(x.map((_, k) => Math.floor((255 * k) / n)));
  bytes(3).set(x.map((_, k) => k % 6));
  return buffer;
}

export interface MadePose {
  readonly stamp_ns: bigint;
  readonly points: number;
  /** x y z qx qy qz qw */
  readonly pose: readonly number[];
  readonly health: number;
}

export function encodePoses(poses: readonly MadePose[]): ArrayBuffer {
  const buffer = new ArrayBuffer(4 + 44 * poses.length);
  const view = new DataView(buffer);
  view.setUint32(0, poses.length, true);
  poses.forEach(({ stamp_ns, points, pose, health }, i) => {
    const at = 4 + 44 * i;
    view.setBigInt64(at, stamp_ns, true);
    view.setUint32(at + 8, points, true);
    pose.forEach((value, k) => view.setFloat32(at + 12 + 4 * k, value, true));
    view.setUint8(at + 40, health);
  });
  return buffer;
}

export const madePoses = (count = 20): MadePose[] =>
  Array.from({ length: count }, (_, i) => ({
    stamp_ns: 1_700_000_000_000_000_000n + BigInt(i) * 100_000_000n,
    points: 6000,
    pose: [0.5 * i, 0, 0, 0, 0, 0, 1],
    health: i === 7 ? 2 : 1,
  }));

export const madePiste = (i: number) => {
  const { x, z } = madeScan(i);
  const steps = z.flatMap((height, k) => (k > 0 && Math.abs(height - z[k - 1]!) > 0.9 ? [k] : []));
  return {
    points: x.length,
    method: 'reference',
    first: 0,
    x,
    z,
    intensity: x.map((_, k) => (k * 37) % 200),
    interpolated: x.map(() => 0),
    steps,
    petals: Array.from({ length: 10 }, (_, k) => [600 * k, 600 * k + 599]),
    shown: x.map((_, k) => k),
  };
};

export function encodeOctree(
  voxels: readonly { x: number; y: number; z: number; size: number; side: number; p: number }[],
): ArrayBuffer {
  const buffer = new ArrayBuffer(4 + 20 * voxels.length);
  const view = new DataView(buffer);
  view.setUint32(0, voxels.length, true);
  voxels.forEach((voxel, i) => {
    [voxel.x, voxel.y, voxel.z, voxel.size].forEach((value, k) =>
      view.setFloat32(4 + 20 * i + 4 * k, value, true),
    );
    view.setUint8(4 + 20 * i + 16, voxel.side);
    view.setUint8(4 + 20 * i + 17, voxel.p);
  });
  return buffer;
}

/** A map of 12 tiles at two levels. */
export function madeMap() {
  const tiles = [{ id: 0, level: 0, min: [-10, -20, -1], max: [50, 20, 3], points: 2400, spacing_m: 1 }];
  for (let k = 0; k < 11; ++k) {
    tiles.push({
      id: k + 1,
      level: 1,
      min: [-10 + 5.5 * k, -20, -1],
      max: [-4.5 + 5.5 * k, 20, 3],
      points: 4000,
      spacing_m: 0.25,
    });
  }
  return { bounds: { min: [-10, -20, -1], max: [50, 20, 3] }, channels: 3, tiles };
}

export function madeTile(id: number): MadePoints {
  const random = randomNumbers(1000 + id);
  const tile = madeMap().tiles[id]!;
  const points = { x: [] as number[], y: [] as number[], z: [] as number[], label: [] as number[] };
  for (let k = 0; k < tile.points; ++k) {
    const y = tile.min[1]! + 40 * random();
    const bank = Math.max(0, Math.abs(y) - 5);
    points.x.push(tile.min[0]! + (tile.max[0]! - tile.min[0]!) * random());
    points.y.push(y);
    points.z.push(Math.min(1.5, 0.5 * bank) - 0.05);
    points.label.push(bank > 0.3 ? 4 : 3);
  }
  return points;
}
