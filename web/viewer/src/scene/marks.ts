import { Color, Group, Mesh, MeshBasicMaterial, Object3D, SphereGeometry } from 'three';
import type { Vector } from '../data/model';
import { SegmentBuilder } from './lines';

const kTint = 0xfff2a8;

/** What is measured: the marks, the line between them, and its foot and height. */
export function makeMarks(marks: readonly Vector[], scale_m: number): Object3D {
  const group = new Group();
  for (const mark of marks) {
    const ball = new Mesh(
      new SphereGeometry(scale_m, 16, 12),
      new MeshBasicMaterial({ color: kTint, depthTest: false }),
    );
    ball.position.set(...mark);
    ball.renderOrder = 2;
    group.add(ball);
  }
  const [a, b] = marks;
  if (a === undefined || b === undefined) return group;
  const low = a[2] < b[2] ? a : b;
  const high = a[2] < b[2] ? b : a;
  const corner: Vector = [high[0], high[1], low[2]];
  const strong = new SegmentBuilder();
  strong.add(a, b, new Color(kTint));
  const weak = new SegmentBuilder();
  weak.add(low, corner, new Color(0x9aa7b5));
  weak.add(corner, high, new Color(0x9aa7b5));
  for (const lines of [strong.build(3), weak.build(1.5)]) {
    // Seen through what it measures.
    lines.traverse((object) => {
      if (object instanceof Mesh) (object.material as MeshBasicMaterial).depthTest = false;
    });
    group.add(lines);
  }
  return group;
}
