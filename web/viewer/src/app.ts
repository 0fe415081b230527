import { labelColour, css, labelTexels, rampTexels } from './colours';
import { commandOf, type Actions } from './commands';
import { ByteCache } from './data/cache';
import { chooseTiles } from './data/level_of_detail';
import { Loader, type Wanted } from './data/loader';
import { kBytesPerPoint, type PointBlock } from './data/points';
import type { Vector } from './data/model';
import { hasPose } from './data/poses';
import { modeIndex, type Mode } from './modes';
import { Clock, Timeline } from './playback/clock';
import { makeMarks } from './scene/marks';
import type { PointObject } from './scene/point_object';
import { PointerControl } from './scene/pointer_control';
import { kWorld, orbit, reanchor, toAnchor, zoom, type Anchor } from './scene/rig';
import { Stage, type Pane } from './scene/stage';
import { autoRange, rampOf, type Range, type RunSession } from './session';
import { Store } from './store';
import { groundDistance } from './tools/ground_distance';
import { pick } from './tools/pick';
import { measure, profile } from './tools/profile';
import { make } from './ui/dom';
import { Help } from './ui/help';
import { Hud } from './ui/hud';
import { Messages } from './ui/messages';
import { Panel, type PanelFacts } from './ui/panel';
import { ProfileChart } from './ui/profile_chart';
import { Toolbar } from './ui/toolbar';
import { Transport } from './ui/transport';
import { Waveform } from './ui/waveform';
import * as state from './view_state';

const kCacheBytes = 256 * 2 ** 20;
const kPrefetch = 8;
const kTileBudget = 3e6;
const kPick_px = 10;
/** Scans that are shown together at first where one alone says little: fewer points than this, and poses to place them. */
const kSparse_points = 30_000;
const kSparseTrail = 8;

/** A point that the pointer is on. */
interface Picked {
  readonly pane: Pane;
  readonly object: PointObject;
  readonly index: number;
  readonly world: Vector;
}

/** The page: holds state, data, picture and controls together. */
export class App implements Actions {
  private readonly store: Store;
  private readonly timeline: Timeline;
  private readonly clock: Clock;
  private readonly stage: Stage;
  private readonly loader: Loader<PointBlock>;
  private readonly messages = new Messages();
  private readonly help = new Help();
  private readonly hud = new Hud();
  private readonly toolbar: Toolbar;
  private readonly panel: Panel;
  private readonly transport: Transport;
  private readonly waveform: Waveform;
  private readonly chart: ProfileChart;
  private readonly facts: PanelFacts;
  private readonly manualRanges = new Map<Mode, Range>();
  private readonly root: HTMLElement;

