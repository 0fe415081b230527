import { stretches, type Numbers, type Report, type Table } from './data';
import { h } from './dom';
import { elevationOf } from './elevation';
import { fixed, percent, words } from './format';
import { plotFigure, type Line, type Plot } from './plot';
import { folded, scrolled, table } from './tables';
import { isLevel, limitsOf, rulesOf } from './words';

const kTime = { xName: 'time', xUnit: 's', sync: 'time' } as const;
const kChainage = { xName: 'chainage', xUnit: 'm', sync: 'chainage' } as const;
const kLabels = ['drivable', 'terrain', 'obstacle', 'falling_snow', 'no_return', 'invalid'] as const;

/** A line with its sigma, if the table has the column. */
function lineOf(from: Table, column: string, name: string, colour: string, dash?: number[]): Line[] {
  const values = from.columns[column];
  if (!values) return [];
  const unit = column.lastIndexOf('_');
  const sigma = from.columns[`${column.slice(0, unit)}_sigma${column.slice(unit)}`];
  return [{ name, values, colour, ...(sigma ? { sigma } : {}), ...(dash ? { dash } : {}) }];
}

const figure = (plot: Plot): HTMLElement[] => (plot.lines.length > 0 ? [plotFigure(plot)] : []);

const thinned = (from: Table): string =>
  from.rowsPerValue > 1 ? ` Of every ${fixed(from.rowsPerValue)} rows the extremes are shown.` : '';

export function slopeFigures(report: Report): HTMLElement[] {
  const scans = report.scans;
  if (!scans) return [];
  const ahead = figure({
    ...kTime,
    title: 'Slope of the ground ahead',
    note: `against the machine, uphill positive, with one standard deviation.${thinned(scans)}`,
    x: scans.x,
    unit: 'degrees',
    lines: [
      ...lineOf(scans, 'slope_deg', 'slope', 'c0'),
      ...lineOf(scans, 'cross_fall_deg', 'cross-fall, to the right', 'c1', [6, 3]),
    ],
  });
  const obstacle = figure({
    ...kTime,
    title: 'Nearest obstacle ahead',
    note: thinned(scans),
    x: scans.x,
    unit: 'm',
    lines: lineOf(scans, 'obstacle_ahead_m', 'obstacle ahead', 'c1'),
  });
  const sides = figure({
    ...kTime,
    title: 'Nearest edge point of the road, scan by scan',
    note: thinned(scans),
    x: scans.x,
    unit: 'm',
    lines: [
      ...lineOf(scans, 'left_edge_m', 'left', 'left'),
      ...lineOf(scans, 'right_edge_m', 'right', 'right', [6, 3]),
    ],
  });
  return [...ahead, ...obstacle, ...sides];
}

export function heightFigures(report: Report): HTMLElement[] {
  const path = report.globalTrajectory ?? report.trajectory;
  if (!path || !isLevel(report)) return [];
  const over = figure({
    ...kTime,
    title: 'Height of the machine',
    note: 'above where it began.',
    x: path.timeS,
    unit: 'm',
    lines: [{ name: 'height', values: path.z.map((z) => z - path.z[0]!), colour: 'c0' }],
  });
  const { chainageM, heightM, slopePercent } = elevationOf(path);
  if (chainageM.length < 2) return over;
  const along = { xName: 'way', xUnit: 'm', sync: 'way', x: chainageM } as const;
  return [
    ...over,
    ...figure({
      ...along,
      title: 'Elevation along the way',
      note: 'above where it began, by the horizontal way driven.',
      unit: 'm',
      lines: [{ name: 'height', values: heightM, colour: 'c0' }],
    }),
    ...figure({
      ...along,
      title: 'Slope along the way',
      note: 'uphill positive, over 10 m of way.',
      unit: '%',
      lines: [{ name: 'slope', values: slopePercent, colour: 'c1' }],
    }),
  ];
}

