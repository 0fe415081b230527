import { at, entries, list, num, text, type Report } from './data';
import { count, duration, fixed, kGap, large, length, percent, rounded, words } from './format';

/** Something that speaks against a run, or that one should know of it. */
export interface Warning {
  level: 'bad' | 'note';
  title: string;
  details: string[];
}

const kDegraded: Readonly<Record<string, string>> = {
  no_points: 'the scan is empty',
  few_returns: 'fewer than 100 returns, or fewer than 2 % of the beams',
  no_ground: 'not one point is ground',
  invalid_points: 'more than 1 % of the points are NaN or absurdly far',
  no_intensity: 'no intensities: flakes are told from shape alone',
  no_returns_dropped: 'not one beam without a return: the driver may have left them out',
  no_time: 'no times of points',
  no_firing_order: 'points are not in the order in which they were measured',
  snow_hides_the_scene: 'more flakes than all other returns',
  mount_implausible: 'the mount contradicts the ground around the machine',
};
/** Kinds that say what the sensor or driver leaves out, rather than that something went wrong. */
const kMild = new Set(['no_intensity', 'no_returns_dropped', 'no_time', 'no_firing_order']);

const kRules: readonly (readonly [key: string, name: string])[] = [
  ['width_rule', 'width'],
  ['grade_rule', 'grade'],
  ['left_berm_rule', 'left berm'],
  ['right_berm_rule', 'right berm'],
];

export const recordingName = (report: Report): string => {
  const path = text(report.run, 'recording', 'path');
  return path.replace(/\/+$/, '').split('/').pop() || path || 'a recording';
};

const machineName = (report: Report): string => text(report.run, 'machine', 'machine', 'name');
const scansOf = (report: Report, key: string): number => num(report.run, ['counts', 'scans', key]);
const pointsOf = (report: Report, key: string): number => num(report.run, ['counts', 'points', key]);

/** Seconds from the first scan to the last. */
export const spanOf = (report: Report): number =>
  report.scans?.x.at(-1) ?? report.trajectory?.timeS.at(-1) ?? 0;

/** Processor time of a scan, all stages together, ms. */
export const workOf = (report: Report): number =>
  entries(report.run, 'stages').reduce((sum, [, stage]) => sum + num(stage, ['cpu_mean_ms']), 0);

export const periodOf = (report: Report): number => {
  const rate = num(report.run, ['machine', 'sensor', 'scan_hz']);
  return rate > 0 ? 1000 / rate : 0;
};

/** Whether z points up: the world of the odometry is tilted as the machine was at its begin. */
export const isLevel = (report: Report): boolean =>
  report.globalTrajectory !== undefined || report.odometry === undefined;

export interface Rule {
  name: string;
  key: string;
  holds: number;
  uncertain: number;
  broken: number;
  unknown: number;
}

export function rulesOf(report: Report): Rule[] {
  const road = at(report.run, 'edges', 'road');
  return kRules
    .filter(([key]) => entries(road, key).length > 0)
    .map(([key, name]) => ({
      key,
      name,
      holds: num(road, [key, 'holds']),
      uncertain: num(road, [key, 'uncertain']),
      broken: num(road, [key, 'broken']),
      unknown: num(road, [key, 'unknown']),
    }));
}

/** Limits of the machine's section `road`. */
export function limitsOf(report: Report): { widthM: number; bermM: number; gradePercent: number } {
  const road = at(report.run, 'machine', 'road');
  return {
    widthM: num(road, ['vehicle_width_m']) * num(road, ['min_width_vehicles']),
    bermM: num(road, ['tyre_height_m']) * num(road, ['min_berm_tyres']),
    gradePercent: num(road, ['max_grade_percent']),
  };
}

function losses(report: Report): Warning[] {
  const found: Warning[] = [];
  const skipped = scansOf(report, 'skipped');
  if (skipped > 0) {
    const reasons = list(report.run, 'skipped').map(
      (scan) => `${text(scan, 'scan')}: ${text(scan, 'reason')}`,
    );
    const shown = reasons.slice(0, 10);
    if (skipped > shown.length)
      shown.push(`and ${count(skipped - shown.length, 'more', 'more')}, see run.json`);
    found.push({
      level: 'bad',
      title: `${fixed(skipped)} of ${count(scansOf(report, 'selected'), 'scan')} could not be read and were skipped`,
      details: shown,
    });
  }
  const invalid = pointsOf(report, 'invalid');
  if (invalid > 0) {
    found.push({
      level: invalid > 0.01 * pointsOf(report, 'total') ? 'bad' : 'note',
      title: `${count(invalid, 'point')} (${percent(invalid / pointsOf(report, 'total'), 2)}) are NaN or absurdly far`,
      details: [],
    });
  }
  for (const [kind, scans] of entries(report.run, 'counts', 'degraded')) {
    found.push({
      level: kMild.has(kind) ? 'note' : 'bad',
      title: `${fixed(Number(scans))} of ${count(scansOf(report, 'labelled'), 'scan')}: ${kDegraded[kind] ?? words(kind)}`,
      details: [],
    });
  }
  return found;
}