  private dirty = true;
  private wantNew = true;
  private shown = '';
  private drawn = '';
  private direction = 1;
  private pisteShown = '';
  private pisteAbort = new AbortController();
  private pointer: { x: number; y: number } | undefined;
  private hashTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly runs: readonly RunSession[],
    root: HTMLElement,
  ) {
    this.root = root;
    this.store = new Store(state.decodeState(location.hash));
    this.timeline = new Timeline(runs.map((run) => run.table));
    if (location.hash === '' && isSparse(runs)) this.store.state.trail = kSparseTrail;
    this.clock = new Clock(this.timeline.duration_s);
    this.clock.seek(this.store.state.time_s);
    this.clock.speed = this.store.state.speed;
    const cache = new ByteCache<PointBlock>(kCacheBytes, (block) => block.count * kBytesPerPoint);
    this.loader = new Loader(
      cache,
      () => (this.wantNew = true),
      (_, error) => {
        this.wantNew = true;
        this.messages.error(error);
      },
    );
    const canvas = make('canvas', { class: 'canvas', role: 'img', tabindex: '0', 'aria-label': '3D view' });
    this.stage = new Stage(
      canvas,
      runs.map((run) => run.view),
    );
    this.facts = {
      runs: runs.map((run) => run.info),
      labels: this.allLabels(),
      channels: 0,
      counts: new Map(),
      range: [0, 1],
    };
    this.toolbar = new Toolbar(this);
    this.panel = new Panel(this.facts, this, {
      toggleLabel: (name) => this.toggleLabel(name),
      setPointSize: (pixels) => this.store.change((s) => (s.pointSize = pixels)),
      setTrail: (scans) => this.store.change((s) => (s.trail = scans)),
      setRange: (mode, range) => this.setRange(mode, range),
    });
    this.transport = new Transport(
      this,
      this.timeline,
      runs[0]!.table,
      (time_s) => this.seek(time_s),
      (speed) => this.store.change((s) => (s.speed = speed)),
    );
    this.waveform = new Waveform(
      () => this.toggleLayer('piste'),
      (point) => this.markPoint(point),
    );
    this.chart = new ProfileChart(
      () => this.setTool('none'),
      (halfWidth_m) => this.store.change((s) => (s.halfWidth_m = halfWidth_m)),
      (place) => this.markPlace(place),
      (label) => css(labelColour(runs[0]!.labelName(label), label)),
    );
    this.build(canvas);
    this.listen(canvas);
    this.store.onChange(() => this.apply());
    this.apply();
    requestAnimationFrame((now) => this.frame(now));
  }

  // ---- Actions

  togglePlay(): void {
    this.clock.toggle();
    this.direction = 1;
    this.wantNew = true;
    this.syncTime();
  }

  step(scans: number): void {
    this.direction = Math.sign(scans);
    this.seek(this.timeline.step(this.clock.time_s, scans));
  }

  goToStart(): void {
    this.seek(0);
  }

  goToEnd(): void {
    this.seek(this.timeline.duration_s);
  }

  changeSpeed(steps: number): void {
    const speeds = state.kSpeeds;
    const now = speeds.findIndex((speed) => speed >= this.store.state.speed);
    const next = speeds[Math.min(speeds.length - 1, Math.max(0, now + steps))]!;
    this.store.change((s) => (s.speed = next));
  }

  setMode(mode: Mode): void {
    this.store.change((s) => (s.mode = mode));
  }

  setCamera(camera: state.CameraName): void {
    const before = this.anchor(this.stage.panes[0]!);
    this.store.change((s) => {
      s.view = camera === 'free' ? reanchor(s.view, before, kWorld) : state.kCameraPresets[camera];
      s.camera = camera;
    });
  }

  turn(azimuth_deg: number, elevation_deg: number): void {
    this.setView(orbit(this.store.state.view, azimuth_deg, elevation_deg));
  }

  zoom(factor: number): void {
    this.setView(zoom(this.store.state.view, factor));
  }

  setTool(tool: state.ToolName): void {
    this.store.change((s) => {
      s.tool = s.tool === tool ? 'none' : tool;
      if (s.tool === 'none') s.marks = [];
    });
  }

  clearMarks(): void {
    this.store.change((s) => (s.marks = []));
  }

  toggleLayer(layer: state.LayerName): void {
    this.store.change(({ layers }) => {
      if (!layers.delete(layer)) layers.add(layer);
    });
  }

  toggleEdl(): void {
    this.store.change((s) => (s.edl = !s.edl));
  }

  changePointSize(steps: number): void {
    this.store.change((s) => (s.pointSize = Math.min(12, Math.max(1, s.pointSize + 0.5 * steps))));
  }

  screenshot(): void {
    this.stage.screenshot().then(
      (blob) => {
        const address = URL.createObjectURL(blob);
        const link = make('a', {
          href: address,
          download: `${this.runs[0]!.info.name}-${this.clock.time_s.toFixed(1)}s.png`,
        });
        link.click();
        setTimeout(() => URL.revokeObjectURL(address), 10_000);
        this.messages.say('Picture saved');
      },
      (error: unknown) => this.messages.error(error),
    );
  }

  copyLink(): void {
    this.writeHash();
    navigator.clipboard.writeText(location.href).then(
      () =>
        this.messages.say(
          'Link copied',
          'It shows the same view, as long as berm view serves the same runs.',
        ),
      () =>
        this.messages.say(
          'The browser does not let the page copy',
          'Copy the address above: it is the link.',
        ),
    );
  }

  toggleHelp(): void {
    this.help.toggle();
  }

  togglePanel(): void {
    this.root.classList.toggle('without-panel');
    this.dirty = true;
  }

  // ---- Building

  private build(canvas: HTMLCanvasElement): void {
    const titles =
      this.runs.length < 2 ? [] : this.runs.map((run) => make('div', { class: 'pane-title' }, run.info.name));
    const scene = make(
      'div',
      { class: 'scene' },
      canvas,
      make('div', { class: 'pane-titles' }, ...titles),
      this.toolbar.root,
      this.hud.root,
      this.messages.root,
    );
    const left = make(
      'main',
      { class: 'left' },
      scene,
      this.waveform.drawer.root,
      this.chart.drawer.root,
      this.transport.root,
    );
    this.root.replaceChildren(left, this.panel.root, this.help.root);
    if (window.innerWidth < 760) this.root.classList.add('without-panel');
  }

  private listen(canvas: HTMLCanvasElement): void {
    new PointerControl(canvas, {
      view: () => this.store.state.view,
      setView: (view) => this.setView(view),
      click: (x, y) => this.click(x, y),
      doubleClick: (x, y) => this.lookAt(x, y),
      hover: (x, y) => (this.pointer = { x, y }),
    });
    canvas.addEventListener('pointerleave', () => {
      this.pointer = undefined;
      this.hud.point('');
    });
    canvas.addEventListener('webglcontextlost', () =>
      this.messages.say('The graphics card gave up', 'Reload the page.', 'error'),
    );
    window.addEventListener('keydown', (event) => {
      if (this.help.root.open && event.key !== '?') return;
      const command = commandOf(event);
      if (command === undefined) return;
      event.preventDefault();
      command.run(this);
    });
    window.addEventListener('hashchange', () => this.readHash());
    new ResizeObserver(() => (this.dirty = true)).observe(canvas);
  }

  private allLabels() {
    const known = new Map(
      this.runs.flatMap((run) => run.labels.map((label) => [label.name, label] as const)),
    );
    return [...known.values()].sort((a, b) => a.id - b.id);
  }

  // ---- State to picture

  private apply(): void {
    const s = this.store.state;
    this.clock.speed = s.speed;
    this.stage.edlStrength = s.edl ? 40 : 0;
    for (const run of this.runs) {
      const { style } = run.view;
      style.uniforms.uMode.value = modeIndex(s.mode);
      style.uniforms.uSize.value = s.pointSize * this.stage.pixelRatio;
      style.setLabels(labelTexels(run.labels, s.hidden));
      style.setRamp(rampTexels(rampOf(s.mode)));
      run.view.ringsVisible = s.layers.has('rings');
      run.view.scansVisible = s.layers.has('scan');
      for (const layer of state.kLayers) this.applyLayer(run, layer);
    }
    this.applyMarks();
    this.drawn = '';
    this.chart.drawer.show(s.tool === 'profile');
    this.waveform.drawer.show(s.layers.has('piste') && this.runs[0]!.info.layers.has('piste'));
    this.toolbar.sync(s);
    this.syncFacts();
    this.syncTime();
    this.wantNew = true;
    this.dirty = true;
    this.scheduleHash();
  }

  private applyLayer(run: RunSession, layer: state.LayerName): void {
    const visible = this.store.state.layers.has(layer);
    const object = run.view.layers.get(layer);
    if (object !== undefined) object.visible = visible;
    if (!visible) return;
    run.load(layer).then(
      () => {
        const loaded = run.view.layers.get(layer);
        if (loaded !== undefined) loaded.visible = this.store.state.layers.has(layer);
        this.wantNew = this.dirty = true;
      },
      (error: unknown) => this.messages.error(error),
    );
  }

  private applyMarks(): void {
    const { marks, tool } = this.store.state;
    const scale_m = Math.max(0.03, this.store.state.view.distance_m * 0.004);
    for (const run of this.runs) run.view.setLayer('marks', makeMarks(tool === 'none' ? [] : marks, scale_m));
    const [a, b] = marks;
    this.hud.measurement(tool, marks.length, a !== undefined && b !== undefined ? measure(a, b) : undefined);
  }

  /** The profile of what is drawn now: anew when marks, labels, scans or tiles change. */
  private applyProfile(): void {
    const { marks, tool, halfWidth_m } = this.store.state;
    if (tool !== 'profile') return;
    const [a, b] = marks;
    if (a === undefined || b === undefined) {
      this.chart.show([], 0, halfWidth_m);
      return;
    }
    const points = this.runs.flatMap((run) => profile(blocksOf(run), a, b, halfWidth_m, this.isShown(run)));
    this.chart.show(points, Math.hypot(b[0] - a[0], b[1] - a[1]), halfWidth_m);
  }

  /** The camera alone, many times a second: nothing but the picture depends on it. */
  private setView(view: state.CameraView): void {
    this.store.state.view = view;
    if (this.store.state.marks.length > 0) this.applyMarks();
    this.wantNew = this.dirty = true;
    this.scheduleHash();
  }

  private setRange(mode: Mode, range: Range | undefined): void {
    if (range === undefined) this.manualRanges.delete(mode);
    else this.manualRanges.set(mode, range);
    this.store.change(() => undefined);
  }

  private toggleLabel(name: string): void {
    this.store.change(({ hidden }) => {
      if (!hidden.delete(name)) hidden.add(name);
    });
  }

  /** Ranges, counts and what channels there are, from the scans that are shown. */
  private syncFacts(): void {
    const { mode, layers } = this.store.state;
    const run = this.runs[0]!;
    const scan = run.view.shownScans.get(run.view.current);
    const tiles = layers.has('map') ? run.tiles : undefined;
    this.facts.range =
      this.manualRanges.get(mode) ?? autoRange(mode, scan?.block, run.view.anchor.position[2], tiles);
    for (const { view } of this.runs) view.style.uniforms.uRange.value.set(...this.facts.range);
    if (scan !== undefined) {
      this.facts.channels |= scan.block.channels;
      const counts = new Map<number, number>();
      if ((scan.block.channels & 2) !== 0)
        for (const label of scan.block.label) counts.set(label, (counts.get(label) ?? 0) + 1);
      this.facts.counts = counts;
    }
    if (mode === 'ground') this.addGround();
    this.panel.sync(this.store.state);
  }

  private addGround(): void {
    for (const run of this.runs) {
      for (const object of run.view.drawn()) {
        if (object.hasGround) continue;
        const labelled = (object.block.channels & 2) !== 0 && run.ground.size > 0;
        object.setGround(groundDistance(object.block, run.ground, labelled));
      }
    }
  }

  private isShown(run: RunSession): (label: number) => boolean {
    const hidden = new Set(
      run.labels.filter(({ name }) => this.store.state.hidden.has(name)).map(({ id }) => id),
    );
    return (label) => !hidden.has(label);
  }

  // ---- Time

  private seek(time_s: number): void {
    this.clock.seek(time_s);
    this.wantNew = true;
    this.syncTime();
    this.scheduleHash();
  }

  private syncTime(): void {
    this.store.state.time_s = this.clock.time_s;
    this.transport.sync(this.clock.time_s, this.clock.playing, this.clock.speed);
  }

  private frame(now_ms: number): void {
    if (this.stage.resize()) this.dirty = true;
    const wasPlaying = this.clock.playing;
    if (this.clock.tick(now_ms, this.isReady())) this.wantNew = true;
    if (wasPlaying) this.syncTime();
    if (wasPlaying && !this.clock.playing) this.scheduleHash();
    if (this.wantNew) this.show();
    if (this.dirty) {
      this.dirty = false;
      for (const pane of this.stage.panes) this.stage.aim(pane, this.store.state.view, this.anchor(pane));
      this.stage.render();
      this.placeHud();
    }
    this.hover();
    requestAnimationFrame((next) => this.frame(next));
  }

  private scansAt(run: number): number[] {
    const scan = this.timeline.scanAt(run, this.clock.time_s);
    const count = Math.min(this.store.state.trail, scan + 1);
    return Array.from({ length: Math.max(0, count) }, (_, age) => scan - age);
  }

  /** True when the scans of this time are on the screen, or cannot be had. */
  private isReady(): boolean {
    return this.runs.every((run, i) => {
      const scan = this.timeline.scanAt(i, this.clock.time_s);
      return scan < 0 || run.view.shownScans.has(scan) || this.loader.hasFailed(run.scanKey(scan));
    });
  }

  private show(): void {
    this.wantNew = false;
    const wanted: Wanted<PointBlock>[] = [];
    const later: Wanted<PointBlock>[] = [];
    this.runs.forEach((run, i) => {
      const scans = this.scansAt(i);
      run.view.showScans(scans, (scan) => this.loader.get(run.scanKey(scan)));
      run.view.scansVisible = this.store.state.layers.has('scan');
      wanted.push(...scans.map((scan) => run.wantScan(scan)));
      for (let k = 1; k <= kPrefetch; ++k) {
        const scan = (scans[0] ?? -1) + k * this.direction;
        if (scan >= 0 && scan < run.table.count) later.push(run.wantScan(scan));
      }
    });
    for (const pane of this.stage.panes) wanted.push(...this.showMap(pane));
    this.loader.want([...wanted, ...later]);
    this.dirty = true;
    const shown = this.runs.map((run) => run.view.current).join();
    if (shown !== this.shown && this.runs.some((run) => run.view.current >= 0)) this.shownChanged(shown);
    this.showPiste();
    const drawn = this.runs
      .map((run) => [...run.view.drawn()].map((object) => object.object.id).join())
      .join(';');
    if (drawn === this.drawn) return;
    this.drawn = drawn;
    if (this.store.state.mode === 'ground') this.addGround();
    this.applyProfile();
  }

  private shownChanged(shown: string): void {
    this.shown = shown;
    this.stage.canvas.dataset['scan'] = shown;
    this.stage.canvas.setAttribute(
      'aria-label',
      `3D view of scan ${shown} of ${this.runs.map((run) => run.info.name).join(' and ')}`,
    );
    this.syncFacts();
  }

  private showMap(pane: Pane): Wanted<PointBlock>[] {
    const run = this.runs.find(({ view }) => view === pane.view)!;
    if (run.tiles === undefined || !this.store.state.layers.has('map')) {
      run.view.showTiles([], () => undefined);
      return [];
    }
    this.stage.aim(pane, this.store.state.view, this.anchor(pane));
    const chosen = chooseTiles(run.tiles.tiles, this.stage.eye(pane), kTileBudget / this.runs.length);
    run.view.showTiles(chosen, (tile) => this.loader.get(run.tileKey(tile)));
    return chosen.map((tile) => run.wantTile(tile.id));
  }

  private showPiste(): void {
    const run = this.runs[0]!;
    const scan = this.timeline.scanAt(0, this.clock.time_s);
    const on =
      this.store.state.layers.has('piste') && run.info.layers.has('piste') && run.view.shownScans.has(scan);
    const key = on ? String(scan) : '';
    if (key === this.pisteShown) return;
    this.pisteShown = key;
    this.pisteAbort.abort();
    this.pisteAbort = new AbortController();
    run.view.showPiste(scan, undefined);
    if (!on) return;
    const { signal } = this.pisteAbort;
    run.piste(scan, signal).then(
      (piste) => {
        if (signal.aborted) return;
        run.view.showPiste(scan, piste);
        this.waveform.show(piste, scan);
        this.dirty = true;
      },
      (error: unknown) => {
        if (signal.aborted) return;
        this.waveform.show(undefined, scan);
        if ((error as { status?: number }).status !== 404) this.messages.error(error);
      },
    );
  }

  private anchor(pane: Pane): Anchor {
    return this.store.state.camera === 'free' ? kWorld : pane.view.anchor;
  }

  // ---- Pointing

  private pickAt(x: number, y: number): Picked | undefined {
    const pane = this.stage.paneAt(x);
    const run = this.runs.find(({ view }) => view === pane.view)!;
    let best: Picked | undefined;
    let bestDepth = Infinity;
    for (const object of pane.view.drawn()) {
      const clip = this.stage.clip(pane, object.object.matrix);
      const hit = pick(
        object.block,
        clip.elements,
        pane,
        { x: x - pane.left, y },
        kPick_px,
        this.isShown(run),
      );
      if (hit === undefined || hit.depth >= bestDepth) continue;
      bestDepth = hit.depth;
      best = { pane, object, index: hit.index, world: worldOf(object, hit.index) };
    }
    return best;
  }

  private click(x: number, y: number): void {
    if (this.store.state.tool === 'none') return;
    const picked = this.pickAt(x, y);
    if (picked === undefined) return;
    this.store.change((s) => (s.marks = s.marks.length >= 2 ? [picked.world] : [...s.marks, picked.world]));
  }

  private lookAt(x: number, y: number): void {
    const picked = this.pickAt(x, y);
    if (picked === undefined || this.store.state.tool !== 'none') return;
    this.setView({ ...this.store.state.view, target: toAnchor(picked.world, this.anchor(picked.pane)) });
  }

  private hover(): void {
    if (this.pointer === undefined) return;
    const { x, y } = this.pointer;
    this.pointer = undefined;
    const picked = this.pickAt(x, y);
    if (picked === undefined) {
      this.hud.point('');
      return;
    }
    const run = this.runs.find(({ view }) => view === picked.pane.view)!;
    this.hud.point(describe(picked, run));
    const scan = this.timeline.scanAt(0, this.clock.time_s);
    if (this.pisteShown !== '' && run.view.shownScans.get(scan) === picked.object)
      this.waveform.point(picked.index);
  }

  private markPoint(point: number | undefined): void {
    const run = this.runs[0]!;
    const object = run.view.shownScans.get(this.timeline.scanAt(0, this.clock.time_s));
    this.markPlace(
      object !== undefined && point !== undefined && point < object.block.count
        ? worldOf(object, point)
        : undefined,
    );
  }

  private markPlace(place: Vector | undefined): void {
    for (const run of this.runs)
      run.view.mark(place, Math.max(0.05, this.store.state.view.distance_m * 0.006));
    this.dirty = true;
  }

  private placeHud(): void {
    const [a, b] = this.store.state.marks;
    const pane = this.stage.panes[0]!;
    const middle: Vector | undefined =
      a && b ? [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2] : undefined;
    this.hud.place(middle === undefined ? undefined : this.stage.project(pane, middle));
  }

  // ---- Address

  private scheduleHash(): void {
    clearTimeout(this.hashTimer);
    if (!this.clock.playing) this.hashTimer = setTimeout(() => this.writeHash(), 250);
  }

  private writeHash(): void {
    history.replaceState(null, '', `#${state.encodeState(this.store.state)}`);
  }

  private readHash(): void {
    const read = state.decodeState(location.hash);
    this.clock.playing = false;
    this.clock.seek(read.time_s);
    this.store.change((s) => Object.assign(s, read));
  }
}

