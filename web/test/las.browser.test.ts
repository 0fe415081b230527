import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Las } from 'copc';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { findBerm, runBerm } from './berm_program';

// LAS files of `berm export`, opened by copc.js, a reader of LAS, LAZ and COPC. What is right is taken from the CSV
// file of the same run, and its labels from labels/*.label.

const berm = findBerm();
if (berm === undefined) console.warn('No berm was built ($BERM_PROGRAM): its LAS files are not read back');

/** docs/export.md: SemanticKITTI id of a label -> class, label of berm. */
const kClasses: Readonly<Record<number, readonly [number, number]>> = {
  0: [1, 0],
  110: [18, 2],
  40: [11, 3],
  72: [2, 4],
  99: [64, 5],
};
const kAxes = [
  ['X', 0],
  ['Y', 1],
  ['Z', 2],
] as const;

const folder = mkdtempSync(join(tmpdir(), 'berm-las-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

describe.skipIf(berm === undefined)('berm export --to las, read by copc.js', () => {
  let header: Las.Header;
  let points: ReturnType<typeof Las.View.create>;
  let rows: number[][] = [];
  let bytes: Uint8Array;
  const column = (k: number) => rows.map((row) => row[k]!);
  const all = (dimension: string) => {
    const get = points.getter(dimension);
    return Array.from({ length: points.pointCount }, (_, i) => get(i));
  };

  beforeAll(() => {
    const [recording, run] = [join(folder, 'recording'), join(folder, 'run')];
    runBerm(berm!, ['sim', 'groomer_snowfall', '--seconds', '0.5', '-o', recording, '-q']);
    runBerm(berm!, ['run', recording, '--machine', 'groomer', '-o', run, '-q']);
    for (const format of ['las', 'csv'])
      execFileSync(berm!, ['export', run, '--to', format, '-o', join(folder, `run.${format}`), '-q']);
    bytes = readFileSync(join(folder, 'run.las'));
    header = Las.Header.parse(bytes);
    points = Las.View.create(bytes.subarray(header.pointDataOffset), header);
    rows = readFileSync(join(folder, 'run.csv'), 'utf8')
      .trimEnd()
      .split('\n')
      .slice(1)
      .map((line) => line.split(',').map(Number));
  });

  test('its head says what follows', () => {
    expect([header.majorVersion, header.minorVersion, header.pointDataRecordFormat]).toEqual([1, 4, 7]);
    expect([header.headerLength, header.vlrCount, header.evlrCount]).toEqual([375, 0, 0]);
    expect(header.generatingSoftware).toMatch(/^berm \d/);
    expect(header.globalEncoding & 16).toBe(16); // point formats from 6 on ask for it
    expect(rows.length).toBeGreaterThan(10_000);
    expect(header.pointCount).toBe(rows.length);
    expect(points.pointCount).toBe(rows.length);
    expect(header.pointCountByReturn).toEqual([rows.length, ...Array<number>(14).fill(0)]);
    expect(bytes.length).toBe(header.pointDataOffset + rows.length * header.pointDataRecordLength);
  });

  test('points are where they are, to the millimetre, and its bounds are theirs', () => {
    expect(header.scale).toEqual([0.001, 0.001, 0.001]);
    for (const [dimension, axis] of kAxes) {
      const [read_m, expected_m] = [all(dimension), column(axis)];
      let [worst_m, low_m, high_m] = [0, Infinity, -Infinity];
      read_m.forEach((value_m, i) => {
        worst_m = Math.max(worst_m, Math.abs(value_m - expected_m[i]!));
        low_m = Math.min(low_m, value_m);
        high_m = Math.max(high_m, value_m);
      });
      expect(worst_m).toBeLessThan(0.00101);
      expect(header.min[axis]).toBeCloseTo(low_m, 6);
      expect(header.max[axis]).toBeCloseTo(high_m, 6);
      expect(header.offset[axis]).toBeGreaterThan(low_m - 1);
      expect(header.offset[axis]).toBeLessThan(high_m + 1);
    }
  });

  test('labels are classes, as the page on export says', () => {
    const labels = column(4);
    expect(new Set(labels)).toEqual(new Set([110, 40, 72, 99]));
    expect(all('Classification')).toEqual(labels.map((id) => kClasses[id]![0]));
    expect(all('UserData')).toEqual(labels.map((id) => kClasses[id]![1]));
  });

  test('intensity fills 16 bits, times are those of the recording, every label has its colour', () => {
    const [intensity, expected] = [all('Intensity'), column(3)];
    const wrong = intensity.filter((value, i) => Math.abs(value / 257 - expected[i]!) > 0.51);
    expect(wrong).toEqual([]);
    expect(Math.max(...expected)).toBeGreaterThan(10);
    const times_s = column(5);
    all('GpsTime').forEach((time_s, i) => {
      if (Math.abs(time_s - times_s[i]!) > 1e-5) throw new Error(`point ${i}: ${time_s} for ${times_s[i]} s`);
    });
    const colours = new Map<number, Set<string>>();
    const [red, green, blue] = [all('Red'), all('Green'), all('Blue')];
    column(4).forEach((label, i) => {
      const seen = colours.get(label) ?? new Set();
      colours.set(label, seen.add(`${red[i]},${green[i]},${blue[i]}`));
    });
    expect([...colours.values()].every((seen) => seen.size === 1)).toBe(true);
    expect(new Set([...colours.values()].flatMap((seen) => [...seen])).size).toBe(colours.size);
  });

  test('every point is the first return of one', () => {
    expect(new Set(all('ReturnNumber'))).toEqual(new Set([1]));
    expect(new Set(all('NumberOfReturns'))).toEqual(new Set([1]));
  });

  test('a recording without labels is unclassified', () => {
    const recording = join(folder, 'recording');
    rmSync(join(recording, 'labels'), { recursive: true });
    const file = join(folder, 'recording.las');
    execFileSync(berm!, ['export', recording, '--to', 'las', '--every', '5', '-o', file, '-q']);
    const content = readFileSync(file);
    const head = Las.Header.parse(content);
    const view = Las.View.create(content.subarray(head.pointDataOffset), head);
    const classes = view.getter('Classification');
    expect(view.pointCount).toBeGreaterThan(1000);
    for (let i = 0; i < view.pointCount; ++i) if (classes(i) !== 1) throw new Error(`point ${i}`);
  });
});
