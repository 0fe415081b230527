import type { PointBlock } from '../data/points';
import type { Vector } from '../data/model';

export interface ProfilePoint {
  /** Distance along the line from its first point, horizontally (m). */
  readonly along_m: number;
  readonly height_m: number;
  readonly label: number;
  readonly world: Vector;
}

/** Moves points into the world: 16 numbers, column by column, as three.js has them. */
export type Matrix = ArrayLike<number>;

/** Points within `halfWidth_m` of the vertical plane through `a` and `b`, between the two; not in order. */
export function profile(
  blocks: readonly { points: PointBlock; matrix: Matrix }[],
  a: Vector,
  b: Vector,
  halfWidth_m: number,
  shown: (label: number) => boolean,
  limit = 200_000,
): ProfilePoint[] {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (!(length > 0)) return [];
  const ux = (b[0] - a[0]) / length;
  const uy = (b[1] - a[1]) / length;
  const found: ProfilePoint[] = [];
  for (const { points, matrix: m } of blocks) {
    for (let i = 0; i < points.count && found.length < limit; ++i) {
      const px = points.x[i]!;
      const py = points.y[i]!;
      const pz = points.z[i]!;
      const x = m[0]! * px + m[4]! * py + m[8]! * pz + m[12]!;
      const y = m[1]! * px + m[5]! * py + m[9]! * pz + m[13]!;
      const along = (x - a[0]) * ux + (y - a[1]) * uy;
      if (along < 0 || along > length) continue;
      if (Math.abs((y - a[1]) * ux - (x - a[0]) * uy) > halfWidth_m || !shown(points.label[i]!)) continue;
      const z = m[2]! * px + m[6]! * py + m[10]! * pz + m[14]!;
      found.push({ along_m: along, height_m: z, label: points.label[i]!, world: [x, y, z] });
    }
  }
  return found;
}

export interface Measurement {
  readonly distance_m: number;
  readonly horizontal_m: number;
  /** Of the second point above the first. */
  readonly height_m: number;
  /** Height by horizontal distance; infinite for a plumb line. */
  readonly grade_percent: number;
}

export function measure(a: Vector, b: Vector): Measurement {
  const horizontal_m = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const height_m = b[2] - a[2];
  return {
    distance_m: Math.hypot(horizontal_m, height_m),
    horizontal_m,
    height_m,
    grade_percent: (100 * height_m) / horizontal_m,
  };
}