function worldOf(object: PointObject, i: number): Vector {
  const m = object.object.matrix.elements;
  const { x, y, z } = object.block;
  const row = (k: number) => m[k]! * x[i]! + m[4 + k]! * y[i]! + m[8 + k]! * z[i]! + m[12 + k]!;
  return [row(0), row(1), row(2)];
}

const blocksOf = (run: RunSession) =>
  [...run.view.drawn()].map((object) => ({ points: object.block, matrix: object.object.matrix.elements }));

function describe({ object, index, world }: Picked, run: RunSession): string {
  const { block } = object;
  const parts = [`x ${world[0].toFixed(2)}  y ${world[1].toFixed(2)}  z ${world[2].toFixed(2)} m`];
  if ((block.channels & 2) !== 0) parts.push(run.labelName(block.label[index]!).replace(/_/g, ' '));
  if ((block.channels & 1) !== 0) parts.push(`intensity ${block.intensity[index]}`);
  if ((block.channels & 8) !== 0) parts.push(`ring ${block.ring[index]}`);
  return parts.join('  ·  ');
}

const isSparse = (runs: readonly RunSession[]) =>
  runs.every(
    ({ table }) =>
      table.count > 0 && hasPose(table, 0) && table.points[0]! > 0 && table.points[0]! < kSparse_points,
  );
