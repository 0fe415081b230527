import type { Tile, Vector } from './model';

export interface Eye {
  readonly position: Vector;
  /** Pixels that one metre takes up at a distance of one metre. */
  readonly pixelsPerRadian: number;
  /** Planes of the view, pointing inwards: nx ny nz d. */
  readonly planes: readonly (readonly [number, number, number, number])[];
}

/**
 * The tiles to draw, most urgent first, until `budget` points are spent. Detail adds up from coarse to fine, so a tile is
 * worth drawing where its points would stand further apart than about a pixel; a coarser tile around it always comes first,
 * since it is larger and at least as near.
 */
export function chooseTiles(tiles: readonly Tile[], eye: Eye, budget: number, minSpacing_px = 1): Tile[] {
  const rated: { tile: Tile; pixels: number }[] = [];
  for (const tile of tiles) {
    if (tile.points === 0 || !inView(tile, eye)) continue;
    const distance = Math.max(0.5, distanceTo(tile, eye.position));
    const pixels = (2 * tile.spacing_m * eye.pixelsPerRadian) / distance;
    if (tile.level === 0 || pixels >= minSpacing_px) rated.push({ tile, pixels });
  }
  rated.sort(
    (a, b) =>
      Number(b.tile.level === 0) - Number(a.tile.level === 0) || b.pixels - a.pixels || a.tile.id - b.tile.id,
  );
  const chosen: Tile[] = [];
  let points = 0;
  for (const { tile } of rated) {
    if (points + tile.points > budget && chosen.length > 0) break;
    points += tile.points;
    chosen.push(tile);
  }
  return chosen;
}

function distanceTo(tile: Tile, from: Vector): number {
  const gap = (k: 0 | 1 | 2) => Math.max(tile.min[k] - from[k], 0, from[k] - tile.max[k]);
  return Math.hypot(gap(0), gap(1), gap(2));
}

/** False only if the whole box lies behind one of the planes. */
function inView(tile: Tile, eye: Eye): boolean {
  return eye.planes.every(([nx, ny, nz, d]) => {
    const x = nx > 0 ? tile.max[0] : tile.min[0];
    const y = ny > 0 ? tile.max[1] : tile.min[1];
    const z = nz > 0 ? tile.max[2] : tile.min[2];
    return nx * x + ny * y + nz * z + d >= 0;
  });
}
