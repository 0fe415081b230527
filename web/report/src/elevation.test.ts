import { expect, test } from 'vitest';
import { elevationOf } from './elevation';

const steps = (count: number, length: number) => Array.from({ length: count }, (_, i) => i * length);

test('a ramp of 8 % has that slope all along, whatever its direction', () => {
  const along = steps(101, 1);
  const { chainageM, heightM, slopePercent } = elevationOf({
    x: along.map((s) => 100 - 0.6 * s),
    y: along.map((s) => 0.8 * s),
    z: along.map((s) => 5 + 0.08 * s),
  });
  expect(chainageM.at(-1)).toBeCloseTo(100, 6);
  expect(heightM.at(-1)).toBeCloseTo(8, 6);
  for (const slope of slopePercent) expect(slope).toBeCloseTo(8, 6);
});

test('who stands goes nowhere, and down is negative', () => {
  const x = [
    ...steps(20, 1),
    ...Array.from({ length: 50 }, (_, i) => 19 + 0.1 * (i % 2)),
    ...steps(20, 1).map((s) => 20 + s),
  ];
  const { chainageM, slopePercent } = elevationOf({ x, y: x.map(() => 0), z: x.map((s) => -0.1 * s) });
  expect(chainageM.at(-1)).toBeCloseTo(39, 6);
  expect(Math.min(...slopePercent.map((slope) => slope ?? 0))).toBeCloseTo(-10, 6);
});

test('poses that are far apart, few or none', () => {
  expect(elevationOf({ x: [0, 50, 100], y: [0, 0, 0], z: [0, 5, 0] }).slopePercent).toEqual([10, 0, -10]);
  expect(elevationOf({ x: [0, 1], y: [0, 0], z: [0, 1] }).slopePercent).toEqual([null, null]);
  expect(elevationOf({ x: [], y: [], z: [] }).chainageM).toEqual([]);
});
