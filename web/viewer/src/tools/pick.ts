import type { PointBlock } from '../data/points';
import type { Matrix } from './profile';

export interface Hit {
  readonly index: number;
  /** Depth in clip space, -1 (near) to 1. */
  readonly depth: number;
  readonly pixels: number;
}

/**
 * The point that a user means who points at (`x`, `y`) pixels: of those within `radius_px` of the pointer the one with the
 * least distance in pixels, weighed against depth, so that the front of a wall wins over what shines through it.
 * `clip` takes points to clip space (16 numbers, column by column).
 */
export function pick(
  points: PointBlock,
  clip: Matrix,
  view: { width: number; height: number },
  pointer: { x: number; y: number },
  radius_px: number,
  shown: (label: number) => boolean,
): Hit | undefined {
  const nx = (2 * pointer.x) / view.width - 1;
  const ny = 1 - (2 * pointer.y) / view.height;
  const reachX = (2 * radius_px) / view.width;
  const reachY = (2 * radius_px) / view.height;
  let best: Hit | undefined;
  let bestScore = Infinity;
  for (let i = 0; i < points.count; ++i) {
    const px = points.x[i]!;
    const py = points.y[i]!;
    const pz = points.z[i]!;
    const w = clip[3]! * px + clip[7]! * py + clip[11]! * pz + clip[15]!;
    if (w <= 0) continue;
    const dx = (clip[0]! * px + clip[4]! * py + clip[8]! * pz + clip[12]!) / w - nx;
    if (Math.abs(dx) > reachX) continue;
    const dy = (clip[1]! * px + clip[5]! * py + clip[9]! * pz + clip[13]!) / w - ny;
    if (Math.abs(dy) > reachY || !shown(points.label[i]!)) continue;
    const pixels = Math.hypot((dx * view.width) / 2, (dy * view.height) / 2);
    if (pixels > radius_px) continue;
    // A point one radius off the pointer must be nearer by a third to win over one right under it.
    const score = w * (1 + (0.5 * pixels) / radius_px);
    if (score >= bestScore) continue;
    bestScore = score;
    best = { index: i, depth: (clip[2]! * px + clip[6]! * py + clip[10]! * pz + clip[14]!) / w, pixels };
  }
  return best;
}
