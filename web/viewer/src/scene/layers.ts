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

/** Pieces of a path at most: each is some triangles, and where the processor draws 10,000 of them take seconds. */
const kMostPathPieces = 2000;
/** A step between poses that is worth a piece of its own. */
const kPathStep_m = 0.25;

/** The poses that a path is drawn through: those at least a step from the last one, -1 where it is interrupted. */
export function pathPoses(poses: PoseTable): number[] {
  const { pose } = poses;
  const apart = (i: number, k: number) =>
    Math.hypot(
      pose[7 * i]! - pose[7 * k]!,
      pose[7 * i + 1]! - pose[7 * k + 1]!,
      pose[7 * i + 2]! - pose[7 * k + 2]!,
    );
  let length_m = 0;
  for (let i = 1; i < poses.count; ++i)
    if (hasPose(poses, i - 1) && hasPose(poses, i)) length_m += apart(i - 1, i);
  const step_m = Math.max(kPathStep_m, length_m / kMostPathPieces);
  const kept: number[] = [];
  for (let i = 0; i < poses.count; ++i) {
    const last = kept.at(-1) ?? -1;
    if (!hasPose(poses, i)) {
      if (last >= 0) kept.push(-1);
      continue;
    }
    const isEnd = !hasPose(poses, i + 1);
    if (last < 0 || isEnd || apart(last, i) >= step_m) kept.push(i);
  }
  return kept;
}

export function makePath(poses: PoseTable, colour: Colour): Object3D {
  const segments = new SegmentBuilder();
  const tint = new Color(colour);
  const at = (i: number) => poses.pose.subarray(7 * i, 7 * i + 3);
  const kept = pathPoses(poses);
  kept.forEach((i, k) => {
    const before = kept[k - 1] ?? -1;
    if (i >= 0 && before >= 0) segments.add(at(before), at(i), tint);
  });
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
