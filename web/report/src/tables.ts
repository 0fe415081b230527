import { everyNth, spread } from './data';
import { h } from './dom';
import { rounded } from './format';
import type { Plot } from './plot';

const kRows = 60;

/** A table that scrolls by itself, so that the page never does sideways; reached and scrolled by keyboard. */
export function scrolled(label: string, table: HTMLElement, prose = false): HTMLElement {
  return h(
    'div',
    { class: prose ? 'scrolled prose' : 'scrolled', role: 'region', tabindex: '0', 'aria-label': label },
    table,
  );
}

export function table(caption: string, head: string[], rows: string[][], hidden = true): HTMLElement {
  return h(
    'table',
    {},
    h('caption', { class: hidden ? 'unseen' : '' }, caption),
    h('thead', {}, h('tr', {}, ...head.map((name) => h('th', { scope: 'col' }, name)))),
    h(
      'tbody',
      {},
      ...rows.map((row) =>
        h('tr', {}, ...row.map((cell, i) => (i === 0 ? h('th', { scope: 'row' }, cell) : h('td', {}, cell)))),
      ),
    ),
  );
}

/** Builds the content when it is first opened: a page has twenty of these. */
export function folded(name: string, build: () => HTMLElement): HTMLElement {
  const details = h('details', {}, h('summary', {}, name));
  details.addEventListener('toggle', () => {
    if (details.open && details.childElementCount === 1) details.append(build());
  });
  return details;
}

/** The values of a plot: extremes and median of each line, then some rows. */
export function dataTable(plot: Plot): HTMLElement {
  return folded(`Table: ${plot.title}`, () => {
    const head = [`${plot.xName}, ${plot.xUnit}`];
    for (const line of plot.lines) head.push(`${line.name}, ${plot.unit}`, ...(line.sigma ? ['σ'] : []));
    const statistic = (name: string, key: 'low' | 'median' | 'high'): string[] => [
      name,
      ...plot.lines.flatMap((line) => [rounded(spread(line.values)?.[key]), ...(line.sigma ? [''] : [])]),
    ];
    const rows = everyNth(plot.x.length, kRows).map((i) => [
      rounded(plot.x[i]),
      ...plot.lines.flatMap((line) => [
        rounded(line.values[i]),
        ...(line.sigma ? [rounded(line.sigma[i])] : []),
      ]),
    ]);
    const all = [
      statistic('smallest', 'low'),
      statistic('median', 'median'),
      statistic('largest', 'high'),
      ...rows,
    ];
    return scrolled(plot.title, table(plot.title, head, all));
  });
}
