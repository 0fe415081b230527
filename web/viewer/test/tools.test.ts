import { describe, expect, test } from 'vitest';
import { encodePoints, madeScan, randomNumbers } from '../../test/made_data';
import { decodePoints } from '../src/data/points';
import { groundDistance, groundIds } from '../src/tools/ground_distance';
import { pick } from '../src/tools/pick';
import { measure, profile } from '../src/tools/profile';

const kIdentity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const all = () => true;

const block = (points: readonly (readonly [number, number, number, number?])[]) =>
  decodePoints(
    encodePoints({
      x: points.map(([x]) => x),
      y: points.map(([, y]) => y),
      z: points.map(([, , z]) => z),
      label: points.map(([, , , label]) => label ?? 3),
    }),
  );

describe('measuring', () => {
  test('gives distance, height and grade', () => {
    expect(measure([0, 0, 0], [3, 4, 12])).toEqual({
      distance_m: 13,
      horizontal_m: 5,
      height_m: 12,
      grade_percent: 240,
    });
    expect(measure([0, 0, 1], [10, 0, 0]).grade_percent).toBeCloseTo(-10);
    expect(measure([0, 0, 0], [0, 0, 2]).grade_percent).toBe(Infinity);
  });

  test('is the same both ways, but for the sign of the height', () => {
    const random = randomNumbers(3);
    for (let i = 0; i < 100; ++i) {
      const a = [random(), random(), random()] as const;
      const b = [random(), random(), random()] as const;
      expect(measure(a, b).distance_m).toBeCloseTo(measure(b, a).distance_m, 12);
      expect(measure(a, b).height_m).toBeCloseTo(-measure(b, a).height_m, 12);
    }
  });
});

describe('height profile', () => {
  test('holds the points of the corridor and nothing else', () => {
    const points = block([
      [5, 0, 1],
      [5, 0.4, 2],
      [5, 0.6, 3],
      [-0.1, 0, 4],
      [10.1, 0, 5],
      [10, -0.5, 6],
      [0, 0, 7],
    ]);
    const found = profile([{ points, matrix: kIdentity }], [0, 0, 0], [10, 0, 3], 0.5, all);
    expect(found.map((point) => point.height_m)).toEqual([1, 2, 6, 7]);
    expect(found[0]!.along_m).toBe(5);
  });

  test('places points by their matrix', () => {
    const turned = [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 100, 0, 5, 1]; // 90 degrees about z, then 100 m along x, 5 m up
    const found = profile(
      [{ points: block([[3, 0, 1]]), matrix: turned }],
      [100, 0, 0],
      [100, 10, 0],
      0.1,
      all,
    );
    expect(found).toHaveLength(1);
    expect(found[0]!.along_m).toBeCloseTo(3);
    expect(found[0]!.height_m).toBeCloseTo(6);
  });

  test('leaves out labels that are hidden, and takes no line of no length', () => {
    const blocks = [
      {
        points: block([
          [1, 0, 1, 2],
          [2, 0, 1, 3],
        ]),
        matrix: kIdentity,
      },
    ];
    expect(profile(blocks, [0, 0, 0], [9, 0, 0], 1, (label) => label !== 2)).toHaveLength(1);
    expect(profile(blocks, [1, 0, 0], [1, 0, 9], 1, all)).toEqual([]);
  });

  test('agrees with the plain definition on a made scan', () => {
    const points = decodePoints(encodePoints(madeScan(4)));
    const [a, b] = [
      [5, -8, 0],
      [25, 9, 0],
    ] as const;
    const found = profile([{ points, matrix: kIdentity }], a, b, 0.7, all);
    const length = Math.hypot(20, 17);
    const count = Array.from({ length: points.count }, (_, i) => {
      const [x, y] = [points.x[i]! - 5, points.y[i]! + 8];
      const along = (20 * x + 17 * y) / length;
      return along >= 0 && along <= length && Math.abs(20 * y - 17 * x) / length <= 0.7;
    }).filter(Boolean).length;
    expect(found).toHaveLength(count);
    expect(count).toBeGreaterThan(100);
  });
});

describe('distance to ground', () => {
  const ground = groundIds([
    { id: 3, name: 'drivable' },
    { id: 4, name: 'terrain' },
    { id: 5, name: 'obstacle' },
    { id: 9, name: 'lane_marking' },
  ]);

  test('knows what lies on the ground by name', () => {
    expect([...ground]).toEqual([3, 4, 9]);
  });

  test('is measured from the ground near the point', () => {
    const points = block([
      [0.2, 0.2, 10],
      [0.8, 0.8, 10.2],
      [0.5, 0.5, 12.1, 5],
      [2.5, 0.5, 13.1, 5],
      [50, 50, 0, 5],
    ]);
    const distance = groundDistance(points, ground, true);
    expect(distance[2]).toBeCloseTo(2);
    expect(distance[3]).toBeCloseTo(3);
    expect(distance[4]).toBeNaN();
  });

  test('takes the lowest point for the ground where there are no labels', () => {
    expect(
      groundDistance(
        block([
          [0.1, 0, 5],
          [0.2, 0, 5.5],
        ]),
        ground,
        false,
      )[1],
    ).toBeCloseTo(0.5);
  });

  test('looks at every cell of a ring', () => {
    for (let dx = -2; dx <= 2; ++dx) {
      for (let dy = -2; dy <= 2; ++dy) {
        const distance = groundDistance(
          block([
            [dx + 0.5, dy + 0.5, 1],
            [0.5, 0.5, 4, 5],
          ]),
          ground,
          true,
          2,
        );
        expect(distance[1]).toBeCloseTo(3);
      }
    }
  });
});

describe('picking', () => {
  const view = { width: 200, height: 100 };
  // Clip space as it is: x right, y up, w = 1.
  const at = (x: number, y: number) => ({ x: ((x + 1) / 2) * view.width, y: ((1 - y) / 2) * view.height });

  test('finds the point below the pointer', () => {
    const points = block([
      [-0.5, 0, 0],
      [0.5, 0.5, 0],
      [0.52, 0.5, 0],
    ]);
    expect(pick(points, kIdentity, view, at(0.5, 0.5), 10, all)?.index).toBe(1);
    expect(pick(points, kIdentity, view, at(0.53, 0.5), 10, all)?.index).toBe(2);
    expect(pick(points, kIdentity, view, at(0, -0.9), 10, all)).toBeUndefined();
  });

  test('does not find what is hidden', () => {
    expect(
      pick(block([[0, 0, 0, 2]]), kIdentity, view, at(0, 0), 10, (label) => label !== 2),
    ).toBeUndefined();
  });

  test('prefers what is in front, and never finds what is behind the camera', () => {
    const perspective = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0]; // w = z
    const points = block([
      [0, 0, 20],
      [0.05, 0, 5],
      [0, 0, -5],
    ]);
    expect(pick(points, perspective, view, at(0, 0), 10, all)?.index).toBe(1);
  });
});
