import { Matrix4, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import type { Vector } from '../data/model';
import type { CameraView } from '../view_state';

const kDegree_rad = Math.PI / 180;

/** Where the machine is, levelled: position and heading; the camera moves along with it unless it is free. */
export interface Anchor {
  readonly position: Vector;
  readonly yaw_rad: number;
}

export const kWorld: Anchor = { position: [0, 0, 0], yaw_rad: 0 };

export function anchorOf(pose: Matrix4): Anchor {
  const forward = new Vector3(1, 0, 0).applyQuaternion(new Quaternion().setFromRotationMatrix(pose));
  const { x, y, z } = new Vector3().setFromMatrixPosition(pose);
  return { position: [x, y, z], yaw_rad: Math.atan2(forward.y, forward.x) };
}

export function toWorld(point: Vector, anchor: Anchor): Vector {
  const c = Math.cos(anchor.yaw_rad);
  const s = Math.sin(anchor.yaw_rad);
  const [x, y, z] = point;
  return [anchor.position[0] + c * x - s * y, anchor.position[1] + s * x + c * y, anchor.position[2] + z];
}

export function toAnchor(point: Vector, anchor: Anchor): Vector {
  const c = Math.cos(anchor.yaw_rad);
  const s = Math.sin(anchor.yaw_rad);
  const x = point[0] - anchor.position[0];
  const y = point[1] - anchor.position[1];
  return [c * x + s * y, -s * x + c * y, point[2] - anchor.position[2]];
}

/** The same place on the screen, told from another anchor. */
export function reanchor(view: CameraView, from: Anchor, to: Anchor): CameraView {
  const turn_deg = (from.yaw_rad - to.yaw_rad) / kDegree_rad;
  return {
    ...view,
    target: toAnchor(toWorld(view.target, from), to),
    azimuth_deg: view.azimuth_deg + turn_deg,
  };
}

export function aim(camera: PerspectiveCamera, view: CameraView, anchor: Anchor): void {
  const azimuth = view.azimuth_deg * kDegree_rad + anchor.yaw_rad;
  const elevation = view.elevation_deg * kDegree_rad;
  const target = new Vector3(...toWorld(view.target, anchor));
  const flat = Math.cos(elevation);
  camera.up.set(0, 0, 1);
  camera.position.set(Math.cos(azimuth) * flat, Math.sin(azimuth) * flat, Math.sin(elevation));
  camera.position.multiplyScalar(view.distance_m).add(target);
  camera.lookAt(target);
  camera.near = Math.min(0.5, Math.max(0.05, view.distance_m * 0.01));
  camera.far = Math.max(2000, view.distance_m * 20);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

export function orbit(view: CameraView, azimuth_deg: number, elevation_deg: number): CameraView {
  const elevation = Math.min(89.9, Math.max(-89.9, view.elevation_deg + elevation_deg));
  return { ...view, azimuth_deg: (view.azimuth_deg + azimuth_deg) % 360, elevation_deg: elevation };
}

/** Moves the target by parts of the distance: to the right and up on the screen. */
export function pan(view: CameraView, right: number, up: number): CameraView {
  const azimuth = view.azimuth_deg * kDegree_rad;
  const elevation = view.elevation_deg * kDegree_rad;
  const r = right * view.distance_m;
  const u = up * view.distance_m;
  const [x, y, z] = view.target;
  return {
    ...view,
    target: [
      x - Math.sin(azimuth) * r - Math.cos(azimuth) * Math.sin(elevation) * u,
      y + Math.cos(azimuth) * r - Math.sin(azimuth) * Math.sin(elevation) * u,
      z + Math.cos(elevation) * u,
    ],
  };
}

export function zoom(view: CameraView, factor: number): CameraView {
  return { ...view, distance_m: Math.min(1e5, Math.max(0.2, view.distance_m * factor)) };
}
