import { make } from './dom';

const kShown_ms = 6000;

/** Short messages over the picture, read out by screen readers. */
export class Messages {
  readonly root = make('div', { class: 'messages', role: 'status', 'aria-live': 'polite' });
  private readonly seen = new Set<string>();

  say(text: string, hint = '', kind: 'note' | 'error' = 'note'): void {
    const box = make('div', { class: `message ${kind}` }, make('strong', {}, text));
    if (hint !== '') box.append(make('span', {}, hint));
    this.root.append(box);
    setTimeout(() => box.remove(), kShown_ms);
  }

  /** The same error of a hundred scans is said once. */
  error(error: unknown): void {
    const text = error instanceof Error ? error.message : String(error);
    if (this.seen.has(text)) return;
    this.seen.add(text);
    const hint = error instanceof Error && 'hint' in error ? String(error.hint) : '';
    this.say(text, hint, 'error');
  }
}
