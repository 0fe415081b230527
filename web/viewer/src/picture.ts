import { chooseTiles } from './data/level_of_detail';
import type { Wanted } from './data/loader';
import type { PointBlock } from './data/points';
import { anchorIn, runOf, type Page } from './page';
import type { Pane } from './scene/stage';
import type { RunSession } from './session';
import { groundDistance } from './tools/ground_distance';
import type { LayerName } from './view_state';

const kPrefetch = 8;
const kTileBudget = 3e6;

/** Chooses what is in the picture: scans, tiles, layers. */
export class Picture {
  /** 1 or -1: where the scans lie that will be wanted next. */
  direction = 1;
  /** False until the first picture was drawn: before that nothing is asked for that it does not need. */
  hasBegun = false;
  private drawn = '';
  /** Coarsest tiles in view that have not come yet. */
  private missing = 0;

  constructor(private readonly page: Page) {}

  /** Brings scans and tiles of this moment into the picture and asks for those that are not there; true if it changed. */
  show(): boolean {
    const wanted: Wanted<PointBlock>[] = [];
    const later: Wanted<PointBlock>[] = [];
    this.page.runs.forEach((run, i) => {
      const scans = this.scansAt(i);
      run.view.showScans(scans, (scan) => this.page.loader.get(run.scanKey(scan)));
      run.view.scansVisible = this.page.store.state.layers.has('scan');
      wanted.push(...scans.map((scan) => run.wantScan(scan)));
      for (let k = 1; this.hasBegun && k <= kPrefetch; ++k) {
        const scan = (scans[0] ?? -1) + k * this.direction;
        if (scan >= 0 && scan < run.table.count) later.push(run.wantScan(scan));
      }
    });
    this.missing = 0;
    for (const pane of this.page.stage.panes) wanted.push(...this.showMap(pane));
    this.page.loader.want([...wanted, ...later]);
    const drawn = this.page.runs
      .map((run) => [...run.view.drawn()].map((object) => object.object.id).join())
      .join(';');
    const changed = drawn !== this.drawn;
    this.drawn = drawn;
    if (changed && this.page.store.state.mode === 'ground') this.addGround();
    return changed;
  }

  /** How many tiles of maps are drawn, what is still on its way, and whether the map is there as far as one sees. */
  counts(): { tiles: string; waiting: string; map: string } {
    const tiles = this.page.runs.reduce((sum, run) => sum + run.view.shownTiles, 0);
    const map = tiles > 0 && this.missing === 0 ? 'whole' : '';
    return { tiles: String(tiles), waiting: String(this.page.loader.waiting), map };
  }

  /** True when the scans of this time are on the screen, or cannot be had. */
  isReady(): boolean {
    return this.page.runs.every((run, i) => {
      const scan = this.page.timeline.scanAt(i, this.page.clock.time_s);
      return scan < 0 || run.view.shownScans.has(scan) || this.page.loader.hasFailed(run.scanKey(scan));
    });
  }

  applyLayer(run: RunSession, layer: LayerName): void {
    const visible = this.page.store.state.layers.has(layer);
    const object = run.view.layers.get(layer);
    if (object !== undefined) object.visible = visible;
    if (!visible || !this.hasBegun) return;
    run.load(layer).then(
      () => {
        const loaded = run.view.layers.get(layer);
        if (loaded !== undefined) loaded.visible = this.page.store.state.layers.has(layer);
        this.page.reload();
      },
      (error: unknown) => this.page.messages.error(error),
    );
  }

  addGround(): void {
    for (const run of this.page.runs) {
      for (const object of run.view.drawn()) {
        if (object.hasGround) continue;
        const labelled = (object.block.channels & 2) !== 0 && run.ground.size > 0;
        object.setGround(groundDistance(object.block, run.ground, labelled));
      }
    }
  }

  private scansAt(run: number): number[] {
    const scan = this.page.timeline.scanAt(run, this.page.clock.time_s);
    const count = Math.min(this.page.store.state.trail, scan + 1);
    return Array.from({ length: Math.max(0, count) }, (_, age) => scan - age);
  }

  private showMap(pane: Pane): Wanted<PointBlock>[] {
    const run = runOf(this.page, pane);
    if (run.tiles === undefined || !this.page.store.state.layers.has('map')) {
      run.view.showTiles([], () => undefined);
      return [];
    }
    this.page.stage.aim(pane, this.page.store.state.view, anchorIn(this.page, pane));
    const chosen = chooseTiles(
      run.tiles.tiles,
      this.page.stage.eye(pane),
      kTileBudget / this.page.runs.length,
    );
    run.view.showTiles(chosen, (tile) => this.page.loader.get(run.tileKey(tile)));
    this.missing += chosen.filter((tile) => tile.level === 0 && !run.view.hasTile(tile.id)).length;
    return chosen.map((tile) => run.wantTile(tile.id));
  }
}
