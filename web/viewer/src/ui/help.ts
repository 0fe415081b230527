import { kCommands, type Command } from '../commands';
import { make } from './dom';

const kPretty: Readonly<Record<string, string>> = {
  ArrowRight: '→',
  ArrowLeft: '←',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Escape: 'Esc',
};

const pretty = (key: string) =>
  key.length === 1
    ? key
    : key
        .split('+')
        .map((part) => kPretty[part] ?? part)
        .join(' ');

/** The overlay that lists every key. A dialog of the browser: it takes the focus, and Escape closes it. */
export class Help {
  readonly root: HTMLDialogElement;

  constructor() {
    const groups = new Map<string, Command[]>();
    for (const command of kCommands)
      groups.set(command.group, [...(groups.get(command.group) ?? []), command]);
    const columns = [...groups].map(([group, commands]) =>
      make(
        'section',
        {},
        make('h3', {}, group),
        make(
          'dl',
          {},
          ...commands.flatMap((command) => [
            make('dt', {}, ...command.keys.map((key) => make('kbd', {}, pretty(key)))),
            make('dd', {}, command.text),
          ]),
        ),
      ),
    );
    const close = make('button', { type: 'button', class: 'text-button' }, 'Close');
    close.addEventListener('click', () => this.root.close());
    this.root = make(
      'dialog',
      { class: 'help', 'aria-label': 'Keys' },
      make('header', {}, make('h2', {}, 'Keys and mouse'), close),
      make(
        'p',
        {},
        'Drag turns the view, right button or Shift moves it, the wheel comes nearer. A double click looks at a point. ' +
          'With one finger the view turns, with two it moves and grows.',
      ),
      make('div', { class: 'help-columns' }, ...columns),
    );
  }

  toggle(): void {
    if (this.root.open) this.root.close();
    else this.root.showModal();
  }
}
