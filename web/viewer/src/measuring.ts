import { css, labelColour } from './colours';
import type { Vector } from './data/model';
import { shownLabels, type Page } from './page';
import { makeMarks } from './scene/marks';
import type { RunSession } from './session';
import { measure, profile } from './tools/profile';
import type { Hud } from './ui/hud';
import { ProfileChart } from './ui/profile_chart';

/** Marks in the picture, what they measure, and the profile between them. */
export class Measuring {
  readonly chart: ProfileChart;

  /** `mark` shows a place of the plot in the picture. */
  constructor(
    private readonly page: Page,
    private readonly hud: Hud,
    close: () => void,
    mark: (place: Vector | undefined) => void,
  ) {
    const run = page.runs[0]!;
    this.chart = new ProfileChart(
      close,
      (halfWidth_m) => page.store.change((s) => (s.halfWidth_m = halfWidth_m)),
      mark,
      (label) => css(labelColour(run.labelName(label), label)),
    );
  }

  applyMarks(): void {
    const { marks, tool } = this.page.store.state;
    const scale_m = Math.max(0.03, this.page.store.state.view.distance_m * 0.004);
    for (const run of this.page.runs)
      run.view.setLayer('marks', makeMarks(tool === 'none' ? [] : marks, scale_m));
    const [a, b] = marks;
    this.hud.measurement(tool, marks.length, a !== undefined && b !== undefined ? measure(a, b) : undefined);
  }

  /** The profile of what is drawn now: anew when marks, labels, scans or tiles change. */
  applyProfile(): void {
    const { marks, tool, halfWidth_m } = this.page.store.state;
    if (tool !== 'profile') return;
    const [a, b] = marks;
    if (a === undefined || b === undefined) {
      this.chart.show([], 0, halfWidth_m);
      return;
    }
    const points = this.page.runs.flatMap((run) =>
      profile(blocksOf(run), a, b, halfWidth_m, shownLabels(this.page, run)),
    );
    this.chart.show(points, Math.hypot(b[0] - a[0], b[1] - a[1]), halfWidth_m);
  }

  /** Puts the text beside the line it is about. */
  placeHud(): void {
    const [a, b] = this.page.store.state.marks;
    const pane = this.page.stage.panes[0]!;
    const middle: Vector | undefined =
      a && b ? [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2] : undefined;
    this.hud.place(middle === undefined ? undefined : this.page.stage.project(pane, middle));
  }
}

const blocksOf = (run: RunSession) =>
  [...run.view.drawn()].map((object) => ({ points: object.block, matrix: object.object.matrix.elements }));
