import { readReport, text, type Report } from './data';
import { h } from './dom';
import { countTable, evaluationFacts, machineFacts, stageTable } from './facts';
import {
  heightFigures,
  labelFigures,
  odometryFigures,
  roadFigures,
  slopeFigures,
  timeFigures,
} from './figures';
import { planFigures } from './plan';
import { watchTheme } from './theme';
import { recordingName, summaryOf, warningsOf, type Warning } from './words';

/** A heading with what belongs to it; nothing without content. */
function section(title: string, content: (HTMLElement | null)[]): HTMLElement | null {
  const there = content.filter((element) => element !== null);
  return there.length > 0 ? h('section', {}, h('h2', {}, title), ...there) : null;
}

function warningItem(warning: Warning): HTMLElement {
  const details =
    warning.details.length > 0 ? h('ul', {}, ...warning.details.map((line) => h('li', {}, line))) : null;
  const mark = warning.level === 'bad' ? 'Warning' : 'Note';
  return h('li', { class: warning.level }, h('span', { class: 'mark' }, mark), ' ', warning.title, details);
}

function warningsSection(warnings: Warning[]): HTMLElement {
  if (warnings.length === 0) {
    return h(
      'section',
      { class: 'warnings' },
      h('h2', {}, 'Warnings'),
      h('p', {}, 'None: nothing was lost.'),
    );
  }
  return h(
    'section',
    { class: 'warnings' },
    h('h2', {}, 'Warnings'),
    h('ul', {}, ...warnings.map(warningItem)),
  );
}

function page(report: Report): (HTMLElement | null)[] {
  const whole = text(report.run, 'state') === 'whole';
  return [
    h(
      'header',
      {},
      h('h1', {}, recordingName(report)),
      h(
        'p',
        { class: 'quiet' },
        `A run of berm ${text(report.run, 'version')}, ${whole ? 'whole' : 'with losses'}`,
      ),
    ),
    warningsSection(warningsOf(report)),
    section(
      'Summary',
      summaryOf(report).map((sentence) => h('p', {}, sentence)),
    ),
    section('Where it drove', [...planFigures(report), ...heightFigures(report), ...odometryFigures(report)]),
    section('Road', roadFigures(report)),
    section('Along the run', [...slopeFigures(report), ...labelFigures(report)]),
    section('Against the truth', evaluationFacts(report)),
    section('Counts and losses', countTable(report)),
    section('Time per stage', [...stageTable(report), ...timeFigures(report)]),
    section('Machine and recording', machineFacts(report)),
    h(
      'footer',
      {},
      h('p', { class: 'quiet' }, `Report by berm ${report.version}. Everything is in this one file.`),
    ),
  ];
}

function start(): void {
  const place = document.getElementById('report')!;
  try {
    const report = readReport(document.getElementById('run')?.textContent ?? 'null');
    document.title = `${recordingName(report)} – berm report`;
    place.replaceChildren(...page(report).filter((element) => element !== null));
    watchTheme();
  } catch (error) {
    place.replaceChildren(h('p', { role: 'alert' }, error instanceof Error ? error.message : String(error)));
  }
}

start();
