import {
  BoxGeometry,
  Color,
  ConeGeometry,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Object3D,
} from 'three';
import { kSideColours, type Colour } from '../colours';
import type { Edges } from '../data/model';
import type { Voxel } from '../data/octree';
import { hasPose, type PoseTable } from '../data/poses';
import { faded, SegmentBuilder } from './lines';

const sideColour = (side: string): Colour => kSideColours[side] ?? 0xffffff;

/** Lines of the road edges, coloured by side; uncertain pieces fade. */
export function makeEdges(edges: Edges): Object3D {
  const segments = new SegmentBuilder();
  for (const { vertices, confidence, side } of edges.lines) {
    const colour = sideColour(side);
    for (let i = 0; i + 1 < confidence.length; ++i) {
      const at = (k: number) => vertices.subarray(3 * k, 3 * k + 3);
      segments.add(
        at(i),
        at(i + 1),
        faded(colour, 0.2 + 0.8 * confidence[i]!),
        faded(colour, 0.2 + 0.8 * confidence[i + 1]!),
      );
    }
  }
  return segments.build(edges.truth ? 2 : 4);
}

export function makePath(poses: PoseTable, colour: Colour): Object3D {
  const segments = new SegmentBuilder();
  const tint = new Color(colour);
  for (let i = 1; i < poses.count; ++i) {
    if (!hasPose(poses, i - 1) || !hasPose(poses, i)) continue;
    segments.add(poses.pose.subarray(7 * i - 7, 7 * i - 4), poses.pose.subarray(7 * i, 7 * i + 3), tint);
  }
  return segments.build(2.5);
}

export function makeVoxels(voxels: readonly Voxel[]): Object3D {
  const material = new MeshBasicMaterial({ transparent: true, opacity: 0.75 });
  const mesh = new InstancedMesh(new BoxGeometry(0.92, 0.92, 0.92), material, Math.max(1, voxels.length));
  mesh.count = voxels.length;
  mesh.frustumCulled = false;
  const matrix = new Matrix4();
  voxels.forEach((voxel, i) => {
    matrix.makeScale(voxel.size_m, voxel.size_m, voxel.size_m).setPosition(voxel.x, voxel.y, voxel.z);
    mesh.setMatrixAt(i, matrix);
    mesh.setColorAt(i, faded(sideColour(voxel.side), 2 * voxel.probability - 0.8));
  });
  return mesh;
}

const kRings_m = [5, 10, 20, 30, 40, 50];

/** Circles around the machine, an arrow where it stands. In base_link. */
export function makeRings(): Object3D {
  const group = new Group();
  const segments = new SegmentBuilder();
  const kSteps = 96;
  for (const radius of kRings_m) {
    const tint = new Color(radius % 10 === 0 ? 0x5c6b7d : 0x3a4552);
    const at = (k: number) => {
      const angle = (2 * Math.PI * k) / kSteps;
      return [radius * Math.cos(angle), radius * Math.sin(angle), 0];
    };
    for (let k = 0; k < kSteps; ++k) segments.add(at(k), at(k + 1), tint);
  }
  for (const [x, y, colour] of [
    [1, 0, 0xd55e00],
    [0, 1, 0x009e73],
  ] as const) {
    segments.add([0, 0, 0], [3 * x, 3 * y, 0], new Color(colour));
  }
  group.add(segments.build(1.5));
  const arrow = new Mesh(new ConeGeometry(0.55, 1.8, 3), new MeshBasicMaterial({ color: 0xffffff }));
  arrow.rotation.set(0, 0, -Math.PI / 2);
  arrow.scale.set(1, 1, 0.3);
  arrow.position.z = 0.1;
  group.add(arrow);
  return group;
}
