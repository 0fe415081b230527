import type { Actions } from '../commands';
import { css, labelColour, rampColour } from '../colours';
import type { LabelName, RunInfo } from '../data/model';
import { kModes, modeIndex, type Mode } from '../modes';
import type { LayerName, ViewState } from '../view_state';
import { checkbox, grouped, make, Segments, slider } from './dom';

export interface PanelEvents {
  toggleLabel(name: string): void;
  setPointSize(pixels: number): void;
  setTrail(scans: number): void;
  setRange(mode: Mode, range: readonly [number, number] | undefined): void;
}

export interface PanelFacts {
  readonly runs: readonly RunInfo[];
  readonly labels: readonly LabelName[];
  /** Sum of Channels that any scan had so far. */
  channels: number;
  /** Points of each label id in the scans that are shown. */
  counts: ReadonlyMap<number, number>;
  range: readonly [number, number];
}

const kLayerNames: readonly (readonly [LayerName, string, string | undefined])[] = [
  ['scan', 'Scan', undefined],
  ['map', 'Map', 'map'],
  ['edges', 'Road edges', 'edges'],
  ['octree', 'Edge voxels', 'octree'],
  ['trajectory', 'Trajectory', 'trajectory'],
  ['global', 'Trajectory with GNSS', 'global_trajectory'],
  ['piste', 'Piste method, waveform', 'piste'],
  ['rings', 'Machine, rings of 5 to 50 m', undefined],
];

const pretty = (name: string) => name.replace(/_/g, ' ');

/** Everything that is set rather than played: colours and their legend, points, layers. */
export class Panel {
  readonly root: HTMLElement;
  private readonly modes: Segments<Mode>;
  private readonly legend = make('div', { class: 'legend' });
  private readonly labelRows = new Map<string, { input: HTMLInputElement; count: HTMLElement; id: number }>();
  private readonly labelList = make('div', { class: 'labels' });
  private readonly ramp = make('div', { class: 'ramp-box' });
  private readonly rampCanvas = make('canvas', {
    class: 'ramp',
    width: '256',
    height: '1',
    'aria-hidden': 'true',
  });
  private readonly low: HTMLInputElement;
  private readonly high: HTMLInputElement;
  private readonly unit = make('span', { class: 'unit' });
  private readonly size;
  private readonly trail;
  private readonly edl;
  private readonly layers = new Map<LayerName, HTMLInputElement>();
  private mode: Mode = 'label';

  constructor(
    private readonly facts: PanelFacts,
    actions: Actions,
    private readonly events: PanelEvents,
  ) {
    this.modes = new Segments(
      'Colour by',
      kModes.map((mode, i) => ({ id: mode.id, title: mode.title, key: String(i + 1) })),
      (mode) => actions.setMode(mode),
      'mode-grid',
    );
    this.low = this.rangeInput('Lowest value of the colours');
    this.high = this.rangeInput('Highest value of the colours');
    const auto = make('button', { type: 'button', class: 'text-button' }, 'Auto');
    auto.addEventListener('click', () => events.setRange(this.mode, undefined));
    this.ramp.append(
      this.rampCanvas,
      make('div', { class: 'ramp-range' }, this.low, this.unit, auto, this.high),
    );
    this.legend.append(this.labelList, this.ramp);
    this.fillLabels();

    this.size = slider('Size', { min: 1, max: 12, step: 0.5 }, (value) => events.setPointSize(value));
    this.trail = slider('Scans shown', { min: 1, max: 50, step: 1 }, (value) => events.setTrail(value));
    this.edl = checkbox('Eye-dome lighting', () => actions.toggleEdl());

    this.root = make(
      'aside',
      { class: 'panel', 'aria-label': 'Settings' },
      make('div', { class: 'runs' }, ...facts.runs.map((run, i) => this.runCard(run, i))),
      section('Colour by', this.modes.root, this.legend),
      section('Points', this.size.row, this.trail.row, this.edl.row),
      section('Layers', ...this.layerRows(actions)),
    );
  }

  sync(state: ViewState): void {
    this.mode = state.mode;
    this.modes.select(state.mode);
    for (const mode of kModes) {
      const there =
        mode.channel === 0 || this.facts.channels === 0 || (this.facts.channels & mode.channel) !== 0;
      this.modes.enable(mode.id, there, 'The recording does not have it');
    }
    this.size.set(state.pointSize, `${state.pointSize} px`);
    this.trail.set(state.trail, String(state.trail));
    this.edl.input.checked = state.edl;
    for (const [layer, input] of this.layers) input.checked = state.layers.has(layer) && !input.disabled;
    this.syncLegend(state);
  }

  private syncLegend(state: ViewState): void {
    this.ramp.hidden = state.mode === 'label';
    for (const [name, row] of this.labelRows) {
      row.input.checked = !state.hidden.has(name);
      const count = this.facts.counts.get(row.id) ?? 0;
      row.count.textContent = count > 0 ? grouped(count) : '';
    }
    if (state.mode === 'label') return;
    const mode = kModes[modeIndex(state.mode)]!;
    const context = this.rampCanvas.getContext('2d');
    for (let x = 0; context !== null && x < 256; ++x) {
      context.fillStyle = css(rampColour(mode.ramp, x / 255));
      context.fillRect(x, 0, 1, 1);
    }
    this.unit.textContent = mode.unit;
    const [low, high] = this.facts.range;
    if (document.activeElement !== this.low) this.low.value = String(Number(low.toFixed(2)));
    if (document.activeElement !== this.high) this.high.value = String(Number(high.toFixed(2)));
  }

  private fillLabels(): void {
    for (const { id, name } of this.facts.labels) {
      const swatch = make('span', { class: 'swatch' });
      swatch.style.background = css(labelColour(name, id));
      const count = make('span', { class: 'count' });
      const { input, row } = checkbox(pretty(name), () => this.events.toggleLabel(name), swatch);
      row.append(count);
      this.labelRows.set(name, { input, count, id });
      this.labelList.append(row);
    }
    if (this.facts.labels.length === 0)
      this.labelList.append(make('p', { class: 'hint' }, 'There are no labels.'));
  }

  private rangeInput(label: string): HTMLInputElement {
    const input = make('input', { type: 'number', step: 'any', 'aria-label': label });
    input.addEventListener('change', () => {
      const low = Number(this.low.value);
      const high = Number(this.high.value);
      if (Number.isFinite(low) && high > low) this.events.setRange(this.mode, [low, high]);
    });
    return input;
  }

  private runCard(run: RunInfo, i: number): HTMLElement {
    const detail = [run.machine, run.sensor, `${grouped(run.scans)} scans`]
      .filter((text) => text !== '')
      .join(' · ');
    const side = this.facts.runs.length > 1 ? `${i + 1}: ` : '';
    return make('div', { class: 'run' }, make('h1', {}, side + run.name), make('p', {}, detail));
  }

  private layerRows(actions: Actions): HTMLElement[] {
    return kLayerNames.map(([layer, title, needed]) => {
      const there = needed === undefined || this.facts.runs.some((run) => run.layers.has(needed));
      const { input, row } = checkbox(title, () => actions.toggleLayer(layer));
      input.disabled = !there;
      if (!there) row.title = 'Not among the files of the run';
      this.layers.set(layer, input);
      return row;
    });
  }
}

function section(title: string, ...content: readonly HTMLElement[]): HTMLElement {
  return make('section', {}, make('h2', {}, title), ...content);
}
