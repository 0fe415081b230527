import type { CameraView } from '../view_state';
import { orbit, pan, zoom } from './rig';

export interface PointerEvents {
  view(): CameraView;
  setView(view: CameraView): void;
  click(x: number, y: number): void;
  doubleClick(x: number, y: number): void;
  hover(x: number, y: number): void;
}

const kClick_px = 5;
const kOrbit_degPerPx = 0.3;

/** Mouse and fingers on the canvas: drag turns, right button or two fingers move, wheel or pinch comes nearer. */
export class PointerControl {
  private readonly down = new Map<number, { x: number; y: number }>();
  private moved_px = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly events: PointerEvents,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.press(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.release(event));
    canvas.addEventListener('pointercancel', (event) => this.down.delete(event.pointerId));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('dblclick', (event) => events.doubleClick(event.offsetX, event.offsetY));
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
  }

  private press(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (this.down.size === 1) this.moved_px = 0;
  }

  private move(event: PointerEvent): void {
    const before = this.down.get(event.pointerId);
    if (before === undefined) {
      this.events.hover(event.offsetX, event.offsetY);
      return;
    }
    const dx = event.offsetX - before.x;
    const dy = event.offsetY - before.y;
    this.moved_px += Math.hypot(dx, dy);
    if (this.down.size === 2) this.pinch(event, dx, dy);
    else if ((event.buttons & 2) !== 0 || event.shiftKey) this.slide(dx, dy);
    else if (this.moved_px > kClick_px)
      this.events.setView(orbit(this.events.view(), -dx * kOrbit_degPerPx, dy * kOrbit_degPerPx));
    this.down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
  }

  private pinch(event: PointerEvent, dx: number, dy: number): void {
    const other = [...this.down].find(([id]) => id !== event.pointerId)![1];
    const before = this.down.get(event.pointerId)!;
    const spread = (at: { x: number; y: number }) => Math.max(1, Math.hypot(at.x - other.x, at.y - other.y));
    const factor = spread(before) / spread({ x: event.offsetX, y: event.offsetY });
    this.events.setView(zoom(this.events.view(), factor));
    this.slide(dx / 2, dy / 2);
  }

  private slide(dx: number, dy: number): void {
    const height = Math.max(1, this.canvas.clientHeight);
    this.events.setView(pan(this.events.view(), -dx / height, dy / height));
  }

  private release(event: PointerEvent): void {
    const single = this.down.size === 1;
    this.down.delete(event.pointerId);
    if (single && this.moved_px <= kClick_px && event.button === 0)
      this.events.click(event.offsetX, event.offsetY);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    this.events.setView(zoom(this.events.view(), Math.exp(event.deltaY * lines * 0.0012)));
  }
}
