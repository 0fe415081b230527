import { BufferAttribute, BufferGeometry, Matrix4, Points, type ShaderMaterial } from 'three';
import type { PointBlock } from '../data/points';
import type { PointStyle } from './point_material';

/** Points of one scan or tile on the graphics card: the arrays of the answer are handed over as they are. */
export class PointObject {
  readonly object: Points<BufferGeometry, ShaderMaterial>;

  constructor(
    readonly block: PointBlock,
    style: PointStyle,
  ) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('px', new BufferAttribute(block.x, 1));
    geometry.setAttribute('py', new BufferAttribute(block.y, 1));
    geometry.setAttribute('pz', new BufferAttribute(block.z, 1));
    geometry.setAttribute('intensity', new BufferAttribute(block.intensity, 1));
    geometry.setAttribute('label', new BufferAttribute(block.label, 1));
    geometry.setAttribute('time', new BufferAttribute(block.time, 1));
    geometry.setAttribute('ring', new BufferAttribute(block.ring, 1));
    geometry.setDrawRange(0, block.count);
    this.object = new Points(geometry, style.material(block.channels));
    // three.js looks for an attribute called position to know where the object is; whoever adds it knows better.
    this.object.frustumCulled = false;
    this.object.matrixAutoUpdate = false;
  }

  place(matrix: Matrix4): void {
    this.object.matrix.copy(matrix);
    this.object.matrixWorldNeedsUpdate = true;
  }

  set fade(value: number) {
    this.object.material.uniforms['uFade']!.value = value;
  }

  get hasGround(): boolean {
    return this.object.geometry.hasAttribute('ground');
  }

  setGround(distance_m: Float32Array<ArrayBuffer>): void {
    this.object.geometry.setAttribute('ground', new BufferAttribute(distance_m, 1));
  }

  dispose(): void {
    this.object.removeFromParent();
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
