import 'uplot/dist/uPlot.min.css';
import './style.css';
import { DataError } from './data/errors';
import { open } from './data/opening';
import { makeDrawingSurface } from './drawing_surface';
import { make } from './ui/dom';

/** The first picture waits for data, for code and for the browser's context: all three are asked for at once. */
async function start(root: HTMLElement): Promise<void> {
  const opening = open(location.hash);
  const code = import('./app');
  const surface = makeDrawingSurface();
  const [opened, { App }] = await Promise.all([opening, code]);
  document.title = `${opened.runs.map(({ info }) => info.name).join(' | ')} - berm view`;
  new App(opened, surface, root);
}

const root = document.getElementById('app')!;
start(root).catch((error: unknown) => {
  const text = error instanceof Error ? error.message : String(error);
  const hint = error instanceof DataError ? error.hint : '';
  root.replaceChildren(
    make('div', { class: 'fatal', role: 'alert' }, make('h1', {}, text), make('p', {}, hint)),
  );
});