function poses(report: Report): Warning[] {
  const found: Warning[] = [];
  const jumps = num(report.run, ['poses', 'jumps']);
  if (jumps > 0) found.push({ level: 'bad', title: `The pose jumps ${count(jumps, 'time')}`, details: [] });
  const untrusted = entries(report.run, 'poses', 'distrusted_s').map(
    ([reason, seconds]) => `${words(reason)}: ${rounded(Number(seconds))} s`,
  );
  if (untrusted.length > 0) {
    found.push({ level: 'bad', title: 'Poses are not trusted for part of the time', details: untrusted });
  }
  const without = scansOf(report, 'without_pose');
  if (without > 0)
    found.push({ level: 'bad', title: `${count(without, 'scan')} without a pose`, details: [] });
  const log = entries(report.run, 'poses', 'log').filter(([key, n]) => key !== 'records' && Number(n) > 0);
  if (log.length > 0) {
    found.push({
      level: 'note',
      title: `Records of the pose log were left out, of ${fixed(num(report.run, ['poses', 'log', 'records']))}`,
      details: log.map(([key, n]) => `${words(key)}: ${fixed(Number(n))}`),
    });
  }
  for (const map of ['edges', 'surface']) {
    const missing = entries(report.run, map, 'scans_not_mapped').map(
      ([why, n]) => `${words(why)}: ${fixed(Number(n))}`,
    );
    if (missing.length > 0) {
      found.push({ level: 'bad', title: `Scans are missing in the map of the ${map}`, details: missing });
    }
  }
  return found;
}

function mount(report: Report): Warning[] {
  if (text(report.run, 'mount', 'verdict') !== 'implausible') return [];
  const seen = at(report.run, 'mount');
  return [
    {
      level: 'bad',
      title: `The mount looks wrong: the ground lies tilted by ${rounded(num(seen, ['ground_tilt_deg']))}° against it`,
      details: [
        `seen: pitch ${rounded(num(seen, ['pitch_off_deg']))}°, roll ${rounded(num(seen, ['roll_off_deg']))}°, ` +
          `${rounded(num(seen, ['height_m']))} m above the ground`,
      ],
    },
  ];
}

function rules(report: Report): Warning[] {
  const broken = rulesOf(report).filter((rule) => rule.broken > 0);
  if (broken.length === 0) return [];
  const details = broken.map((rule) => {
    const all = rule.holds + rule.uncertain + rule.broken + rule.unknown;
    return `${rule.name}: at ${fixed(rule.broken)} of ${count(all, 'station')}, ${percent(rule.broken / all, 0)}`;
  });
  return [{ level: 'bad', title: 'Rules of the road are broken, by two standard deviations', details }];
}

function odometry(report: Report): Warning[] {
  const scans = num(report.run, ['odometry', 'scans']);
  const lost = num(report.run, ['odometry', 'health', 'lost']);
  const weak = num(report.run, ['odometry', 'health', 'weak']);
  const found: Warning[] = [];
  if (lost > 0) {
    found.push({
      level: 'bad',
      title: `The odometry was lost for ${fixed(lost)} of ${count(scans, 'scan')}: their poses are guessed`,
      details: [],
    });
  }
  if (weak > 0) {
    const title = `In ${fixed(weak)} of ${count(scans, 'scan')} the surroundings fix the odometry weakly`;
    found.push({
      level: 'note',
      title: `${title}: in some direction the motion before decides`,
      details: [],
    });
  }
  return found;
}

function speed(report: Report): Warning[] {
  const period = periodOf(report);
  if (period === 0 || workOf(report) <= period) return [];
  return [
    {
      level: 'bad',
      title: `A scan takes ${rounded(workOf(report))} ms, and the next comes after ${rounded(period)} ms`,
      details: [],
    },
  ];
}

