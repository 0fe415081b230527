type Child = Node | string;

/** Builds an element. Text always becomes a text node: names from files are never markup. */
export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Readonly<Record<string, string>> = {},
  ...children: readonly Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

const kSvg = 'http://www.w3.org/2000/svg';

/** A line drawing of 24 x 24, for buttons that carry their name as a label for screen readers. */
export function icon(path: string): SVGElement {
  const svg = document.createElementNS(kSvg, 'svg');
  svg.setAttribute('viewBox', '0 0 24 24');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  const line = document.createElementNS(kSvg, 'path');
  line.setAttribute('d', path);
  svg.append(line);
  return svg;
}

export function iconButton(name: string, path: string, key: string, action: () => void): HTMLButtonElement {
  const title = key === '' ? name : `${name} (${key})`;
  const button = make(
    'button',
    { type: 'button', class: 'icon-button', title, 'aria-label': name },
    icon(path),
  );
  button.addEventListener('click', action);
  return button;
}

export function checkbox(label: string, onChange: (on: boolean) => void, ...extra: readonly Child[]) {
  const input = make('input', { type: 'checkbox' });
  input.addEventListener('change', () => onChange(input.checked));
  return {
    input,
    row: make('label', { class: 'check' }, input, ...extra, make('span', { class: 'check-text' }, label)),
  };
}

export function slider(
  label: string,
  range: { min: number; max: number; step: number },
  onInput: (value: number) => void,
) {
  const input = make('input', {
    type: 'range',
    min: String(range.min),
    max: String(range.max),
    step: String(range.step),
    'aria-label': label,
  });
  const value = make('output', { class: 'slider-value' });
  input.addEventListener('input', () => onInput(Number(input.value)));
  const set = (number: number, text: string) => {
    if (document.activeElement !== input || Number(input.value) !== number) input.value = String(number);
    value.textContent = text;
    input.setAttribute('aria-valuetext', text);
  };
  return { input, set, row: make('label', { class: 'slider' }, make('span', {}, label), input, value) };
}

/** Buttons of which one is on. */
export class Segments<T extends string> {
  readonly root: HTMLElement;
  private readonly buttons = new Map<T, HTMLButtonElement>();

  constructor(
    name: string,
    choices: readonly { id: T; title: string; key: string }[],
    choose: (id: T) => void,
    layout = 'segments',
  ) {
    this.root = make('div', { class: layout, role: 'group', 'aria-label': name });
    for (const { id, title, key } of choices) {
      const hint = make('kbd', { 'aria-hidden': 'true' }, key);
      const button = make('button', { type: 'button', 'data-id': id, 'aria-keyshortcuts': key }, title, hint);
      button.addEventListener('click', () => choose(id));
      this.buttons.set(id, button);
      this.root.append(button);
    }
  }

  select(chosen: T): void {
    for (const [id, button] of this.buttons) button.setAttribute('aria-pressed', String(id === chosen));
  }

  enable(id: T, enabled: boolean, reason: string): void {
    const button = this.buttons.get(id)!;
    button.disabled = !enabled;
    button.title = enabled ? '' : reason;
  }
}

export const grouped = (count: number) => count.toLocaleString('en').replace(/,/g, '\u202f');
