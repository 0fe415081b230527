/** Everything on a canvas is drawn in the colours that the style sheet has at that moment: light, dark, or print. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim() || '#888';
}

type Redraw = (printing: boolean) => void;
const drawings = new Set<Redraw>();

/** Calls `redraw` when colours or the width of the page change. */
export function onChange(redraw: Redraw): void {
  drawings.add(redraw);
}

function redrawAll(printing: boolean): void {
  document.documentElement.classList.toggle('printing', printing);
  for (const redraw of drawings) redraw(printing);
}

export function watchTheme(): void {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => redrawAll(false));
  let width = window.innerWidth;
  addEventListener('resize', () => {
    if (window.innerWidth !== width && !document.documentElement.classList.contains('printing'))
      redrawAll(false);
    width = window.innerWidth;
  });
  addEventListener('beforeprint', () => redrawAll(true));
  addEventListener('afterprint', () => redrawAll(false));
}

/** Width of A4 between its margins, in CSS pixels. */
export const kPrintWidth = 660;
