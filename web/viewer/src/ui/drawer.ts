import { make } from './dom';

/** The strip below the picture that holds a plot, with a title and a way out. */
export class Drawer {
  readonly root: HTMLElement;
  readonly body = make('div', { class: 'drawer-body' });
  private readonly title = make('h2', {});
  private readonly extra = make('div', { class: 'drawer-extra' });

  constructor(name: string, close: () => void, ...extra: readonly Node[]) {
    const button = make('button', { type: 'button', class: 'text-button' }, 'Close');
    button.addEventListener('click', close);
    this.extra.append(...extra);
    this.root = make(
      'section',
      { class: 'drawer', 'aria-label': name },
      make('header', {}, this.title, this.extra, button),
      this.body,
    );
    this.root.hidden = true;
  }

  set heading(text: string) {
    if (this.title.textContent !== text) this.title.textContent = text;
  }

  /** True if it was not shown before: who draws into it must take its size anew. */
  show(visible: boolean): boolean {
    const changed = this.root.hidden === visible;
    this.root.hidden = !visible;
    return changed && visible;
  }
}
