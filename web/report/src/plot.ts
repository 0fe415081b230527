import './sharp';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { spread, stack, type Numbers } from './data';
import { h } from './dom';
import { rounded } from './format';
import { dataTable } from './tables';
import { colour, kPrintWidth, onChange } from './theme';

export interface Line {
  name: string;
  values: Numbers;
  /** Name of a colour of the style sheet. */
  colour: string;
  dash?: number[];
  /** One standard deviation: drawn as a band. */
  sigma?: Numbers | undefined;
}

export interface Plot {
  title: string;
  /** What one sees, in a sentence. */
  note?: string;
  x: number[];
  xName: string;
  xUnit: string;
  unit: string;
  lines: Line[];
  /** Areas on top of each other instead of lines. */
  stacked?: boolean;
  logarithmic?: boolean;
  limits?: { value: number; name: string }[];
  /** A strip for each at the foot of the plot: 1 hatched (uncertain), 2 full (broken). */
  strips?: Numbers[];
  /** Plots of the same name share the cursor. */
  sync: string;
  range?: [number, number];
}

const kHeight = 230;
const kStripHeight = 7;
const kLeast = 1e-3; // of a logarithmic axis

const plus = (values: Numbers, sigma: Numbers, sign: number): Numbers =>
  values.map((value, i) => (value === null || sigma[i] == null ? null : value + sign * sigma[i]));

/** Columns in the order of the series; sigma as two columns without a line of their own, behind all lines. */
function columnsOf(plot: Plot): Numbers[] {
  if (plot.stacked) return stack(plot.lines.map((line) => line.values)).reverse();
  const lines = plot.lines.map((line) =>
    plot.logarithmic
      ? line.values.map((value) => (value === null ? null : Math.max(value, kLeast)))
      : line.values,
  );
  const bands = plot.lines.flatMap((line) =>
    line.sigma ? [plus(line.values, line.sigma, 1), plus(line.values, line.sigma, -1)] : [],
  );
  return [...lines, ...bands];
}

function seriesOf(plot: Plot): uPlot.Series[] {
  const shown = plot.stacked ? plot.lines.toReversed() : plot.lines;
  const lines = shown.map((line): uPlot.Series => ({
    label: line.name,
    stroke: () => colour(plot.stacked ? 'panel' : line.colour),
    width: plot.stacked ? 1 : 1.5,
    points: { show: plot.x.length < 30 && !plot.stacked, size: 5 },
    ...(line.dash ? { dash: line.dash } : {}),
    ...(plot.stacked ? { fill: () => colour(line.colour) } : {}),
  }));
  const bands = shown.flatMap((line): uPlot.Series[] =>
    !plot.stacked && line.sigma ? [bandEdge(`${line.name} + σ`), bandEdge(`${line.name} − σ`)] : [],
  );
  return [{ label: plot.xName }, ...lines, ...bands];
}

const bandEdge = (label: string): uPlot.Series => ({
  label,
  stroke: 'transparent',
  width: 0,
  points: { show: false },
});

function bandsOf(plot: Plot): uPlot.Band[] {
  if (plot.stacked) return [];
  let next = plot.lines.length + 1;
  return plot.lines.flatMap((line): uPlot.Band[] => {
    if (!line.sigma) return [];
    next += 2;
    return [
      {
        series: [next - 2, next - 1],
        fill: () => `color-mix(in srgb, ${colour(line.colour)} 25%, transparent)`,
      },
    ];
  });
}

function drawLimits(u: uPlot, plot: Plot): void {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = colour('bad');
  ctx.font = `${12 * uPlot.pxRatio}px system-ui, sans-serif`;
  ctx.lineWidth = 1.5 * uPlot.pxRatio;
  for (const { value, name } of plot.limits ?? []) {
    const y = u.valToPos(value, 'y', true);
    if (y < bbox.top || y > bbox.top + bbox.height) continue;
    ctx.setLineDash([6 * uPlot.pxRatio, 4 * uPlot.pxRatio]);
    ctx.beginPath();
    ctx.moveTo(bbox.left, y);
    ctx.lineTo(bbox.left + bbox.width, y);
    ctx.stroke();
    ctx.textAlign = 'right';
    ctx.textBaseline = y < bbox.top + bbox.height / 2 ? 'top' : 'bottom';
    ctx.fillText(name, bbox.left + bbox.width - 4, y + (ctx.textBaseline === 'top' ? 3 : -3) * uPlot.pxRatio);
  }
  ctx.restore();
}

function drawStrips(u: uPlot, plot: Plot): void {
  const { ctx, bbox } = u;
  const height = kStripHeight * uPlot.pxRatio;
  ctx.save();
  ctx.fillStyle = colour('bad');
  (plot.strips ?? []).forEach((strip, row) => {
    const top = bbox.top + bbox.height - (row + 1) * (height + uPlot.pxRatio);
    strip.forEach((state, i) => {
      if (state !== 1 && state !== 2) return;
      const begin = u.valToPos(plot.x[i]!, 'x', true);
      const end = u.valToPos(plot.x[i + 1] ?? plot.x[i]!, 'x', true);
      const part = state === 2 ? height : height / 3;
      ctx.fillRect(begin, top + height - part, Math.max(end - begin, 0) + uPlot.pxRatio, part);
    });
  });
  ctx.restore();
}

