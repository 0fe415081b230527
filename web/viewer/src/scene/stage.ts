import { Matrix4, PerspectiveCamera, Vector2, Vector3, Vector4, WebGLRenderer } from 'three';
import type { Eye } from '../data/level_of_detail';
import type { Vector } from '../data/model';
import type { DrawingSurface } from '../drawing_surface';
import type { CameraView } from '../view_state';
import { EyeDome } from './eye_dome';
import { aim, type Anchor } from './rig';
import type { RunView } from './run_view';

export interface Pane {
  readonly view: RunView;
  readonly camera: PerspectiveCamera;
  readonly eyeDome: EyeDome;
  /** On the page (CSS pixels), from the left and top of the canvas. */
  left: number;
  width: number;
  height: number;
}

/** The canvas: one pane for each run, side by side, all seen from the same place relative to their machines. */
export class Stage {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: WebGLRenderer;
  readonly panes: Pane[];
  edlStrength = 0;

  constructor(surface: DrawingSurface, views: readonly RunView[]) {
    this.canvas = surface.canvas;
    this.renderer = new WebGLRenderer({ ...surface });
    this.renderer.autoClear = false;
    // To ask whether a shader is right is to wait until it is translated, once for each; the tests see that they are.
    this.renderer.debug.checkShaderErrors = false;
    this.panes = views.map((view) => ({
      view,
      camera: new PerspectiveCamera(50, 1, 0.1, 2000),
      eyeDome: new EyeDome(),
      left: 0,
      width: 1,
      height: 1,
    }));
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** Takes the size from the page; true if it changed. */
  resize(): boolean {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const ratio = Math.min(2, window.devicePixelRatio);
    const size = this.renderer.getSize(new Vector2());
    if (size.x === width && size.y === height && this.pixelRatio === ratio) return false;
    this.renderer.setDrawingBufferSize(width, height, ratio);
    const gap = 2;
    const paneWidth = (width - gap * (this.panes.length - 1)) / this.panes.length;
    this.panes.forEach((pane, i) => {
      pane.left = Math.round(i * (paneWidth + gap));
      pane.width = Math.max(1, Math.floor(paneWidth));
      pane.height = Math.max(1, height);
      pane.camera.aspect = pane.width / pane.height;
    });
    return true;
  }

  aim(pane: Pane, view: CameraView, anchor: Anchor): void {
    aim(pane.camera, view, anchor);
  }

  /** `plain`: points alone, without eye-dome lighting, which is there in half the time where the processor draws. */
  render(plain = false): void {
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(0x2a3340, 1);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    for (const pane of this.panes) {
      this.renderer.setViewport(pane.left, 0, pane.width, pane.height);
      this.renderer.setScissor(pane.left, 0, pane.width, pane.height);
      const size = new Vector2(
        Math.round(pane.width * this.pixelRatio),
        Math.round(pane.height * this.pixelRatio),
      );
      pane.eyeDome.render(this.renderer, pane.view.points, pane.camera, size, plain ? 0 : this.edlStrength);
      if (!plain) this.renderer.render(pane.view.overlay, pane.camera);
    }
  }

  paneAt(x: number): Pane {
    return this.panes.find((pane) => x < pane.left + pane.width) ?? this.panes[this.panes.length - 1]!;
  }

  /** Takes points of an object at `matrix` to clip space. */
  clip(pane: Pane, matrix: Matrix4): Matrix4 {
    const { projectionMatrix, matrixWorldInverse } = pane.camera;
    return new Matrix4().multiplyMatrices(projectionMatrix, matrixWorldInverse).multiply(matrix);
  }

  /** CSS pixels of a place in the world, from the left and top of the canvas; undefined behind the camera. */
  project(pane: Pane, place: Vector): { x: number; y: number } | undefined {
    const at = new Vector4(...place, 1).applyMatrix4(this.clip(pane, new Matrix4()));
    if (at.w <= 0) return undefined;
    return { x: pane.left + ((at.x / at.w + 1) / 2) * pane.width, y: ((1 - at.y / at.w) / 2) * pane.height };
  }

  eye(pane: Pane): Eye {
    const m = this.clip(pane, new Matrix4()).elements;
    const row = (k: number) => [m[k]!, m[4 + k]!, m[8 + k]!, m[12 + k]!] as const;
    const plane = (k: number, sign: number) => {
      const [a, b] = [row(3), row(k)];
      return [a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2], a[3] + sign * b[3]] as const;
    };
    const { x, y, z } = pane.camera.getWorldPosition(new Vector3());
    const halfAngle = (pane.camera.fov / 2) * (Math.PI / 180);
    return {
      position: [x, y, z],
      pixelsPerRadian: pane.height / 2 / Math.tan(halfAngle),
      planes: [plane(0, 1), plane(0, -1), plane(1, 1), plane(1, -1), plane(2, 1)],
    };
  }

  /** A PNG of what is on the canvas. Drawn anew, since a canvas forgets its picture once it was on the screen. */
  async screenshot(): Promise<Blob> {
    this.render();
    return new Promise((resolve, reject) => {
      this.canvas.toBlob(
        (blob) => (blob === null ? reject(new Error('no picture came')) : resolve(blob)),
        'image/png',
      );
    });
  }
}
