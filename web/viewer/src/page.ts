import type { Loader } from './data/loader';
import type { PointBlock } from './data/points';
import type { Clock, Timeline } from './playback/clock';
import { kWorld, type Anchor } from './scene/rig';
import type { PointObject } from './scene/point_object';
import type { Pane, Stage } from './scene/stage';
import type { RunSession } from './session';
import type { Store } from './store';
import type { Vector } from './data/model';
import type { Messages } from './ui/messages';
import type { CameraView } from './view_state';

/** What the parts of the page share. */
export interface Page {
  readonly runs: readonly RunSession[];
  readonly store: Store;
  readonly timeline: Timeline;
  readonly clock: Clock;
  readonly stage: Stage;
  readonly loader: Loader<PointBlock>;
  readonly messages: Messages;
  /** The camera alone, many times a second: nothing but the picture depends on it. */
  setView(view: CameraView): void;
  /** The picture is to be drawn anew. */
  redraw(): void;
  /** What is in the picture is to be chosen anew, too. */
  reload(): void;
}

export const runOf = (page: Page, pane: Pane): RunSession =>
  page.runs.find(({ view }) => view === pane.view)!;

/** What the camera moves along with. */
export const anchorIn = (page: Page, pane: Pane): Anchor =>
  page.store.state.camera === 'free' ? kWorld : pane.view.anchor;

/** True for labels of `run` that are drawn. */
export function shownLabels(page: Page, run: RunSession): (label: number) => boolean {
  const { hidden } = page.store.state;
  const ids = new Set(run.labels.filter(({ name }) => hidden.has(name)).map(({ id }) => id));
  return (label) => !ids.has(label);
}

export function worldOf(object: PointObject, i: number): Vector {
  const m = object.object.matrix.elements;
  const { x, y, z } = object.block;
  const row = (k: number) => m[k]! * x[i]! + m[4 + k]! * y[i]! + m[8 + k]! * z[i]! + m[12 + k]!;
  return [row(0), row(1), row(2)];
}
