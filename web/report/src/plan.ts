import { at, before, everyNth, isObject, type Path, type Report } from './data';
import { h, svg } from './dom';
import { fixed, length, rounded } from './format';
import { folded, scrolled, table } from './tables';
import { shadePicture, type Terrain } from './terrain';
import { kPrintWidth, onChange } from './theme';

const kMargin = 26;
const kMostHeight = 460;
const kLeastHeight = 140;

/** What odometry.csv calls the states of a pose, with a style each. */
const kHealth = ['good', 'starting', 'weak', 'lost'];

interface Drawing {
  name: string;
  style: string;
  x: number[];
  y: number[];
}

/** A round length of at most `most`: 1, 2 or 5 times a power of ten. */
export function roundLength(most: number): number {
  const decade = 10 ** Math.floor(Math.log10(most));
  return ([5, 2].find((factor) => factor * decade <= most) ?? 1) * decade;
}

/** The path in pieces of one health; one piece where the poses are not the odometry's. */
export function piecesOf(path: Path, report: Report): Drawing[] {
  const pieces: Drawing[] = [];
  path.timeS.forEach((time, i) => {
    const health = before(report.odometry, 'health', time);
    const style = health === null ? 'path' : `path ${kHealth[health] ?? ''}`;
    const name = health === null ? 'path of the machine' : `path, odometry ${kHealth[health] ?? ''}`;
    let piece = pieces.at(-1);
    if (piece?.style !== style) {
      const begin = i > 0 ? i - 1 : 0; // pieces touch
      piece = { name, style, x: [path.x[begin]!], y: [path.y[begin]!] };
      pieces.push(piece);
    }
    piece.x.push(path.x[i]!);
    piece.y.push(path.y[i]!);
  });
  return pieces;
}

/** What can be laid over each other: one world. */
export interface Plan {
  title: string;
  drawings: Drawing[];
  path: Path | undefined;
  ground?: Terrain;
}

/**
 * The odometry begins a world of its own where poses are known: edges and the path that is fused with them lie in the
 * world of the poses, and the odometry gets a plan for itself.
 */
export function plansOf(report: Report): Plan[] {
  const edges = report.edges.map((line) => ({
    name: `${line.side} edge`,
    style: line.side === 'left' ? 'left' : 'right',
    x: line.x,
    y: line.y,
  }));
  const { trajectory, globalTrajectory } = report;
  const apart =
    report.odometry !== undefined && (globalTrajectory !== undefined || isObject(at(report.run, 'poses')));
  const path = globalTrajectory ?? (apart ? undefined : trajectory);
  const world: Plan = {
    title: 'From above',
    drawings: [...edges, ...(path ? piecesOf(path, report) : [])],
    path,
  };
  if (report.terrain) world.ground = report.terrain;
  const plans = world.drawings.length > 0 || world.ground ? [world] : [];
  if (apart && trajectory) {
    plans.push({ title: 'Odometry from above', drawings: piecesOf(trajectory, report), path: trajectory });
  }
  return plans;
}

function extentOf({ drawings, ground }: Plan): { x: number; y: number; width: number; height: number } {
  let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
  if (ground) {
    [x0, x1] = [ground.x, ground.x + ground.columns * ground.cellM];
    [y0, y1] = [ground.y, ground.y + ground.rows * ground.cellM];
  }
  for (const { x, y } of drawings) {
    for (const value of x) [x0, x1] = [Math.min(x0, value), Math.max(x1, value)];
    for (const value of y) [y0, y1] = [Math.min(y0, value), Math.max(y1, value)];
  }
  return { x: x0, y: y0, width: Math.max(x1 - x0, 1), height: Math.max(y1 - y0, 1) };
}

