import type { Measurement } from '../tools/profile';
import type { ToolName } from '../view_state';
import { make } from './dom';

const kHints: Readonly<Record<ToolName, readonly string[]>> = {
  none: [],
  distance: ['Measure: click the first point', 'Measure: click the second point'],
  profile: ['Profile: click where it begins', 'Profile: click where it ends'],
};

const metres = (value: number) => `${value.toFixed(2)} m`;

/** Text over the picture: the point below the pointer, what the tool waits for, what it measured. */
export class Hud {
  readonly root: HTMLElement;
  private readonly pointText = make('div', { class: 'hud-point' });
  private readonly hint = make('div', { class: 'hud-hint', role: 'status' });
  private readonly label = make('div', { class: 'hud-label', 'data-test': 'measurement', role: 'status' });

  constructor() {
    this.label.hidden = true;
    this.hint.hidden = true;
    this.root = make('div', { class: 'hud' }, this.pointText, this.hint, this.label);
  }

  point(text: string): void {
    if (this.pointText.textContent !== text) this.pointText.textContent = text;
  }

  measurement(tool: ToolName, marks: number, measured: Measurement | undefined): void {
    const hint = kHints[tool][marks] ?? '';
    this.hint.hidden = hint === '';
    this.hint.textContent = hint;
    this.label.hidden = tool === 'none' || measured === undefined;
    if (measured === undefined) return;
    const grade = Number.isFinite(measured.grade_percent)
      ? `${measured.grade_percent.toFixed(1)} %`
      : 'plumb';
    this.label.replaceChildren(
      make('b', {}, metres(measured.distance_m)),
      make('span', {}, `across ${metres(measured.horizontal_m)}`),
      make('span', {}, `height ${metres(measured.height_m)}`),
      make('span', {}, `grade ${grade}`),
    );
  }

  /** Puts the measurement beside the middle of its line; undefined when that is behind the camera. */
  place(at: { x: number; y: number } | undefined): void {
    this.label.style.visibility = at === undefined ? 'hidden' : 'visible';
    if (at !== undefined)
      this.label.style.transform = `translate(${Math.round(at.x + 14)}px, ${Math.round(at.y - 14)}px)`;
  }
}