export function odometryFigures(report: Report): HTMLElement[] {
  const odometry = report.odometry;
  if (!odometry) return [];
  const health = odometry.columns['health'];
  // 1 and 2 of a strip are thin and full: a weak pose and a lost one.
  const strips = health ? [health.map((state) => (state === null ? null : state - 1))] : [];
  return [
    ...figure({
      ...kTime,
      title: 'Standard deviation of the odometry',
      note: `of the position, largest direction; at the foot full where the pose is lost, thin where it is weak.${thinned(odometry)}`,
      x: odometry.x,
      unit: 'm',
      lines: lineOf(odometry, 'sigma_m', 'sigma', 'c0'),
      strips,
    }),
    ...figure({
      ...kTime,
      title: 'How much a scan says of its weakest direction',
      note: `1: all that is known, 0: nothing.${thinned(odometry)}`,
      x: odometry.x,
      unit: 'share',
      lines: lineOf(odometry, 'weakest', 'weakest direction', 'c2'),
      range: [0, 1],
    }),
  ];
}

export function labelFigures(report: Report): HTMLElement[] {
  const scans = report.scans;
  const points = scans?.columns['points'];
  if (!scans || !points) return [];
  const share = (column: Numbers): Numbers =>
    column.map((value, i) => (value === null || !points[i] ? null : (100 * value) / points[i]));
  const lines = kLabels.flatMap((label): Line[] => {
    const column = scans.columns[label];
    return column?.some((value) => value)
      ? [{ name: words(label), values: share(column), colour: `label-${label}` }]
      : [];
  });
  return figure({
    ...kTime,
    title: 'Shares of labels',
    note:
      scans.rowsPerValue > 1
        ? `mean of every ${fixed(scans.rowsPerValue)} scans.`
        : 'of all points of each scan.',
    x: scans.x,
    unit: '%',
    stacked: true,
    range: [0, 100],
    lines,
  });
}

