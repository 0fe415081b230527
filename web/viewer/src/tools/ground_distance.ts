import type { PointBlock } from '../data/points';

const kCell_m = 1;
/** Names of labels that lie on the ground. */
const kGroundNames =
  /^(drivable|terrain|road|parking|sidewalk|other.?ground|lane.?marking|accumulated.?snow)$/i;

export function groundIds(labels: readonly { id: number; name: string }[]): ReadonlySet<number> {
  return new Set(
    labels.filter((label) => kGroundNames.test(label.name.replace(/_/g, ' '))).map((label) => label.id),
  );
}

/**
 * Height of every point above the ground near it (m): the mean of ground points in its cell of 1 m, or else in the
 * nearest ring of cells around it. Without labels the lowest point of a cell stands for the ground. NaN where there is no
 * ground within `reach` cells.
 */
export function groundDistance(
  points: PointBlock,
  ground: ReadonlySet<number>,
  labelled: boolean,
  reach = 4,
): Float32Array<ArrayBuffer> {
  const cells = labelled ? meanOfGround(points, ground) : lowest(points);
  const filled = new Map<number, number>();
  const distance = new Float32Array(points.count);
  for (let i = 0; i < points.count; ++i) {
    const cx = Math.floor(points.x[i]! / kCell_m);
    const cy = Math.floor(points.y[i]! / kCell_m);
    const key = cellKey(cx, cy);
    let height = filled.get(key);
    if (height === undefined) {
      height = nearest(cells, cx, cy, reach);
      filled.set(key, height);
    }
    distance[i] = points.z[i]! - height;
  }
  return distance;
}

// Cells of +-32 km; farther ones share keys, which no LiDAR reaches.
const cellKey = (cx: number, cy: number) => (cx + 32768) * 65536 + (cy + 32768);

function meanOfGround(points: PointBlock, ground: ReadonlySet<number>): Map<number, number> {
  const sums = new Map<number, { sum: number; count: number }>();
  for (let i = 0; i < points.count; ++i) {
    if (!ground.has(points.label[i]!)) continue;
    const key = cellKey(Math.floor(points.x[i]! / kCell_m), Math.floor(points.y[i]! / kCell_m));
    const cell = sums.get(key);
    if (cell === undefined) sums.set(key, { sum: points.z[i]!, count: 1 });
    else {
      cell.sum += points.z[i]!;
      ++cell.count;
    }
  }
  return new Map([...sums].map(([key, cell]) => [key, cell.sum / cell.count]));
}

function lowest(points: PointBlock): Map<number, number> {
  const cells = new Map<number, number>();
  for (let i = 0; i < points.count; ++i) {
    const key = cellKey(Math.floor(points.x[i]! / kCell_m), Math.floor(points.y[i]! / kCell_m));
    const z = points.z[i]!;
    if (!(cells.get(key)! <= z)) cells.set(key, z);
  }
  return cells;
}

function nearest(cells: ReadonlyMap<number, number>, cx: number, cy: number, reach: number): number {
  for (let ring = 0; ring <= reach; ++ring) {
    let sum = 0;
    let count = 0;
    for (let dx = -ring; dx <= ring; ++dx) {
      const step = Math.abs(dx) === ring ? 1 : 2 * ring;
      for (let dy = -ring; dy <= ring; dy += Math.max(1, step)) {
        const height = cells.get(cellKey(cx + dx, cy + dy));
        if (height === undefined) continue;
        sum += height;
        ++count;
      }
    }
    if (count > 0) return sum / count;
  }
  return NaN;
}
