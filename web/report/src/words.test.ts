import { describe, expect, it } from 'vitest';
import { readReport, type Json } from './data';
import { duration, fixed, large, percent, rounded } from './format';
import { recordingName, summaryOf, warningsOf } from './words';

const kRun = {
  schema: 'berm.run/2',
  state: 'whole',
  recording: { path: '/data/<b>drive</b>/' },
  machine: {
    machine: { name: 'haul_truck' },
    sensor: { model: '16-ring LiDAR', scan_hz: 10 },
    road: {
      vehicle_width_m: 6.5,
      min_width_vehicles: 3.5,
      tyre_height_m: 2.7,
      min_berm_tyres: 0.5,
      max_grade_percent: 10,
    },
  },
  counts: {
    scans: { selected: 4, labelled: 4, skipped: 0, without_pose: 0 },
    points: { total: 1000, drivable: 400, obstacle: 600, invalid: 0 },
    degraded: {},
  },
  stages: { read: { cpu_mean_ms: 1.5 }, ground: { cpu_mean_ms: 2.5 } },
  threads: 1,
  wall_s: 2,
  notes: [],
};

const report = (change: object, parts: object = {}) =>
  readReport(JSON.stringify({ schema: 'berm.report/1', run: { ...kRun, ...change }, trouble: [], ...parts }));
const bad = (change: object, parts: object = {}) =>
  warningsOf(report(change, parts))
    .filter((warning) => warning.level === 'bad')
    .map((warning) => [warning.title, ...warning.details].join(' | '));

describe('warnings', () => {
  it('has none for a run without losses', () => {
    expect(warningsOf(report({}))).toEqual([]);
    expect(warningsOf(readReport('{"schema": "berm.report/1"}'))).toEqual([]);
  });

  it('names scans that were skipped, with reasons', () => {
    const scans = { selected: 40, labelled: 20, skipped: 20, without_pose: 3 };
    const skipped = Array.from({ length: 20 }, (_, i) => ({ scan: `00${i}`, reason: 'too short' }));
    const found = bad({ counts: { ...kRun.counts, scans }, skipped });
    expect(found[0]).toContain('20 of 40 scans');
    expect(found[0]).toContain('000: too short');
    expect(found[0]).toContain('and 10 more');
    expect(found[1]).toContain('3 scans without a pose');
  });

  it('tells bad points by their share', () => {
    const points = (invalid: number) => ({ counts: { ...kRun.counts, points: { total: 1000, invalid } } });
    expect(bad(points(5))).toEqual([]);
    expect(warningsOf(report(points(5)))[0]?.level).toBe('note');
    expect(bad(points(50))[0]).toContain('50 points');
  });

  it('tells what a scan lacked from what the sensor leaves out', () => {
    const degraded = { no_time: 4, no_ground: 1 };
    expect(bad({ counts: { ...kRun.counts, degraded } })).toEqual(['1 of 4 scans: not one point is ground']);
  });

  it('names jumps, untrusted poses, a wrong mount, lost odometry and slowness', () => {
    expect(bad({ poses: { jumps: 2, distrusted_s: { gap: 1.5 } } })[0]).toBe('The pose jumps 2 times');
    expect(bad({ poses: { jumps: 0, distrusted_s: { gap: 1.5 } } })[0]).toContain('gap: 1.50 s');
    expect(bad({ mount: { verdict: 'implausible', ground_tilt_deg: 34 } })[0]).toContain('34.0°');
    expect(bad({ odometry: { scans: 9, health: { lost: 2 } } })[0]).toContain('2 of 9 scans');
    expect(bad({ stages: { read: { cpu_mean_ms: 120 } } })[0]).toContain('120 ms');
  });

  it('names rules that are broken', () => {
    const road = { stations: 8, width_rule: { holds: 5, broken: 3 }, grade_rule: { holds: 8 } };
    const found = bad({ edges: { road } });
    expect(found).toHaveLength(1);
    expect(found[0]).toContain('width: at 3 of 8 stations');
    expect(found[0]).not.toContain('grade');
  });

  it('puts what is bad before notes', () => {
    const found = warningsOf(report({ notes: ['a note'] }, { trouble: ['scans.csv: line 3'] }));
    expect(found.map((warning) => warning.level)).toEqual(['bad', 'note']);
  });
});

describe('summary', () => {
  it('leaves out what is not known', () => {
    const said = summaryOf(report({})).join(' ');
    expect(said).toContain(
      '4 scans with 1,000 points were labelled: 40.0\u00a0% drivable, 60.0\u00a0% obstacle.',
    );
    expect(said).toContain('4.00 ms of one core');
    expect(said).not.toMatch(/drove|edges|truth|NaN|undefined/);
  });

  it('tells path, road and truth when they are there', () => {
    const evaluation = { ground: { f1: 0.5 }, trajectory: { ate_rmse_m: 0.02 } };
    const trajectory = { poses: 2, path_m: 1500, t_s: [0, 10], x_m: [0, 1], y_m: [0, 1], z_m: [0, 20] };
    const edges = {
      left: { km: 0.3 },
      right: { km: 0.2 },
      road: { width_rule: { holds: 1, broken: 1, unknown: 2 } },
    };
    const said = summaryOf(report({ edges }, { evaluation, trajectory } as Record<string, Json>)).join(' ');
    expect(said).toContain('drove 1.50\u00a0km, over 20\u00a0m');
    expect(said).toContain('300\u00a0m on the left');
    expect(said).toContain('width 50\u00a0%');
    expect(said).toContain('ground F1 50.0\u00a0%');
    expect(said).toContain('2.00 cm');
  });

  it('does not take the tilted world of the odometry for height', () => {
    const trajectory = { poses: 2, path_m: 50, t_s: [0, 10], x_m: [0, 1], y_m: [0, 1], z_m: [0, 20] };
    const odometry = { rows: 2, x: [0, 10], columns: { health: [0, 0] } };
    expect(summaryOf(report({}, { trajectory })).join(' ')).toContain('of height');
    expect(summaryOf(report({}, { trajectory, odometry })).join(' ')).not.toContain('of height');
  });

  it('tells the map of the surface', () => {
    const surface = { voxels: 2_500_000, tiles: 4, snow_depth: { cells: 9, median_m: 0.873 } };
    const said = summaryOf(report({ surface })).join(' ');
    expect(said).toContain(
      '2.5\u00a0million points in 4 tiles. The median depth of the snow is 0.87\u00a0m.',
    );
    expect(bad({ surface: { scans_not_mapped: { gap: 3 } } })[0]).toContain('map of the surface | gap: 3');
  });

  it('takes the name of the recording as it is', () => {
    expect(recordingName(report({}))).toBe('b>'); // of '/data/<b>drive</b>/'
    expect(recordingName(report({ recording: { path: 'a/<i>x' } }))).toBe('<i>x');
  });
});

describe('numbers', () => {
  it('are written so that people can read them', () => {
    expect(fixed(-0.0001, 2)).toBe('0.00');
    expect(fixed(-1234.5, 1)).toBe('−1,234.5');
    expect(fixed(null)).toBe('–');
    expect(rounded(0.12345)).toBe('0.123');
    expect(rounded(123.4)).toBe('123');
    expect(percent(0.1234)).toBe('12.3\u00a0%');
    expect(large(6_933_305)).toBe('6.9\u00a0million');
    expect(duration(5.25)).toBe('5.3\u00a0s');
    expect(duration(36_000)).toBe('10\u00a0h 00\u00a0min');
  });
});
