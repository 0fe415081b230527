import { anchorIn, runOf, shownLabels, worldOf, type Page } from './page';
import type { Vector } from './data/model';
import type { PointObject } from './scene/point_object';
import { toAnchor } from './scene/rig';
import type { Pane } from './scene/stage';
import type { RunSession } from './session';
import { pick } from './tools/pick';
import type { Hud } from './ui/hud';

const kPick_px = 10;

/** A point that the pointer is on. */
interface Picked {
  readonly pane: Pane;
  readonly object: PointObject;
  readonly index: number;
  readonly world: Vector;
}

/** What the pointer does to points: shows, marks, looks at them. */
export class Pointing {
  /** Where the pointer is, since it was last looked at. */
  pointer: { x: number; y: number } | undefined;

  /** `onPoint` is told the point that the pointer is on. */
  constructor(
    private readonly page: Page,
    private readonly hud: Hud,
    private readonly onPoint: (pane: Pane, object: PointObject, index: number) => void,
  ) {}

  click(x: number, y: number): void {
    if (this.page.store.state.tool === 'none') return;
    const picked = this.pickAt(x, y);
    if (picked === undefined) return;
    this.page.store.change(
      (s) => (s.marks = s.marks.length >= 2 ? [picked.world] : [...s.marks, picked.world]),
    );
  }

  lookAt(x: number, y: number): void {
    const picked = this.pickAt(x, y);
    if (picked === undefined || this.page.store.state.tool !== 'none') return;
    this.page.setView({
      ...this.page.store.state.view,
      target: toAnchor(picked.world, anchorIn(this.page, picked.pane)),
    });
  }

  hover(): void {
    if (this.pointer === undefined) return;
    const { x, y } = this.pointer;
    this.pointer = undefined;
    const picked = this.pickAt(x, y);
    if (picked === undefined) {
      this.hud.point('');
      return;
    }
    const run = runOf(this.page, picked.pane);
    this.hud.point(describe(picked, run));
    this.onPoint(picked.pane, picked.object, picked.index);
  }

  private pickAt(x: number, y: number): Picked | undefined {
    const pane = this.page.stage.paneAt(x);
    const run = runOf(this.page, pane);
    let best: Picked | undefined;
    let bestDepth = Infinity;
    for (const object of pane.view.drawn()) {
      const clip = this.page.stage.clip(pane, object.object.matrix);
      const hit = pick(
        object.block,
        clip.elements,
        pane,
        { x: x - pane.left, y },
        kPick_px,
        shownLabels(this.page, run),
      );
      if (hit === undefined || hit.depth >= bestDepth) continue;
      bestDepth = hit.depth;
      best = { pane, object, index: hit.index, world: worldOf(object, hit.index) };
    }
    return best;
  }
}

function describe({ object, index, world }: Picked, run: RunSession): string {
  const { block } = object;
  const parts = [`x ${world[0].toFixed(2)}  y ${world[1].toFixed(2)}  z ${world[2].toFixed(2)} m`];
  if ((block.channels & 2) !== 0) parts.push(run.labelName(block.label[index]!).replace(/_/g, ' '));
  if ((block.channels & 1) !== 0) parts.push(`intensity ${block.intensity[index]}`);
  if ((block.channels & 8) !== 0) parts.push(`ring ${block.ring[index]}`);
  return parts.join('  ·  ');
}
