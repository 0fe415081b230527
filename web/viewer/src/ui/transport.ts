import type { PoseTable } from '../data/poses';
import type { Timeline } from '../playback/clock';
import { kSpeeds } from '../view_state';
import type { Actions } from '../commands';
import { grouped, iconButton, icon, make } from './dom';

const kPlay = 'M7 4 L20 12 L7 20 Z';
const kPause = 'M8 4 V20 M16 4 V20';
const kHealthColours: Readonly<Record<number, string>> = { 2: '#e69f00', 3: '#d55e00' };

/** Play, step, speed and scrub; under the scrubber how each scan fared. */
export class Transport {
  readonly root: HTMLElement;
  private readonly play: HTMLButtonElement;
  private readonly scrub: HTMLInputElement;
  private readonly speed: HTMLSelectElement;
  private readonly text = make('div', { class: 'transport-text' });
  private readonly strip = make('canvas', {
    class: 'health',
    role: 'img',
    'aria-label': 'Points of each scan; orange: degraded, red: skipped',
    title: 'Points of each scan; orange: degraded, red: skipped',
  });
  private playing: boolean | undefined;

  constructor(
    actions: Actions,
    private readonly timeline: Timeline,
    private readonly table: PoseTable,
    seek: (time_s: number) => void,
    setSpeed: (speed: number) => void,
  ) {
    this.play = iconButton('Play', kPlay, 'Space', () => actions.togglePlay());
    this.play.classList.add('play');
    this.scrub = make('input', {
      type: 'range',
      class: 'scrub',
      min: '0',
      max: String(Math.max(1e-3, timeline.duration_s)),
      step: 'any',
      'aria-label': 'Time in the recording',
    });
    this.scrub.addEventListener('input', () => seek(Number(this.scrub.value)));
    this.scrub.addEventListener('keydown', (event) => this.stepByKey(event, actions));
    this.speed = make('select', { class: 'speed', 'aria-label': 'Speed' });
    for (const speed of kSpeeds) this.speed.append(make('option', { value: String(speed) }, `${speed} ×`));
    this.speed.addEventListener('change', () => setSpeed(Number(this.speed.value)));
    this.root = make(
      'footer',
      { class: 'transport', 'aria-label': 'Playback' },
      iconButton('Scan before', 'M18 5 L8 12 L18 19 Z M6 5 V19', '←', () => actions.step(-1)),
      this.play,
      iconButton('Next scan', 'M6 5 L16 12 L6 19 Z M18 5 V19', '→', () => actions.step(1)),
      this.speed,
      make('div', { class: 'scrub-box' }, this.scrub, this.strip),
      this.text,
    );
    new ResizeObserver(() => this.drawHealth()).observe(this.strip);
  }

  sync(time_s: number, playing: boolean, speed: number): void {
    if (this.playing !== playing) {
      this.playing = playing;
      const name = playing ? 'Pause' : 'Play';
      this.play.setAttribute('aria-label', name);
      this.play.title = `${name} (Space)`;
      this.play.replaceChildren(icon(playing ? kPause : kPlay));
    }
    const scan = this.timeline.scanAt(0, time_s);
    const text = `${time_s.toFixed(1)} s, scan ${scan + 1} of ${this.table.count}`;
    this.scrub.value = String(time_s);
    this.scrub.setAttribute('aria-valuetext', text);
    this.speed.value = String(speed);
    const points = this.table.points[scan] ?? 0;
    this.text.replaceChildren(
      make('b', {}, `${time_s.toFixed(1)} s`),
      ` / ${this.timeline.duration_s.toFixed(1)} s`,
      make('span', {}, `scan ${scan + 1} / ${this.table.count}`),
      make('span', {}, points > 0 ? `${grouped(points)} points` : ''),
    );
  }

  /** On the scrubber a key moves by whole scans. */
  private stepByKey(event: KeyboardEvent, actions: Actions): void {
    const steps: Readonly<Record<string, number>> = {
      ArrowRight: 1,
      ArrowLeft: -1,
      PageUp: 10,
      PageDown: -10,
    };
    const scans = steps[event.key];
    if (scans !== undefined) actions.step(event.shiftKey ? 10 * scans : scans);
    else if (event.key === 'Home') actions.goToStart();
    else if (event.key === 'End') actions.goToEnd();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private drawHealth(): void {
    const { clientWidth: width, clientHeight: height } = this.strip;
    this.strip.width = Math.max(1, width);
    this.strip.height = Math.max(1, height);
    const context = this.strip.getContext('2d');
    if (context === null) return;
    const most = this.table.points.reduce((high, points) => Math.max(high, points), 1);
    const step = width / Math.max(1, this.table.count);
    for (let i = 0; i < this.table.count; ++i) {
      context.fillStyle = kHealthColours[this.table.health[i]!] ?? '#3f6f8f';
      const tall = Math.max(2, (height * this.table.points[i]!) / most);
      context.fillRect(i * step, height - tall, Math.max(1, step), tall);
    }
  }
}
