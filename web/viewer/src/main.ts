import 'uplot/dist/uPlot.min.css';
import './style.css';
import { App } from './app';
import { api } from './data/api';
import { DataError } from './data/errors';
import { RunSession } from './session';
import { make } from './ui/dom';

async function start(root: HTMLElement): Promise<void> {
  const infos = await api.runs();
  if (infos.length === 0)
    throw new DataError('there is nothing to show', 'Give berm view a run or a recording.');
  const runs = await Promise.all(infos.map((info) => RunSession.open(info)));
  document.title = `${infos.map((info) => info.name).join(' | ')} - berm view`;
  new App(runs, root);
}

const root = document.getElementById('app')!;
start(root).catch((error: unknown) => {
  const text = error instanceof Error ? error.message : String(error);
  const hint = error instanceof DataError ? error.hint : '';
  root.replaceChildren(
    make('div', { class: 'fatal', role: 'alert' }, make('h1', {}, text), make('p', {}, hint)),
  );
});