/** Path and edges from above, the same scale both ways. */
function draw(plan: Plan, shade: string, width: number): SVGElement {
  const { drawings, path, ground } = plan;
  const extent = extentOf(plan);
  const scale = Math.min((width - 2 * kMargin) / extent.width, (kMostHeight - 2 * kMargin) / extent.height);
  const height = Math.max(kLeastHeight, extent.height * scale + 2 * kMargin + 18);
  const left = (width - extent.width * scale) / 2;
  const top = (height - 18 - extent.height * scale) / 2;
  const px = (x: number) => (left + (x - extent.x) * scale).toFixed(1);
  const py = (y: number) => (top + (extent.y + extent.height - y) * scale).toFixed(1);
  const picture = svg('svg', { width, height, viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true' });
  if (ground) {
    picture.append(
      svg('image', {
        class: 'ground',
        href: shade,
        x: px(ground.x),
        y: py(ground.y + ground.rows * ground.cellM),
        width: (ground.columns * ground.cellM * scale).toFixed(1),
        height: (ground.rows * ground.cellM * scale).toFixed(1),
        preserveAspectRatio: 'none',
      }),
    );
  }
  for (const { style, x, y } of drawings) {
    picture.append(
      svg('polyline', { class: style, points: x.map((value, i) => `${px(value)},${py(y[i]!)}`).join(' ') }),
    );
  }
  if (path) {
    const end = path.x.length - 1;
    picture.append(svg('circle', { class: 'start', cx: px(path.x[0]!), cy: py(path.y[0]!), r: 6 }));
    const [x, y] = [Number(px(path.x[end]!)) - 5, Number(py(path.y[end]!)) - 5];
    picture.append(svg('rect', { class: 'end', x, y, width: 10, height: 10 }));
  }
  const bar = roundLength((0.3 * width) / scale);
  const right = 10 + bar * scale;
  const foot = height - 8;
  picture.append(
    svg('path', { class: 'scale', d: `M10 ${foot - 5}V${foot}H${right.toFixed(1)}V${foot - 5}` }),
  );
  picture.append(svg('text', { x: right + 6, y: foot }, bar < 1 ? `${rounded(bar)} m` : length(bar)));
  return picture;
}

function key(style: string, name: string): HTMLElement {
  const sample =
    style === 'start'
      ? svg('circle', { class: style, cx: 14, cy: 7, r: 5 })
      : style === 'end'
        ? svg('rect', { class: style, x: 9, y: 2, width: 10, height: 10 })
        : svg('polyline', { class: style, points: '1,7 27,7' });
  return h(
    'span',
    {},
    svg('svg', { width: 28, height: 14, class: 'plan-key', 'aria-hidden': 'true' }, sample),
    name,
  );
}

/** None without poses and edges. */
export const planFigures = (report: Report): HTMLElement[] =>
  plansOf(report).map((plan) => planFigure(plan, report.originM));

function heightsOf(ground: Terrain, path: Path | undefined): string {
  const begin = path?.z[0] ?? 0;
  return `${fixed(ground.lowM - begin, 1)} to ${fixed(ground.highM - begin, 1)}`;
}

function planFigure(plan: Plan, originM: number[]): HTMLElement {
  const { title, drawings, path, ground } = plan;
  const extent = extentOf(plan);
  const about = `${length(extent.width)} by ${length(extent.height)}, x of the world to the right, y up.`;
  const heights = ground
    ? ` The ground is lit from the upper left; it lies ${heightsOf(ground, path)} m above where the machine began.`
    : '';
  const shade = ground ? shadePicture(ground) : '';
  const place = h('div', { class: 'plan', role: 'img', 'aria-label': `${title}: ${about}` });
  const redraw = (printing: boolean) => {
    const width = printing ? kPrintWidth : place.clientWidth;
    if (width > 50) place.replaceChildren(draw(plan, shade, width));
  };
  let seen = 0;
  new ResizeObserver(() => {
    if (place.clientWidth === seen || document.documentElement.classList.contains('printing')) return;
    seen = place.clientWidth;
    redraw(false);
  }).observe(place);
  onChange(redraw);
  const names = new Map(drawings.map(({ style, name }) => [style, name]));
  const keys = [...names].map(([style, name]) => key(style, name));
  if (path) keys.push(key('start', 'start'), key('end', 'end'));
  return h(
    'figure',
    {},
    h('figcaption', {}, h('strong', {}, title), ` ${about}${heights}`),
    place,
    h('div', { class: 'legend' }, ...keys),
    path
      ? folded(`Table: ${title}`, () => {
          const rows = everyNth(path.timeS.length, 60).map((i) => [
            fixed(path.timeS[i], 1),
            ...[path.x[i], path.y[i], path.z[i]].map((value) => fixed(value, 2)),
          ]);
          const origin = originM.map((value) => fixed(value, 2)).join(', ');
          const caption = `Path, from the origin ${origin} of the world`;
          return scrolled(caption, table(caption, ['time, s', 'x, m', 'y, m', 'z, m'], rows, false));
        })
      : null,
  );
}
