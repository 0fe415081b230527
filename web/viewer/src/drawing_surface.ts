import { DataError } from './data/errors';
import { make } from './ui/dom';

/** Where the page draws. */
export interface DrawingSurface {
  readonly canvas: HTMLCanvasElement;
  readonly context: WebGL2RenderingContext;
}

/** What the panel and the playback bar take of the window (style.css). */
const kPanel_px = 280;
const kTransport_px = 53;
const kNarrow_px = 760;

/**
 * The canvas with its context. The browser needs longer for it than for anything else before the first picture, so it is
 * asked for before there is a page around it; at about the size that it will have, since another one means another buffer.
 */
export function makeDrawingSurface(): DrawingSurface {
  const canvas = make('canvas', { class: 'canvas', role: 'img', tabindex: '0', 'aria-label': '3D view' });
  const ratio = Math.min(2, window.devicePixelRatio);
  const panel_px = window.innerWidth < kNarrow_px ? 0 : kPanel_px;
  canvas.width = Math.max(1, Math.floor((window.innerWidth - panel_px) * ratio));
  canvas.height = Math.max(1, Math.floor((window.innerHeight - kTransport_px) * ratio));
  const context = canvas.getContext('webgl2', {
    alpha: true,
    antialias: true,
    depth: true,
    stencil: false,
    powerPreference: 'high-performance',
  });
  if (context === null)
    throw new DataError(
      'this browser cannot draw in 3D: it has no WebGL 2',
      'Is there a driver of the graphics card, and is hardware acceleration on? Where there is no card, Chromium draws ' +
        'with the processor if it is started with --enable-unsafe-swiftshader.',
    );
  return { canvas, context };
}
