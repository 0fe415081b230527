import uPlot from 'uplot';
import type { Piste } from '../data/model';
import { Drawer } from './drawer';
import { axis, fit } from './plot_style';

const kLegend_px = 30;

/** Series of a scan over its firing order, with steps and petals; linked with the points both ways. */
export class Waveform {
  readonly drawer: Drawer;
  private plot: uPlot | undefined;
  private piste: Piste | undefined;
  private sampleOf = new Map<number, number>();
  private quiet = false;

  /** `hover` is told the index of the point below the cursor, undefined for none. */
  constructor(
    private readonly name: string,
    close: () => void,
    private readonly hover: (point: number | undefined) => void,
  ) {
    this.drawer = new Drawer(name, close);
    new ResizeObserver(() => this.plot && fit(this.plot, this.drawer.body, kLegend_px)).observe(
      this.drawer.body,
    );
  }

  show(piste: Piste | undefined, scan: number): void {
    if (piste === undefined) {
      this.drawer.heading = `${this.name}: this scan has none`;
      this.plot?.setData([[], [], [], []]);
      this.piste = undefined;
      return;
    }
    this.piste = piste;
    this.sampleOf = new Map();
    piste.shown.forEach((point, sample) => point >= 0 && this.sampleOf.set(point, sample));
    const found =
      piste.petals.length > 0 ? `, ${piste.steps.length} steps, ${piste.petals.length} petals` : '';
    this.drawer.heading = `${this.name}, scan ${scan + 1}, method ${piste.method}${found}`;
    const samples = Array.from(piste.z, (_, k) => k + piste.first);
    const data: uPlot.AlignedData = [samples, [...piste.intensity], [...piste.x], [...piste.z]];
    if (this.plot === undefined) this.plot = this.create(data);
    else this.plot.setData(data);
    fit(this.plot, this.drawer.body, kLegend_px);
  }

  /** Puts the cursor on the sample of a point that is pointed at in the picture. */
  point(index: number): void {
    const sample = this.sampleOf.get(index);
    if (sample === undefined || this.plot === undefined || this.piste === undefined) return;
    this.quiet = true;
    this.plot.setCursor({
      left: this.plot.valToPos(sample + this.piste.first, 'x'),
      top: this.plot.bbox.height / 4,
    });
    this.quiet = false;
  }

  private create(data: uPlot.AlignedData): uPlot {
    const line = (label: string, scale: string, stroke: string, show = true): uPlot.Series => ({
      label,
      scale,
      stroke,
      show,
      width: 1,
      points: { show: false },
      value: (_, value: number | null) => (value === null ? '–' : value.toFixed(2)),
    });
    return new uPlot(
      {
        width: 600,
        height: 160,
        scales: { x: { time: false } },
        axes: [
          axis('sample in firing order', { size: 32 }),
          axis('height, range (m)', { scale: 'm' }),
          axis('intensity', { scale: 'i', side: 1, grid: { show: false } }),
        ],
        series: [
          { label: 'sample' },
          line('intensity', 'i', 'rgba(230, 159, 0, 0.55)'),
          line('range x (m)', 'm', '#009e73', false),
          line('height z (m)', 'm', '#56b4e9'),
        ],
        cursor: { drag: { x: true, y: false } },
        hooks: {
          drawClear: [(plot) => this.drawPetals(plot)],
          draw: [(plot) => this.drawSteps(plot)],
          setCursor: [(plot) => this.moved(plot)],
        },
      },
      data,
      this.drawer.body,
    );
  }

  private moved(plot: uPlot): void {
    if (this.quiet) return;
    const sample = plot.cursor.idx;
    const point = sample === null || sample === undefined ? -1 : (this.piste?.shown[sample] ?? -1);
    this.hover(point >= 0 ? point : undefined);
  }

  private drawPetals(plot: uPlot): void {
    const { ctx, bbox } = plot;
    ctx.save();
    const shift = this.piste?.first ?? 0;
    this.piste?.petals.forEach(([first, last], petal) => {
      ctx.fillStyle = petal % 2 === 0 ? 'rgba(86, 180, 233, 0.14)' : 'rgba(204, 121, 167, 0.14)';
      const left = Math.max(bbox.left, plot.valToPos(first + shift, 'x', true));
      const right = Math.min(bbox.left + bbox.width, plot.valToPos(last + shift, 'x', true));
      if (right > left) ctx.fillRect(left, bbox.top, right - left, bbox.height);
    });
    ctx.restore();
  }

  private drawSteps(plot: uPlot): void {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.fillStyle = '#ff5ac8';
    for (const sample of this.piste?.steps ?? []) {
      const x = plot.valToPos(sample + (this.piste?.first ?? 0), 'x', true);
      if (x < bbox.left || x > bbox.left + bbox.width) continue;
      const y = plot.valToPos(this.piste!.z[sample]!, 'm', true);
      ctx.beginPath();
      ctx.arc(x, y, 2, 0, 2 * Math.PI);
      ctx.fill();
    }
    ctx.restore();
  }
}
