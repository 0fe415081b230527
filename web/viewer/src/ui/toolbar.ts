import type { Actions } from '../commands';
import type { CameraName, ToolName, ViewState } from '../view_state';
import { iconButton, make, Segments } from './dom';

/** Over the picture: cameras, tools, what leaves the page. */
export class Toolbar {
  readonly root: HTMLElement;
  private readonly cameras: Segments<CameraName>;
  private readonly tools: Segments<Exclude<ToolName, 'none'>>;

  constructor(actions: Actions) {
    this.cameras = new Segments<CameraName>(
      'Camera',
      [
        { id: 'follow', title: 'Follow', key: 'F' },
        { id: 'top', title: 'Top', key: 'T' },
        { id: 'driver', title: 'Driver', key: 'V' },
        { id: 'free', title: 'Free', key: 'G' },
      ],
      (camera) => actions.setCamera(camera),
    );
    this.tools = new Segments<Exclude<ToolName, 'none'>>(
      'Tools',
      [
        { id: 'distance', title: 'Measure', key: 'M' },
        { id: 'profile', title: 'Profile', key: 'P' },
      ],
      (tool) => actions.setTool(tool),
    );
    this.root = make(
      'div',
      { class: 'toolbar', role: 'toolbar', 'aria-label': 'View' },
      this.cameras.root,
      this.tools.root,
      make(
        'div',
        { class: 'segments' },
        iconButton(
          'Save the picture',
          'M4 8 H8 L10 5 H14 L16 8 H20 V19 H4 Z M12 10 A3.5 3.5 0 1 0 12.01 10',
          'C',
          () => actions.screenshot(),
        ),
        iconButton(
          'Copy a link to this view',
          'M10 14 L14 10 M9 11 L6 14 A3.5 3.5 0 0 0 11 19 L13 16 M15 13 L18 10 A3.5 3.5 0 0 0 13 5 L11 8',
          'L',
          () => actions.copyLink(),
        ),
        iconButton('Keys and mouse', 'M9 9 A3 3 0 1 1 12 12.5 V14.5 M12 18 V18.5', '?', () =>
          actions.toggleHelp(),
        ),
        iconButton('Panel', 'M4 5 H20 V19 H4 Z M14 5 V19', 'B', () => actions.togglePanel()),
      ),
    );
  }

  sync(state: ViewState): void {
    this.cameras.select(state.camera);
    this.tools.select(state.tool as Exclude<ToolName, 'none'>);
  }
}