/** What speaks against the run, the worst first. */
export function warningsOf(report: Report): Warning[] {
  const all: Warning[] = [
    ...report.trouble.map((problem) => ({ level: 'bad' as const, title: problem, details: [] })),
    ...losses(report),
    ...mount(report),
    ...poses(report),
    ...odometry(report),
    ...rules(report),
    ...speed(report),
    ...list(report.run, 'notes').map((note) => ({
      level: 'note' as const,
      title: String(note),
      details: [],
    })),
    ...list(report.evaluation, 'failed').map((scan) => ({
      level: 'bad' as const,
      title: `${text(scan, 'scan')} could not be judged: ${text(scan, 'reason')}`,
      details: [],
    })),
  ];
  return [...all.filter((w) => w.level === 'bad'), ...all.filter((w) => w.level === 'note')];
}

function whatWasDone(report: Report): string {
  const scans = scansOf(report, 'labelled');
  const total = pointsOf(report, 'total');
  const shares = ['drivable', 'terrain', 'obstacle', 'falling_snow', 'no_return']
    .map((key) => [key, pointsOf(report, key)] as const)
    .filter(([, points]) => points > 0)
    .map(([key, points]) => `${percent(points / total)} ${words(key)}`);
  const span = spanOf(report);
  return (
    `${count(scans, 'scan')}${span > 0 ? ` over ${duration(span)}` : ''} with ${large(total)} points were labelled` +
    `${shares.length > 0 ? `: ${shares.join(', ')}` : ''}.`
  );
}

function howFar(report: Report): string[] {
  const path = report.globalTrajectory ?? report.trajectory;
  if (!path) return [];
  if (!isLevel(report)) return [`The machine drove ${length(path.lengthM)}.`];
  const climb = Math.max(...path.z) - Math.min(...path.z);
  return [`The machine drove ${length(path.lengthM)}, over ${length(climb)} of height.`];
}

function howFast(report: Report): string[] {
  const work = workOf(report);
  if (work === 0) return [];
  const period = periodOf(report);
  const times = period > 0 ? `; the sensor gives ${rounded(period)} ms` : '';
  const memory = num(report.run, ['peak_memory_mib']);
  return [
    `A scan took ${rounded(work)} ms of one core on average${times}. ` +
      `The run took ${duration(num(report.run, ['wall_s']))} with ${count(num(report.run, ['threads'], 1), 'thread')}` +
      `${memory > 0 ? ` and at most ${fixed(memory)} MiB of memory` : ''}.`,
  ];
}

function whatRoad(report: Report): string[] {
  const edges = at(report.run, 'edges');
  const said: string[] = [];
  if (at(edges, 'left') !== null) {
    said.push(
      `Road edges were mapped along ${length(1000 * num(edges, ['left', 'km']))} on the left and ` +
        `${length(1000 * num(edges, ['right', 'km']))} on the right.`,
    );
  }
  const rules = rulesOf(report);
  if (rules.length > 0) {
    const held = rules.map((rule) => {
      const judged = rule.holds + rule.uncertain + rule.broken;
      return `${rule.name} ${judged > 0 ? percent(rule.holds / judged, 0) : 'not measured'}`;
    });
    said.push(`Share of the measured road where the rules surely hold: ${held.join(', ')}.`);
  }
  return said;
}

function whatSurface(report: Report): string[] {
  const surface = at(report.run, 'surface');
  if (surface === null) return [];
  const depth = at(surface, 'snow_depth', 'median_m');
  const snow =
    typeof depth === 'number' ? ` The median depth of the snow is ${fixed(depth, 2)}${kGap}m.` : '';
  return [
    `The map of the surface has ${large(num(surface, ['voxels']))} points in ${count(num(surface, ['tiles']), 'tile')}.${snow}`,
  ];
}

function howGood(report: Report): string[] {
  const figures: string[] = [];
  for (const key of ['ground', 'piste', 'snow', 'edges']) {
    const f1 = at(report.evaluation, key, 'f1');
    if (typeof f1 === 'number') figures.push(`${key} F1 ${percent(f1)}`);
  }
  const ate = at(report.evaluation, 'trajectory', 'ate_rmse_m');
  if (typeof ate === 'number') figures.push(`trajectory off by ${rounded(100 * ate)} cm (RMS)`);
  return figures.length > 0 ? [`Measured against the truth of the recording: ${figures.join(', ')}.`] : [];
}

/** The run in a few sentences. */
export function summaryOf(report: Report): string[] {
  const machine = machineName(report);
  const model = text(report.run, 'machine', 'sensor', 'model');
  return [
    `“${recordingName(report)}”${machine ? `, taken as machine “${machine}”${model ? ` with a ${model}` : ''}` : ''}. ` +
      whatWasDone(report),
    ...howFar(report),
    ...whatRoad(report),
    ...whatSurface(report),
    ...howFast(report),
    ...howGood(report),
  ];
}
