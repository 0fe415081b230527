import type { Path } from './data';

/** Along the way of a path, horizontally, from where it began. */
export interface Elevation {
  readonly chainageM: number[];
  readonly heightM: number[];
  /** Uphill positive; null where less than half the window is known. */
  readonly slopePercent: (number | null)[];
}

/** Shorter steps are noise of the pose: a machine that stands goes nowhere. */
const kStepM = 0.5;
/** What a slope is the mean of: about two lengths of a machine. */
const kWindowM = 10;

export function elevationOf(path: Pick<Path, 'x' | 'y' | 'z'>): Elevation {
  const chainageM: number[] = [];
  const heightM: number[] = [];
  let last = -1;
  let way = 0;
  for (let i = 0; i < path.z.length; ++i) {
    const step = last < 0 ? 0 : Math.hypot(path.x[i]! - path.x[last]!, path.y[i]! - path.y[last]!);
    if (last >= 0 && step < kStepM) continue;
    way += step;
    last = i;
    chainageM.push(way);
    heightM.push(path.z[i]! - path.z[0]!);
  }
  return { chainageM, heightM, slopePercent: chainageM.map((_, i) => slopeAt(chainageM, heightM, i)) };
}

function slopeAt(chainageM: readonly number[], heightM: readonly number[], i: number): number | null {
  const here = chainageM[i]!;
  let from = i;
  let to = i;
  while (from > 0 && here - chainageM[from - 1]! <= kWindowM / 2) --from;
  while (to + 1 < chainageM.length && chainageM[to + 1]! - here <= kWindowM / 2) ++to;
  // Poses that lie farther apart than the window: the slope between neighbours is all there is.
  if (from === to) {
    from = Math.max(0, i - 1);
    to = Math.min(chainageM.length - 1, i + 1);
  }
  const length = chainageM[to]! - chainageM[from]!;
  return length >= kWindowM / 2 ? (100 * (heightM[to]! - heightM[from]!)) / length : null;
}
