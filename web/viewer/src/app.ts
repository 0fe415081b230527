import { labelTexels, rampTexels } from './colours';
import { commandOf, type Actions } from './commands';
import { ByteCache } from './data/cache';
import { Loader } from './data/loader';
import type { Vector } from './data/model';
import type { Opening } from './data/opening';
import { kBytesPerPoint, type PointBlock } from './data/points';
import type { DrawingSurface } from './drawing_surface';
import { Measuring } from './measuring';
import { modeIndex, type Mode } from './modes';
import { anchorIn, type Page } from './page';
import { Picture } from './picture';
import { PisteLink } from './piste_link';
import { Clock, type Timeline } from './playback/clock';
import { Pointing } from './pointing';
import { PointerControl } from './scene/pointer_control';
import { kWorld, orbit, reanchor, zoom } from './scene/rig';
import { Stage } from './scene/stage';
import { autoRange, rampOf, RunSession, type Range } from './session';
import { Store } from './store';
import { make } from './ui/dom';
import { Help } from './ui/help';
import { Hud } from './ui/hud';
import { Messages } from './ui/messages';
import { Panel, type PanelFacts } from './ui/panel';
import { Toolbar } from './ui/toolbar';
import { Transport } from './ui/transport';
import * as state from './view_state';

const kCacheBytes = 256 * 2 ** 20;

/** The page: holds state, data, picture and controls together. */
export class App implements Actions, Page {
  readonly runs: readonly RunSession[];
  readonly store: Store;
  readonly timeline: Timeline;
  readonly clock: Clock;
  readonly stage: Stage;
  readonly loader: Loader<PointBlock>;
  readonly messages = new Messages();
  private readonly help = new Help();
  private readonly hud = new Hud();
  private readonly toolbar: Toolbar;
  private readonly panel: Panel;
  private readonly transport: Transport;
  private readonly picture: Picture;
  private readonly pointing: Pointing;
  private readonly measuring: Measuring;
  private readonly piste: PisteLink;
  private readonly facts: PanelFacts;
  private readonly manualRanges = new Map<Mode, Range>();
  private readonly root: HTMLElement;

  private dirty = true;
  private wantNew = true;
  private shown = '';
  private hashTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(opening: Opening, surface: DrawingSurface, root: HTMLElement) {
    const runs = opening.runs.map((run) => new RunSession(run));
    const { canvas } = surface;
    this.runs = runs;
    this.root = root;
    this.store = new Store(opening.state);
    this.timeline = opening.timeline;
    this.clock = new Clock(this.timeline.duration_s);
    this.clock.seek(this.store.state.time_s);
    this.clock.speed = this.store.state.speed;
    const cache = new ByteCache<PointBlock>(kCacheBytes, (block) => block.count * kBytesPerPoint);
    for (const [key, block] of opening.scans) cache.set(key, block);
    this.loader = new Loader(
      cache,
      () => (this.wantNew = true),
      (_, error) => {
        this.wantNew = true;
        this.messages.error(error);
      },
    );
    this.stage = new Stage(
      surface,
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
    const mark = (place: Vector | undefined) => this.mark(place);
    this.picture = new Picture(this);
    this.piste = new PisteLink(this, () => this.toggleLayer('piste'), mark);
    this.measuring = new Measuring(this, this.hud, () => this.setTool('none'), mark);
    this.pointing = new Pointing(this, this.hud, (pane, object, index) =>
      this.piste.point(this, pane, object, index),
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
    this.picture.direction = 1;
    this.wantNew = true;
    this.syncTime();
  }

  step(scans: number): void {
    this.picture.direction = Math.sign(scans);
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
    const before = anchorIn(this, this.stage.panes[0]!);
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

  // ---- Page

  redraw(): void {
    this.dirty = true;
  }

  reload(): void {
    this.wantNew = this.dirty = true;
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
      this.piste.root,
      this.measuring.chart.drawer.root,
      this.transport.root,
    );
    this.root.replaceChildren(left, this.panel.root, this.help.root);
    if (window.innerWidth < 760) this.root.classList.add('without-panel');
  }

  private listen(canvas: HTMLCanvasElement): void {
    new PointerControl(canvas, {
      view: () => this.store.state.view,
      setView: (view) => this.setView(view),
      click: (x, y) => this.pointing.click(x, y),
      doubleClick: (x, y) => this.pointing.lookAt(x, y),
      hover: (x, y) => (this.pointing.pointer = { x, y }),
    });
    canvas.addEventListener('pointerleave', () => {
      this.pointing.pointer = undefined;
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
      for (const layer of state.kLayers) this.picture.applyLayer(run, layer);
    }
    this.measuring.applyMarks();
    this.measuring.applyProfile();
    this.measuring.chart.drawer.show(s.tool === 'profile');
    this.piste.apply(s.layers.has('piste'));
    this.toolbar.sync(s);
    this.syncFacts();
    this.syncTime();
    this.wantNew = true;
    this.dirty = true;
    this.scheduleHash();
  }

  setView(view: state.CameraView): void {
    this.store.state.view = view;
    if (this.store.state.marks.length > 0) this.measuring.applyMarks();
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
    if (mode === 'ground') this.picture.addGround();
    this.panel.sync(this.store.state);
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
    if (this.clock.tick(now_ms, this.picture.isReady())) this.wantNew = true;
    if (wasPlaying) this.syncTime();
    if (wasPlaying && !this.clock.playing) this.scheduleHash();
    if (this.wantNew) this.show();
    if (this.dirty && (this.picture.hasBegun || this.picture.isReady())) this.draw();
    this.pointing.hover();
    requestAnimationFrame((next) => this.frame(next));
  }

  private draw(): void {
    this.dirty = false;
    for (const pane of this.stage.panes) this.stage.aim(pane, this.store.state.view, anchorIn(this, pane));
    this.stage.render(!this.picture.hasBegun);
    this.measuring.placeHud();
    if (this.picture.hasBegun) return;
    this.picture.hasBegun = true;
    setTimeout(() => this.apply()); // now the rest: lighting, layers, the scans to come
  }

  private show(): void {
    this.wantNew = false;
    const changed = this.picture.show();
    this.dirty ||= changed;
    Object.assign(this.stage.canvas.dataset, this.picture.counts());
    const shown = this.runs.map((run) => run.view.current).join();
    if (shown !== this.shown && this.runs.some((run) => run.view.current >= 0)) this.shownChanged(shown);
    this.piste.show();
    if (changed) this.measuring.applyProfile();
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

  private mark(place: Vector | undefined): void {
    for (const run of this.runs)
      run.view.mark(place, Math.max(0.05, this.store.state.view.distance_m * 0.006));
    this.dirty = true;
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
