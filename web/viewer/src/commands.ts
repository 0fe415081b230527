import { kModes, type Mode } from './modes';
import type { CameraName, LayerName, ToolName } from './view_state';

/** What the page can do; buttons and keys call the same. */
export interface Actions {
  togglePlay(): void;
  step(scans: number): void;
  goToStart(): void;
  goToEnd(): void;
  changeSpeed(steps: number): void;
  setMode(mode: Mode): void;
  setCamera(camera: CameraName): void;
  turn(azimuth_deg: number, elevation_deg: number): void;
  zoom(factor: number): void;
  setTool(tool: ToolName): void;
  clearMarks(): void;
  toggleLayer(layer: LayerName): void;
  toggleEdl(): void;
  changePointSize(steps: number): void;
  screenshot(): void;
  copyLink(): void;
  toggleHelp(): void;
  togglePanel(): void;
}

export interface Command {
  /** As KeyboardEvent.key has it, with Shift+ before it where that matters. */
  readonly keys: readonly string[];
  readonly text: string;
  readonly group: 'Playback' | 'View' | 'Colour' | 'Tools' | 'Layers';
  run(actions: Actions): void;
}

const command = (keys: string, group: Command['group'], text: string, run: Command['run']): Command => ({
  keys: keys.split(' '),
  group,
  text,
  run,
});

/** Every key, as the help lists it. */
export const kCommands: readonly Command[] = [
  command('Space', 'Playback', 'Play or pause', (a) => a.togglePlay()),
  command('ArrowRight .', 'Playback', 'Next scan', (a) => a.step(1)),
  command('ArrowLeft ,', 'Playback', 'Scan before', (a) => a.step(-1)),
  command('Shift+ArrowRight', 'Playback', 'Ten scans on', (a) => a.step(10)),
  command('Shift+ArrowLeft', 'Playback', 'Ten scans back', (a) => a.step(-10)),
  command('Home', 'Playback', 'First scan', (a) => a.goToStart()),
  command('End', 'Playback', 'Last scan', (a) => a.goToEnd()),
  command('ArrowUp', 'Playback', 'Faster', (a) => a.changeSpeed(1)),
  command('ArrowDown', 'Playback', 'Slower', (a) => a.changeSpeed(-1)),
  command('f', 'View', 'Camera follows behind the machine', (a) => a.setCamera('follow')),
  command('t', 'View', 'Camera looks from the top', (a) => a.setCamera('top')),
  command('v', 'View', 'Camera sees what the driver sees', (a) => a.setCamera('driver')),
  command('g', 'View', 'Camera stays where it is', (a) => a.setCamera('free')),
  command('a', 'View', 'Turn left', (a) => a.turn(-5, 0)),
  command('d', 'View', 'Turn right', (a) => a.turn(5, 0)),
  command('w', 'View', 'Look from higher up', (a) => a.turn(0, 5)),
  command('s', 'View', 'Look from further down', (a) => a.turn(0, -5)),
  command('+ =', 'View', 'Nearer', (a) => a.zoom(0.85)),
  command('-', 'View', 'Farther', (a) => a.zoom(1 / 0.85)),
  command(']', 'View', 'Larger points', (a) => a.changePointSize(1)),
  command('[', 'View', 'Smaller points', (a) => a.changePointSize(-1)),
  command('e', 'View', 'Eye-dome lighting on or off', (a) => a.toggleEdl()),
  command('b', 'View', 'Panel on or off', (a) => a.togglePanel()),
  ...kModes.map((mode, i) => command(String(i + 1), 'Colour', mode.title, (a) => a.setMode(mode.id))),
  command('m', 'Tools', 'Measure distance and height', (a) => a.setTool('distance')),
  command('p', 'Tools', 'Height profile', (a) => a.setTool('profile')),
  command('x', 'Tools', 'Take the marks away', (a) => a.clearMarks()),
  command('Escape', 'Tools', 'Put the tool away', (a) => a.setTool('none')),
  command('c', 'Tools', 'Save the picture', (a) => a.screenshot()),
  command('l', 'Tools', 'Copy a link to this view', (a) => a.copyLink()),
  command('?', 'Tools', 'These keys', (a) => a.toggleHelp()),
  command('Shift+M', 'Layers', 'Map', (a) => a.toggleLayer('map')),
  command('Shift+E', 'Layers', 'Edges', (a) => a.toggleLayer('edges')),
  command('Shift+O', 'Layers', 'Octree', (a) => a.toggleLayer('octree')),
  command('Shift+T', 'Layers', 'Trajectory', (a) => a.toggleLayer('trajectory')),
  command('Shift+P', 'Layers', 'Piste method and waveform', (a) => a.toggleLayer('piste')),
];

const kShifted = /^([A-Z]|Arrow.*)$/;

/** The name of a pressed key in the table above. */
export function keyName(event: Pick<KeyboardEvent, 'key' | 'shiftKey'>): string {
  if (event.key === ' ') return 'Space';
  return event.shiftKey && kShifted.test(event.key) ? `Shift+${event.key}` : event.key;
}

/** The command of a key press; none while somebody types into a field or holds Ctrl, Alt or Meta. */
export function commandOf(event: KeyboardEvent): Command | undefined {
  if (event.ctrlKey || event.altKey || event.metaKey) return undefined;
  const name = keyName(event);
  const target = event.target;
  if (target instanceof HTMLInputElement) {
    const typing = target.type === 'number' || target.type === 'text';
    if (typing && name !== 'Escape') return undefined;
    if (target.type === 'range' && /Arrow|Home|End/.test(name)) return undefined;
    if (target.type === 'checkbox' && name === 'Space') return undefined;
  }
  if (target instanceof HTMLSelectElement) return undefined;
  if (target instanceof HTMLButtonElement && name === 'Space') return undefined;
  return kCommands.find((candidate) => candidate.keys.includes(name));
}
