import type { Vector } from './data/model';
import { currentScan, worldOf, type Page } from './page';
import type { PointObject } from './scene/point_object';
import { Waveform } from './ui/waveform';

/** The piste method of the first run: in the picture and as a waveform, linked both ways. */
export class PisteLink {
  readonly waveform: Waveform;
  private shown = '';
  private abort = new AbortController();

  /** `mark` shows a place in the picture. */
  constructor(
    private readonly page: Page,
    close: () => void,
    private readonly mark: (place: Vector | undefined) => void,
  ) {
    this.waveform = new Waveform(close, (point) => this.markPoint(point));
  }

  /** The pointer is on a point of the picture: the plot shows its sample. */
  point(object: PointObject, index: number): void {
    if (this.shown !== '' && object === currentScan(this.page)) this.waveform.point(index);
  }

  show(): void {
    const run = this.page.runs[0]!;
    const scan = this.page.timeline.scanAt(0, this.page.clock.time_s);
    const on =
      this.page.store.state.layers.has('piste') &&
      run.info.layers.has('piste') &&
      run.view.shownScans.has(scan);
    const key = on ? String(scan) : '';
    if (key === this.shown) return;
    this.shown = key;
    this.abort.abort();
    this.abort = new AbortController();
    run.view.showPiste(scan, undefined);
    if (!on) return;
    const { signal } = this.abort;
    run.piste(scan, signal).then(
      (piste) => {
        if (signal.aborted) return;
        run.view.showPiste(scan, piste);
        this.waveform.show(piste, scan);
        this.page.redraw();
      },
      (error: unknown) => {
        if (signal.aborted) return;
        this.waveform.show(undefined, scan);
        if ((error as { status?: number }).status !== 404) this.page.messages.error(error);
      },
    );
  }

  private markPoint(point: number | undefined): void {
    const object = currentScan(this.page);
    const known = object !== undefined && point !== undefined && point < object.block.count;
    this.mark(known ? worldOf(object, point) : undefined);
  }
}
