import { describe, expect, it } from 'vitest';
import { at, before, everyNth, num, readReport, spread, stack, stretches, text, type Table } from './data';

const table = (x: number[], columns: Table['columns']): Table => ({
  rows: x.length,
  rowsPerValue: 1,
  x,
  columns,
});
const wrap = (parts: object) => JSON.stringify({ schema: 'berm.report/1', run: {}, trouble: [], ...parts });

describe('readReport', () => {
  it('leaves out what is not there', () => {
    const report = readReport(wrap({}));
    for (const part of [
      'scans',
      'times',
      'histograms',
      'road',
      'odometry',
      'trajectory',
      'globalTrajectory',
    ]) {
      expect(report, part).not.toHaveProperty(part);
    }
    expect(report.edges).toEqual([]);
    expect(report.evaluation).toBeNull();
  });

  it('takes tables, paths and edges', () => {
    const report = readReport(
      wrap({
        scans: { rows: 7, rows_per_value: 2, x: [0, 1], columns: { slope_deg: [null, -2], short: [1] } },
        times: {
          x: [0],
          columns: { read_ms: [1] },
          histogram: { first_ms: 0.001, bins_per_decade: 10, scans: { read_ms: [0, 3] } },
        },
        trajectory: { poses: 9, path_m: 5, t_s: [0, 1], x_m: [0, 3], y_m: [0, 4], z_m: [0, 0] },
        edges: [{ side: 'left', x_m: [0, 1], y_m: [2, 2], z_m: [0, 0] }],
      }),
    );
    expect(report.scans).toEqual({ rows: 7, rowsPerValue: 2, x: [0, 1], columns: { slope_deg: [null, -2] } });
    expect(report.histograms?.scans).toEqual({ read_ms: [0, 3] });
    expect(report.trajectory?.lengthM).toBe(5);
    expect(report.edges[0]).toEqual({ side: 'left', x: [0, 1], y: [2, 2] });
  });

  it('leaves out a table of nothing and a path that does not fit together', () => {
    const report = readReport(
      wrap({
        scans: { rows: 0, x: [], columns: { slope_deg: [] } },
        trajectory: { t_s: [0, 1], x_m: [0], y_m: [0, 1], z_m: [0, 1] },
      }),
    );
    expect(report).not.toHaveProperty('scans');
    expect(report).not.toHaveProperty('trajectory');
  });

  it('says what is wrong', () => {
    expect(() => readReport('null')).toThrow('no run yet');
    expect(() => readReport('{"schema": "berm.report/2"}')).toThrow('another version');
    expect(() => readReport('{')).toThrow(SyntaxError);
  });
});

describe('access by keys', () => {
  const json = { a: { b: [1, 'two'] }, constructor: 5 };
  it('never throws and never finds what is inherited', () => {
    expect(at(json, 'a', 'b', 1)).toBe('two');
    expect(at(json, 'a', 'b', 9)).toBeNull();
    expect(at(json, 'a', 'toString')).toBeNull();
    expect(at(undefined, 'a')).toBeNull();
    expect(num(json, ['a', 'b', 0])).toBe(1);
    expect(num(json, ['a', 'b', 1], 7)).toBe(7);
    expect(text(json, 'a', 'b', 1)).toBe('two');
    expect(text(json, 'a')).toBe('');
  });
});

describe('columns', () => {
  it('gives the stretches of a value', () => {
    const road = table([0, 1, 2, 3, 4], { width_rule: [2, 2, null, 2, 0] });
    expect(stretches(road, 'width_rule', 2)).toEqual([
      [0, 1],
      [3, 3],
    ]);
    expect(stretches(road, 'grade_rule', 2)).toEqual([]);
  });

  it('knows what was before', () => {
    const odometry = table([0, 1, 2], { health: [0, 3, 1] });
    expect([-1, 0, 0.9, 1, 5].map((x) => before(odometry, 'health', x))).toEqual([null, 0, 0, 3, 1]);
    expect(before(undefined, 'health', 1)).toBeNull();
  });

  it('gives extremes and median of what is known', () => {
    expect(spread([null, 3, 1, 2, null])).toEqual({ low: 1, median: 2, high: 3 });
    expect(spread([null])).toBeNull();
  });

  it('takes rows evenly, with the first and the last', () => {
    expect(everyNth(3, 5)).toEqual([0, 1, 2]);
    const taken = everyNth(1001, 11);
    expect(taken).toEqual([0, 100, 200, 300, 400, 500, 600, 700, 800, 900, 1000]);
  });

  it('stacks areas on each other', () => {
    expect(
      stack([
        [1, null, 2],
        [10, 20, null],
      ]),
    ).toEqual([
      [1, null, 2],
      [11, 20, null],
    ]);
  });
});
