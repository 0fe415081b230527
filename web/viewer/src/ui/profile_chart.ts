import uPlot from 'uplot';
import type { Vector } from '../data/model';
import type { ProfilePoint } from '../tools/profile';
import { Drawer } from './drawer';
import { slider } from './dom';
import { axis, fit } from './plot_style';

/** Heights along the line between two marks: every point of the corridor, one colour a label, one shade a run. */
export class ProfileChart {
  readonly drawer: Drawer;
  private readonly width;
  private plot: uPlot | undefined;
  private points: readonly ProfilePoint[] = [];

  constructor(
    close: () => void,
    setHalfWidth: (metres: number) => void,
    private readonly hover: (place: Vector | undefined) => void,
    private readonly colour: (label: number) => string,
  ) {
    this.width = slider('Half width', { min: 0.05, max: 3, step: 0.05 }, setHalfWidth);
    this.drawer = new Drawer('Height profile', close, this.width.row);
    new ResizeObserver(() => this.plot && fit(this.plot, this.drawer.body, 0)).observe(this.drawer.body);
  }

  show(points: readonly ProfilePoint[], length_m: number, halfWidth_m: number): void {
    this.width.set(halfWidth_m, `${halfWidth_m.toFixed(2)} m`);
    this.points = points;
    let low = Infinity;
    let high = -Infinity;
    for (const { height_m } of points) {
      low = Math.min(low, height_m);
      high = Math.max(high, height_m);
    }
    if (points.length === 0) [low, high] = [0, 1];
    this.drawer.heading =
      length_m === 0
        ? 'Height profile: click two points'
        : `Height profile: ${length_m.toFixed(2)} m, ${points.length} points, heights ${low.toFixed(2)} to ${high.toFixed(2)} m`;
    const margin = 0.05 * (high - low) + 0.05;
    // The corners of the plot are all that uPlot needs to know; the points are drawn by the hook below.
    const data: uPlot.AlignedData = [
      [0, Math.max(length_m, 0.1)],
      [low - margin, high + margin],
    ];
    if (this.plot === undefined) this.plot = this.create(data);
    else this.plot.setData(data);
    fit(this.plot, this.drawer.body, 0);
  }

  private create(data: uPlot.AlignedData): uPlot {
    return new uPlot(
      {
        width: 600,
        height: 160,
        legend: { show: false },
        scales: { x: { time: false } },
        axes: [axis('along the line (m)', { size: 32 }), axis('height (m)')],
        series: [{}, { paths: () => null, points: { show: false } }],
        cursor: { points: { show: false } },
        hooks: { draw: [(plot) => this.draw(plot)], setCursor: [(plot) => this.moved(plot)] },
      },
      data,
      this.drawer.body,
    );
  }

  private draw(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const size = 2.5 * uPlot.pxRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const point of this.points) {
      ctx.fillStyle = this.colour(point.label);
      const x = plot.valToPos(point.along_m, 'x', true);
      const y = plot.valToPos(point.height_m, 'y', true);
      ctx.fillRect(x - size / 2, y - size / 2, size, size);
    }
    ctx.restore();
  }

  private moved(plot: uPlot): void {
    const { left, top } = plot.cursor;
    if (left === undefined || top === undefined || left < 0) {
      this.hover(undefined);
      return;
    }
    let best: ProfilePoint | undefined;
    let bestDistance = 30;
    for (const point of this.points) {
      const distance = Math.hypot(
        plot.valToPos(point.along_m, 'x') - left,
        plot.valToPos(point.height_m, 'y') - top,
      );
      if (distance >= bestDistance) continue;
      bestDistance = distance;
      best = point;
    }
    this.hover(best?.world);
  }
}
