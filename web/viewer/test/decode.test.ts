import { describe, expect, test } from 'vitest';
import { encodeOctree, encodePoints, encodePoses, madePoses, madeScan } from '../../test/made_data';
import { decodeOctree } from '../src/data/octree';
import { decodePoints } from '../src/data/points';
import { decodePoses, hasPose, indexAt } from '../src/data/poses';

/** `buffer` with the u32 at `at` replaced. */
function lie(buffer: ArrayBuffer, at: number, value: number): ArrayBuffer {
  const copy = buffer.slice(0);
  new DataView(copy).setUint32(at, value, true);
  return copy;
}

describe('points', () => {
  const made = madeScan(1, 100);
  const buffer = encodePoints(made, 3);

  test('come out as they went in', () => {
    const points = decodePoints(buffer);
    expect(points.count).toBe(100);
    expect(points.channels).toBe(3);
    expect(points.x[42]).toBeCloseTo(made.x[42]!, 5);
    expect(points.z[99]).toBeCloseTo(made.z[99]!, 5);
    expect([...points.label]).toEqual(made.label);
    expect(points.ring[7]).toBe(1);
  });

  test('are views into the answer, not copies', () => {
    const points = decodePoints(buffer);
    for (const channel of [
      points.x,
      points.y,
      points.z,
      points.intensity,
      points.label,
      points.time,
      points.ring,
    ]) {
      expect(channel.buffer).toBe(buffer);
    }
  });

  test('may be none', () => {
    expect(decodePoints(encodePoints({ x: [], y: [], z: [], label: [] })).count).toBe(0);
  });

  test.each([
    ['one point too many', lie(buffer, 4, 101)],
    ['one too few', lie(buffer, 4, 99)],
    ['as many as 32 bits hold', lie(buffer, 4, 0xffffffff)],
    ['another magic', lie(buffer, 0, 0x4d524221)],
    ['nothing at all', new ArrayBuffer(0)],
    ['half a header', buffer.slice(0, 15)],
    ['a byte missing', buffer.slice(0, -1)],
    [
      'a byte too many',
      (() => {
        const longer = new Uint8Array(buffer.byteLength + 1);
        longer.set(new Uint8Array(buffer));
        return longer.buffer;
      })(),
    ],
  ])('with %s are refused', (_, bytes) => {
    expect(() => decodePoints(bytes)).toThrow(/^points: /);
  });
});

describe('poses', () => {
  const made = madePoses(5);
  const buffer = encodePoses(made);

  test('come out as they went in, at places that no float array could be laid over', () => {
    const table = decodePoses(buffer);
    expect(table.count).toBe(5);
    expect(table.startNs).toBe(made[0]!.stamp_ns);
    expect(table.time_s[4]).toBeCloseTo(0.4, 9);
    expect(table.pose[7 * 3]).toBeCloseTo(1.5);
    expect(table.points[2]).toBe(6000);
    expect(table.health[0]).toBe(1);
  });

  test('may be unknown', () => {
    const table = decodePoses(encodePoses([{ ...made[0]!, pose: Array(7).fill(NaN) }, made[1]!]));
    expect(hasPose(table, 0)).toBe(false);
    expect(hasPose(table, 1)).toBe(true);
    expect(hasPose(table, 2)).toBe(false);
    expect(hasPose(table, -1)).toBe(false);
  });

  test.each([0, 4, 6, 0xffffffff])('of which %i are announced and 5 are there are refused', (count) => {
    expect(() => decodePoses(lie(buffer, 0, count))).toThrow(/announced/);
  });

  test('cut anywhere are refused', () => {
    for (let length = 0; length < buffer.byteLength; ++length) {
      expect(() => decodePoses(buffer.slice(0, length))).toThrow(/^poses: /);
    }
  });

  test('with stamps that run backwards are refused', () => {
    expect(() => decodePoses(encodePoses([made[1]!, made[0]!]))).toThrow(/stamp 1/);
  });

  test('are found by time', () => {
    const table = decodePoses(buffer);
    expect([-1, 0, 0.05, 0.1, 0.3999, 9].map((time_s) => indexAt(table, time_s))).toEqual([0, 0, 0, 1, 3, 4]);
    expect(indexAt(decodePoses(encodePoses([])), 0)).toBe(-1);
  });
});

describe('octree', () => {
  const buffer = encodeOctree([{ x: 1, y: 2, z: 3, size: 0.5, side: 1, p: 255 }]);

  test('comes out as it went in', () => {
    expect(decodeOctree(buffer)).toEqual([{ x: 1, y: 2, z: 3, size_m: 0.5, side: 'right', probability: 1 }]);
  });

  test('with a wrong count is refused', () => {
    expect(() => decodeOctree(lie(buffer, 0, 2))).toThrow(/announced/);
    expect(() => decodeOctree(new ArrayBuffer(3))).toThrow(/count/);
  });
});
