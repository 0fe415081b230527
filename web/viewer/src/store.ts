import type { ViewState } from './view_state';

/** The one state of the page. Whoever changes it says so here; whoever shows it is told. */
export class Store {
  private readonly listeners: (() => void)[] = [];

  constructor(readonly state: ViewState) {}

  change(edit: (state: ViewState) => void): void {
    edit(this.state);
    for (const listener of this.listeners) listener();
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }
}
