import { Color, Object3D } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import type { Colour } from '../colours';

/** Pieces of lines of a width in pixels, each end with its colour. */
export class SegmentBuilder {
  private readonly positions: number[] = [];
  private readonly colours: number[] = [];

  add(from: ArrayLike<number>, to: ArrayLike<number>, fromColour: Color, toColour = fromColour): void {
    this.positions.push(from[0]!, from[1]!, from[2]!, to[0]!, to[1]!, to[2]!);
    this.colours.push(fromColour.r, fromColour.g, fromColour.b, toColour.r, toColour.g, toColour.b);
  }

  build(width_px: number, opacity = 1): Object3D {
    if (this.positions.length === 0) return new Object3D();
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(this.positions);
    geometry.setColors(this.colours);
    const material = new LineMaterial({
      linewidth: width_px,
      vertexColors: true,
      transparent: opacity < 1,
      opacity,
      // Lines lie in the surface they were found on: a little towards the eye keeps them from drowning in it.
      polygonOffset: true,
      polygonOffsetFactor: -4,
      polygonOffsetUnits: -64,
    });
    const object = new LineSegments2(geometry, material);
    object.frustumCulled = false;
    return object;
  }
}

/** A colour that fades into the background with `share` from 1 to 0. */
export function faded(colour: Colour, share: number): Color {
  return new Color(0x39424e).lerp(new Color(colour), Math.min(1, Math.max(0, share)));
}

export function disposeAll(root: Object3D): void {
  root.removeFromParent();
  root.traverse((object) => {
    const owner = object as Partial<{ geometry: { dispose(): void }; material: { dispose(): void } }>;
    owner.geometry?.dispose();
    owner.material?.dispose();
  });
}
