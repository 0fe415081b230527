import { describe, expect, test } from 'vitest';
import { encodePoses, madePoses } from '../../test/made_data';
import { decodePoses } from '../src/data/poses';
import { decodeState, defaultState, encodeState } from '../src/view_state';
import { Clock, Timeline } from '../src/playback/clock';

const table = (start_ns: bigint, count = 10) =>
  decodePoses(
    encodePoses(
      madePoses(count).map((pose, i) => ({ ...pose, stamp_ns: start_ns + BigInt(i) * 100_000_000n })),
    ),
  );

describe('timeline', () => {
  test('of one run finds and steps through its scans', () => {
    const line = new Timeline([table(5_000_000_000n)]);
    expect(line.duration_s).toBeCloseTo(0.9);
    expect(line.scanAt(0, 0.35)).toBe(3);
    expect(line.scanAt(0, line.step(0.35, 1))).toBe(4);
    expect(line.scanAt(0, line.step(0.35, -99))).toBe(0);
    expect(line.scanAt(0, line.step(0.35, 99))).toBe(9);
  });

  test('steps through every scan, there and back', () => {
    const line = new Timeline([table(1_700_000_000_123_456_789n, 500)]);
    let time_s = 0;
    for (let scan = 1; scan < 500; ++scan) expect(line.scanAt(0, (time_s = line.step(time_s, 1)))).toBe(scan);
    for (let scan = 498; scan >= 0; --scan)
      expect(line.scanAt(0, (time_s = line.step(time_s, -1)))).toBe(scan);
  });

  test('finds the scan of a time that went through an address', () => {
    const line = new Timeline([table(1_700_000_000_123_456_789n, 5000)]);
    for (let scan = 0; scan < 5000; ++scan) {
      const { time_s } = decodeState(`#${encodeState({ ...defaultState(), time_s: line.timeOf(0, scan) })}`);
      expect(line.scanAt(0, time_s)).toBe(scan);
    }
  });

  test('of runs that overlap is one time', () => {
    const line = new Timeline([table(0n), table(500_000_000n)]);
    expect(line.duration_s).toBeCloseTo(1.4);
    expect([line.scanAt(0, 0.7001), line.scanAt(1, 0.7001)]).toEqual([7, 2]);
  });

  test('of runs at other times lays them over each other', () => {
    const line = new Timeline([table(0n), table(90_000_000_000n)]);
    expect(line.duration_s).toBeCloseTo(0.9);
    expect([line.scanAt(0, 0.35), line.scanAt(1, 0.35)]).toEqual([3, 3]);
  });

  test('of nothing stands', () => {
    const line = new Timeline([decodePoses(encodePoses([]))]);
    expect([line.duration_s, line.scanAt(0, 0), line.step(0, 1)]).toEqual([0, -1, 0]);
  });
});

describe('clock', () => {
  test('runs at its speed, and stops at the end', () => {
    const clock = new Clock(1);
    clock.speed = 2;
    clock.toggle();
    clock.tick(1000, true);
    clock.tick(1100, true);
    expect(clock.time_s).toBeCloseTo(0.2);
    for (let now = 1200; now < 3000; now += 100) clock.tick(now, true);
    expect([clock.time_s, clock.playing]).toEqual([1, false]);
    clock.toggle();
    expect([clock.time_s, clock.playing]).toEqual([0, true]);
  });

  test('stands while a scan is on its way, and does not make up for it', () => {
    const clock = new Clock(10);
    clock.toggle();
    clock.tick(0, true);
    for (let now = 100; now <= 5000; now += 100) expect(clock.tick(now, false)).toBe(false);
    clock.tick(5100, true);
    expect(clock.time_s).toBeCloseTo(0.1);
  });

  test('does not make up for a tab that slept', () => {
    const clock = new Clock(100);
    clock.toggle();
    clock.tick(0, true);
    clock.tick(60_000, true);
    expect(clock.time_s).toBeLessThan(1);
  });
});
