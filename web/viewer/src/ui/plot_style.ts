import type uPlot from 'uplot';

const kText = '#c3ccd8';
const kGrid = { stroke: '#2c3644', width: 1 };

export const axis = (label: string, extra: Partial<uPlot.Axis> = {}): uPlot.Axis => ({
  label,
  stroke: kText,
  grid: kGrid,
  ticks: kGrid,
  font: '12px system-ui, sans-serif',
  labelFont: '12px system-ui, sans-serif',
  labelSize: 18,
  size: 52,
  ...extra,
});

/** Keeps a plot as large as its box. */
export function fit(plot: uPlot, box: HTMLElement, legend_px: number): void {
  const size = { width: Math.max(120, box.clientWidth), height: Math.max(80, box.clientHeight - legend_px) };
  if (plot.width !== size.width || plot.height !== size.height) plot.setSize(size);
}