function axes(plot: Plot): uPlot.Axis[] {
  const look: uPlot.Axis = {
    stroke: () => colour('text'),
    grid: { stroke: () => colour('line'), width: 1 },
    ticks: { stroke: () => colour('line'), width: 1 },
    font: '12px system-ui, sans-serif',
    labelFont: '12px system-ui, sans-serif',
    labelSize: 18,
  };
  return [
    { ...look, label: `${plot.xName}, ${plot.xUnit}`, size: 34 },
    {
      ...look,
      label: plot.unit,
      size: 48,
      values: (_u, splits) => splits.map((v) => (v === null ? '' : String(Number(v.toPrecision(6))))),
    },
  ];
}

function yScale(plot: Plot): uPlot.Scale {
  if (plot.logarithmic) return { distr: 3, log: 10 };
  if (plot.range) return { range: plot.range };
  const limits = (plot.limits ?? []).map((limit) => limit.value);
  const room = (plot.strips?.length ?? 0) * 0.05;
  return {
    range: (_u, low, high) => {
      const [from, to] = uPlot.rangeNum(
        Math.min(low ?? 0, ...limits),
        Math.max(high ?? 1, ...limits),
        0.08,
        true,
      );
      return [from! - room * (to! - from!), to!];
    },
  };
}

function describe(plot: Plot): string {
  const parts = plot.lines.map((line) => {
    const found = spread(line.values);
    return found
      ? `${line.name} from ${rounded(found.low)} to ${rounded(found.high)}, median ${rounded(found.median)} ${plot.unit}`
      : '';
  });
  return `${plot.title}. ${parts.filter((part) => part !== '').join('; ')}.`;
}

/** Names of the lines as buttons that hide and show them. */
function legend(plot: Plot, toggle: (line: number, show: boolean) => void): HTMLElement {
  const keys = plot.lines.map((line, i) => {
    const button = h(
      'button',
      { type: 'button', 'aria-pressed': 'true' },
      h('span', {
        class: `swatch${line.dash ? ' dashed' : ''}${plot.stacked ? ' area' : ''}`,
        style: `--swatch: var(--${line.colour})`,
      }),
      line.name,
    );
    if (plot.stacked) button.disabled = true;
    button.addEventListener('click', () => {
      const show = button.getAttribute('aria-pressed') !== 'true';
      button.setAttribute('aria-pressed', String(show));
      toggle(i, show);
    });
    return button;
  });
  return h('div', { class: 'legend' }, ...keys);
}

function readout(plot: Plot, at: number | null | undefined): string {
  if (at === null || at === undefined) return '';
  const values = plot.lines
    .filter((line) => line.values[at] != null)
    .map((line) => {
      const sigma = line.sigma?.[at];
      return `${line.name} ${rounded(line.values[at])}${sigma == null ? '' : ` ± ${rounded(sigma)}`} ${plot.unit}`;
    });
  return `${plot.xName} ${rounded(plot.x[at])} ${plot.xUnit}: ${values.join(', ') || 'nothing known'}`;
}

/** The plot with its names, and behind it the table. */
export function plotFigure(plot: Plot): HTMLElement {
  const place = h('div', { class: 'plot', role: 'img', 'aria-label': describe(plot) });
  const values = h('p', { class: 'readout', 'aria-hidden': 'true' });
  let drawn: uPlot | undefined;
  const draw = (printing: boolean) => {
    const width = printing ? kPrintWidth : place.clientWidth;
    if (width < 50) return;
    if (drawn) {
      drawn.setSize({ width, height: kHeight });
      drawn.redraw();
      return;
    }
    drawn = new uPlot(
      {
        width,
        height: kHeight,
        series: seriesOf(plot),
        bands: bandsOf(plot),
        axes: axes(plot),
        scales: { x: { time: false }, y: yScale(plot) },
        legend: { show: false },
        cursor: { y: false, drag: { x: true, y: false }, sync: { key: plot.sync } },
        hooks: {
          draw: [(u) => drawStrips(u, plot), (u) => drawLimits(u, plot)],
          setCursor: [(u) => (values.textContent = readout(plot, u.cursor.idx))],
        },
      },
      [plot.x, ...columnsOf(plot)] as uPlot.AlignedData,
      place,
    );
  };
  const keys = legend(plot, (line, show) => toggleLine(drawn, plot, line, show));
  new ResizeObserver(() => {
    if (!document.documentElement.classList.contains('printing')) draw(false);
  }).observe(place);
  onChange(draw);
  return h(
    'figure',
    {},
    h('figcaption', {}, h('strong', {}, plot.title), plot.note ? ` ${plot.note}` : null),
    place,
    plot.lines.length > 1 || plot.stacked ? keys : null,
    values,
    dataTable(plot),
  );
}

function toggleLine(drawn: uPlot | undefined, plot: Plot, line: number, show: boolean): void {
  if (!drawn) return;
  drawn.setSeries(line + 1, { show });
  if (!plot.lines[line]?.sigma) return;
  const before = plot.lines.slice(0, line).filter((other) => other.sigma).length;
  const first = plot.lines.length + 1 + 2 * before;
  for (const edge of [first, first + 1]) drawn.setSeries(edge, { show });
}