const kStageColours = ['c0', 'c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'c7', 'c8'];

/** How many scans took how long, a small picture for each stage over the same logarithmic axis. */
function histogramFigure(report: Report): HTMLElement[] {
  const histograms = report.histograms;
  if (!histograms) return [];
  const all = Object.entries(histograms.scans);
  const used = all.flatMap(([, bins]) => bins.flatMap((n, i) => (n > 0 ? [i] : [])));
  const first = Math.min(...used);
  const last = Math.max(...used);
  const begin = (bin: number) => histograms.firstMs * 10 ** (bin / histograms.binsPerDecade);
  const about = (bin: number) => `${Number(begin(bin).toPrecision(2))} ms`;
  const rows = all.map(([name, bins]) => {
    const most = Math.max(...bins);
    const bars = bins
      .slice(first, last + 1)
      .map((n) => h('span', { style: `--share: ${n > 0 ? Math.max(n / most, 0.03) : 0}` }));
    return h(
      'div',
      { class: 'bars' },
      h('span', { class: 'name' }, stageName(name)),
      h('div', { class: 'bins' }, ...bars),
    );
  });
  const scale = h(
    'div',
    { class: 'bars axis' },
    h('span', {}),
    h('div', {}, h('span', {}, about(first)), h('span', {}, about(last + 1))),
  );
  const title = 'How many scans took how long';
  return [
    h(
      'figure',
      {},
      h(
        'figcaption',
        {},
        h('strong', {}, title),
        ' by the clock, on a logarithmic axis; the highest bar of each stage is as high.',
      ),
      h(
        'div',
        {
          class: 'histograms',
          role: 'img',
          'aria-label': `${title}: the figures are in the table of stages`,
        },
        ...rows,
        scale,
      ),
      folded(`Table: ${title}`, () => {
        const lines = Array.from({ length: last - first + 1 }, (_, i) => [
          `${about(first + i)} to ${about(first + i + 1)}`,
          ...all.map(([, bins]) => fixed(bins[first + i])),
        ]);
        return scrolled(
          title,
          table(title, ['scans that took', ...all.map(([name]) => stageName(name))], lines),
        );
      }),
    ),
  ];
}

const stageName = (column: string): string => words(column.replace(/_ms$/, ''));

export function timeFigures(report: Report): HTMLElement[] {
  const times = report.times;
  const over = times
    ? figure({
        ...kTime,
        title: 'Time per scan and stage',
        note: `by the clock, logarithmic.${thinned(times)}`,
        x: times.x,
        unit: 'ms',
        logarithmic: true,
        lines: Object.entries(times.columns).map(([name, values], i): Line => ({
          name: stageName(name),
          values,
          colour: kStageColours[i % kStageColours.length]!,
          ...(i >= 5 ? { dash: [6, 3] } : {}),
        })),
      })
    : [];
  return [...histogramFigure(report), ...over];
}

const metres = (from: number, to: number): string =>
  from === to ? fixed(from) : `${fixed(from)} to ${fixed(to)}`;

/** Which rules hold along the road, and where they do not. */
function ruleTable(report: Report, road: Table): HTMLElement[] {
  const rules = rulesOf(report);
  if (rules.length === 0) return [];
  const limits = limitsOf(report);
  const asked: Record<string, string> = {
    width_rule: `at least ${fixed(limits.widthM, 2)} m`,
    grade_rule: `at most ${fixed(limits.gradePercent, 1)} %`,
    left_berm_rule: `at least ${fixed(limits.bermM, 2)} m`,
    right_berm_rule: `at least ${fixed(limits.bermM, 2)} m`,
  };
  const rows = rules.map((rule) => {
    const all = rule.holds + rule.uncertain + rule.broken + rule.unknown || 1;
    const shares = [rule.holds, rule.uncertain, rule.broken, rule.unknown].map((n) => percent(n / all, 0));
    return [rule.name, asked[rule.key] ?? '', ...shares];
  });
  const broken = rules.flatMap((rule) => {
    const where = stretches(road, rule.key, 2);
    if (where.length === 0) return [];
    return [[rule.name, where.map(([from, to]) => metres(from, to)).join(', ')]];
  });
  const title = 'Rules of the road';
  const places = 'Where rules are broken';
  return [
    h(
      'div',
      { class: 'block' },
      scrolled(
        title,
        table(
          `${title}, share of the stations`,
          ['rule', 'asked', 'holds', 'uncertain', 'broken', 'not measured'],
          rows,
          false,
        ),
      ),
      broken.length > 0
        ? folded(places, () => scrolled(places, table(places, ['rule', 'chainage, m'], broken), true))
        : null,
    ),
  ];
}

export function roadFigures(report: Report): HTMLElement[] {
  const road = report.road;
  if (!road) return [];
  const limits = limitsOf(report);
  const strip = (...columns: string[]) =>
    columns.flatMap((name) => (road.columns[name] ? [road.columns[name]] : []));
  const note = `with one standard deviation; at the foot of the plot full where the rule is broken, thin where it is uncertain.${thinned(road)}`;
  const common = { ...kChainage, x: road.x, note };
  const limit = (value: number, name: string) => (value > 0 ? [{ value, name }] : []);
  return [
    ...ruleTable(report, road),
    ...figure({
      ...common,
      title: 'Width of the road',
      unit: 'm',
      lines: lineOf(road, 'width_m', 'width', 'c0'),
      limits: limit(limits.widthM, 'least width'),
      strips: strip('width_rule'),
    }),
    ...figure({
      ...common,
      title: 'Grade',
      unit: '%',
      lines: lineOf(road, 'grade_percent', 'grade, uphill positive', 'c0'),
      limits: [
        ...limit(limits.gradePercent, 'steepest'),
        ...(limits.gradePercent > 0 ? [{ value: -limits.gradePercent, name: 'steepest, down' }] : []),
      ],
      strips: strip('grade_rule'),
    }),
    ...figure({
      ...common,
      note: `falling to the right positive, with one standard deviation.${thinned(road)}`,
      title: 'Cross-fall',
      unit: '%',
      lines: lineOf(road, 'cross_fall_percent', 'cross-fall', 'c2'),
    }),
    ...figure({
      ...common,
      note: `${note} Left is the lower strip.`,
      title: 'Height of the berms',
      unit: 'm',
      lines: [
        ...lineOf(road, 'left_berm_height_m', 'left', 'left'),
        ...lineOf(road, 'right_berm_height_m', 'right', 'right', [6, 3]),
      ],
      limits: limit(limits.bermM, 'least height'),
      strips: strip('left_berm_rule', 'right_berm_rule'),
    }),
    ...figure({
      ...common,
      note: `from toe to toe, or as far as was seen, with one standard deviation.${thinned(road)}`,
      title: 'Width of the berms',
      unit: 'm',
      lines: [
        ...lineOf(road, 'left_berm_width_m', 'left', 'left'),
        ...lineOf(road, 'right_berm_width_m', 'right', 'right', [6, 3]),
      ],
    }),
  ];
}
