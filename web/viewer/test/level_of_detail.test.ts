import { describe, expect, test } from 'vitest';
import type { Tile, Vector } from '../src/data/model';
import { chooseTiles, type Eye } from '../src/data/level_of_detail';

/** A pyramid of tiles over 1024 m x 1024 m: each level has half the size, half the spacing. */
function pyramid(levels: number, points: number): Tile[] {
  const tiles: Tile[] = [];
  for (let level = 0; level < levels; ++level) {
    const size = 1024 / 2 ** level;
    for (let x = 0; x < 1024; x += size) {
      for (let y = 0; y < 1024; y += size) {
        tiles.push({
          id: tiles.length,
          level,
          min: [x, y, 0],
          max: [x + size, y + size, 5],
          points,
          spacing_m: 4 / 2 ** level,
        });
      }
    }
  }
  return tiles;
}

const eye = (position: Vector, planes: Eye['planes'] = []): Eye => ({
  position,
  pixelsPerRadian: 800,
  planes,
});
const tiles = pyramid(6, 20_000);
const sum = (chosen: readonly Tile[]) => chosen.reduce((total, tile) => total + tile.points, 0);

describe('tiles of a map', () => {
  test('never hold more points than the budget', () => {
    for (const budget of [20_000, 500_000, 3e6]) {
      const points = sum(chooseTiles(tiles, eye([300, 700, 10]), budget));
      expect(points).toBeLessThanOrEqual(budget);
      expect(points).toBeGreaterThan(0);
    }
  });

  test('begin with the coarsest, and hold a parent wherever they hold its child', () => {
    const chosen = chooseTiles(tiles, eye([300, 700, 10]), 3e6);
    expect(chosen[0]!.level).toBe(0);
    const ids = new Set(chosen.map((tile) => tile.id));
    for (const tile of chosen) {
      const around = tiles.filter(
        (other) =>
          other.level < tile.level &&
          [0, 1].every((k) => other.min[k]! <= tile.min[k]! && other.max[k]! >= tile.max[k]!),
      );
      for (const parent of around) expect(ids.has(parent.id)).toBe(true);
    }
  });

  test('are finer near the eye', () => {
    const chosen = chooseTiles(tiles, eye([0, 0, 10]), 2e6);
    const finest = chosen.filter((tile) => tile.level === 5);
    expect(finest.length).toBeGreaterThan(0);
    for (const tile of finest) expect(Math.hypot(tile.min[0], tile.min[1])).toBeLessThan(500);
  });

  test('from far away are the coarse ones', () => {
    expect(
      Math.max(...chooseTiles(tiles, eye([512, 512, 6000]), 3e6).map((tile) => tile.level)),
    ).toBeLessThan(3);
  });

  test('behind the camera are left out', () => {
    const chosen = chooseTiles(tiles, eye([512, 512, 10], [[1, 0, 0, -512]]), 1e9);
    expect(chosen.every((tile) => tile.max[0] >= 512)).toBe(true);
  });
});
