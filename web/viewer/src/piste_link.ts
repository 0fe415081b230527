import type { Vector } from './data/model';
import { runOf, worldOf, type Page } from './page';
import type { PointObject } from './scene/point_object';
import type { Pane } from './scene/stage';
import type { RunSession } from './session';
import { make } from './ui/dom';
import { Waveform } from './ui/waveform';

/** The piste method of the runs: in the picture and as waveforms, one below each pane, linked both ways. */
export class PisteLink {
  readonly root: HTMLElement;
  private readonly links: readonly RunLink[];

  /** `mark` shows a place in the picture. */
  constructor(page: Page, close: () => void, mark: (place: Vector | undefined) => void) {
    const named = page.runs.length > 1;
    this.links = page.runs.map((run, i) => new RunLink(page, run, i, named, close, mark));
    this.root = make('div', { class: 'drawers' }, ...this.links.map((link) => link.waveform.drawer.root));
  }

  /** The pointer is on a point of the picture: the plot of its run shows its sample. */
  point(page: Page, pane: Pane, object: PointObject, index: number): void {
    const run = runOf(page, pane);
    this.links.find((link) => link.run === run)?.point(object, index);
  }

  /** Shows or hides the plots. */
  apply(visible: boolean): void {
    for (const { run, waveform } of this.links) waveform.drawer.show(visible && run.info.layers.has('piste'));
  }

  show(): void {
    for (const link of this.links) link.show();
  }
}

/** One run and its waveform. */
class RunLink {
  readonly waveform: Waveform;
  private shown = '';
  private abort = new AbortController();

  constructor(
    private readonly page: Page,
    readonly run: RunSession,
    private readonly index: number,
    named: boolean,
    close: () => void,
    private readonly mark: (place: Vector | undefined) => void,
  ) {
    const name = named ? `Waveform of ${run.info.name}` : 'Waveform';
    this.waveform = new Waveform(name, close, (point) => this.markPoint(point));
  }

  point(object: PointObject, index: number): void {
    if (this.shown !== '' && object === this.scanObject()) this.waveform.point(index);
  }

  show(): void {
    const { run, page } = this;
    const scan = page.timeline.scanAt(this.index, page.clock.time_s);
    const on =
      page.store.state.layers.has('piste') && run.info.layers.has('piste') && run.view.shownScans.has(scan);
    const key = on ? String(scan) : '';
    if (key === this.shown) return;
    this.shown = key;
    this.abort.abort();
    this.abort = new AbortController();
    run.view.showPiste(scan, undefined);
    page.redraw();
    if (!on) return;
    const { signal } = this.abort;
    run.piste(scan, signal).then(
      (piste) => {
        if (signal.aborted) return;
        run.view.showPiste(scan, piste);
        this.waveform.show(piste, scan);
        page.redraw();
      },
      (error: unknown) => {
        if (signal.aborted) return;
        this.waveform.show(undefined, scan);
        if ((error as { status?: number }).status !== 404) page.messages.error(error);
      },
    );
  }

  /** The scan of this run at the time of the clock; undefined while it is on its way. */
  private scanObject(): PointObject | undefined {
    return this.run.view.shownScans.get(this.page.timeline.scanAt(this.index, this.page.clock.time_s));
  }

  private markPoint(point: number | undefined): void {
    const object = this.scanObject();
    const known = object !== undefined && point !== undefined && point < object.block.count;
    this.mark(known ? worldOf(object, point) : undefined);
  }
}
