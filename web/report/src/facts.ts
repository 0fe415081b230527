import { at, entries, isObject, list, num, text, type Json, type Report } from './data';
import { h } from './dom';
import { fixed, percent, rounded, words } from './format';
import { folded, scrolled, table } from './tables';

function plain(json: Json): string {
  if (json === null) return '–';
  if (typeof json === 'boolean') return json ? 'yes' : 'no';
  if (typeof json === 'number') return String(json);
  return typeof json === 'string' ? json : JSON.stringify(json);
}

function facts(pairs: readonly (readonly [string, string])[]): HTMLElement {
  const told = pairs.filter(([, value]) => value !== '');
  return h('dl', {}, ...told.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
}

/** What run.json says a stage took. */
export function stageTable(report: Report): HTMLElement[] {
  const stages = entries(report.run, 'stages');
  if (stages.length === 0) return [];
  const keys = ['cpu_mean_ms', 'p50_ms', 'p95_ms', 'p99_ms', 'max_ms'];
  const rows = stages.map(([name, stage]) => [
    words(name),
    ...keys.map((key) => rounded(num(stage, [key], NaN))),
  ]);
  const sum = stages.reduce((total, [, stage]) => total + num(stage, ['cpu_mean_ms']), 0);
  rows.push(['all', rounded(sum), '', '', '', '']);
  const title = 'Milliseconds a scan: work of the processor, then by the clock';
  return [
    h(
      'div',
      { class: 'block' },
      scrolled(title, table(title, ['stage', 'work, mean', 'median', '95 %', '99 %', 'most'], rows, false)),
    ),
  ];
}

export function countTable(report: Report): HTMLElement[] {
  const scans = entries(report.run, 'counts', 'scans').map(([name, n]) => [
    `scans ${words(name)}`,
    fixed(Number(n)),
    '',
  ]);
  const total = num(report.run, ['counts', 'points', 'total']);
  const points = entries(report.run, 'counts', 'points').map(([name, n]) => [
    name === 'total' ? 'points' : words(name),
    fixed(Number(n)),
    total > 0 ? percent(Number(n) / total, 2) : '',
  ]);
  const lines: string[][] = [...scans, ...points];
  if (lines.length === 0) return [];
  return [
    h(
      'div',
      { class: 'block' },
      scrolled('Counts', table('Counts and losses', ['', 'number', 'share'], lines, false)),
    ),
  ];
}

export function machineFacts(report: Report): HTMLElement[] {
  const { run } = report;
  const machine = at(run, 'machine');
  const datum = at(run, 'poses', 'datum');
  const methods = entries(machine, 'methods').map(([stage, method]) => `${stage}: ${plain(method)}`);
  const files = entries(run, 'files').map(([, name]) => plain(name));
  const mount = entries(machine, 'mount').map(([key, value]) => `${key} ${plain(value)}`);
  return [
    facts([
      ['Recording', text(run, 'recording', 'path')],
      ['Layout', text(run, 'recording', 'layout')],
      ['Stamps from', text(run, 'recording', 'stamps')],
      ['Poses from', text(run, 'poses', 'file')],
      [
        'Datum',
        datum === null
          ? ''
          : `${num(datum, ['lat_deg'])}°, ${num(datum, ['lon_deg'])}°, ${num(datum, ['h_m'])} m`,
      ],
      [
        'Machine',
        [text(machine, 'machine', 'name'), text(machine, 'machine', 'description')]
          .filter(Boolean)
          .join(': '),
      ],
      ['Machine file', text(run, 'machine_file')],
      ['Sensor', `${text(machine, 'sensor', 'model')}, ${num(machine, ['sensor', 'scan_hz'])} Hz`],
      ['Mount', mount.join(', ')],
      ['Mount check', words(text(run, 'mount', 'verdict'))],
      ['Methods', methods.join(', ')],
      ['Files', files.join(', ')],
      ['Program', `berm ${text(run, 'version')}`],
    ]),
    folded('All settings of the machine', () => {
      const rows = entries(machine).flatMap(([section, values]) =>
        isObject(values)
          ? Object.entries(values).map(([key, value]) => [`${section}.${key}`, plain(value)])
          : [],
      );
      return scrolled('Settings', table('Settings', ['key', 'value'], rows), true);
    }),
  ];
}

const kShares: Readonly<Record<string, string>> = {
  accuracy: 'accuracy',
  precision: 'precision',
  recall: 'recall',
  f1: 'F1',
  iou: 'IoU',
};

/** What `berm eval` says; nothing without truth. */
export function evaluationFacts(report: Report): HTMLElement[] {
  const { evaluation } = report;
  const judged = ['ground', 'piste', 'snow', 'edges'].filter((key) => at(evaluation, key) !== null);
  const parts: HTMLElement[] = [];
  if (judged.length > 0) {
    const rows = judged.map((key) => [
      key === 'edges' ? 'edges, within 0.5 m' : key,
      ...Object.keys(kShares).map((share) => {
        const value = at(evaluation, key, share);
        return typeof value === 'number' ? percent(value) : '–';
      }),
    ]);
    parts.push(
      h(
        'div',
        { class: 'block' },
        scrolled(
          'Labels and edges',
          table('Labels and edges against truth', ['', ...Object.values(kShares)], rows, false),
        ),
      ),
    );
  }
  const more: [string, string][] = [];
  const put = (name: string, unit: string, factor: number, ...keys: string[]) => {
    const value = at(evaluation, ...keys);
    if (typeof value === 'number') more.push([name, `${rounded(value * factor)} ${unit}`]);
  };
  put('Edges: lateral error, median', 'm', 1, 'edges', 'lateral_median_m');
  put('Edges: lateral error, 95 %', 'm', 1, 'edges', 'lateral_p95_m');
  put('Edges: share on the wrong side', '%', 100, 'edges', 'wrong_side_share');
  put('Trajectory: absolute error (RMS)', 'm', 1, 'trajectory', 'ate_rmse_m');
  put('Trajectory: relative error', '%', 1, 'trajectory', 'relative', 'translation_percent');
  put('Trajectory: relative rotation', '°/m', 1, 'trajectory', 'relative', 'rotation_deg_per_m');
  if (more.length > 0) parts.push(facts(more));
  const lengths = list(evaluation, 'trajectory', 'relative_by_length').map((error) => [
    `${rounded(num(error, ['length_m']))} m`,
    `${rounded(num(error, ['translation_percent']))} %`,
    `${rounded(num(error, ['rotation_deg_per_m']))} °/m`,
    fixed(num(error, ['stretches'])),
  ]);
  if (lengths.length > 0) {
    const name = 'Relative error of the trajectory by length';
    parts.push(
      folded(name, () =>
        scrolled(name, table(name, ['length', 'translation', 'rotation', 'stretches'], lengths)),
      ),
    );
  }
  const leftOut = entries(evaluation, 'left_out').map(([name, reason]) => `${name}: ${plain(reason)}`);
  if (parts.length > 0 && leftOut.length > 0) {
    parts.push(h('p', { class: 'quiet' }, `Not measured: ${leftOut.join('; ')}.`));
  }
  return parts;
}
