import {
  Color,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  Quaternion,
  Scene,
  SphereGeometry,
  Vector3,
} from 'three';
import type { Piste, Tile, Vector } from '../data/model';
import type { PointBlock } from '../data/points';
import { hasPose, type PoseTable } from '../data/poses';
import { makeRings } from './layers';
import { disposeAll, SegmentBuilder } from './lines';
import { PointStyle } from './point_material';
import { PointObject } from './point_object';
import { anchorOf, kWorld, type Anchor } from './rig';

/** T_world_base of a scan; where it is not known the world is the frame of the machine. */
export function poseMatrix(table: PoseTable, i: number): Matrix4 {
  if (!hasPose(table, i)) return new Matrix4();
  const [x, y, z, qx, qy, qz, qw] = table.pose.subarray(7 * i, 7 * i + 7);
  return new Matrix4().compose(
    new Vector3(x, y, z),
    new Quaternion(qx, qy, qz, qw).normalize(),
    new Vector3(1, 1, 1),
  );
}

/** Most points of tiles that stay on the graphics card, drawn or not. */
const kMaxTilePoints = 8e6;

/** What is drawn of one run: points go into one scene, lines and marks into one that is drawn over it. */
export class RunView {
  readonly points = new Scene();
  readonly overlay = new Scene();
  readonly style = new PointStyle();
  readonly layers = new Map<string, Object3D>();
  anchor: Anchor = kWorld;
  /** The newest scan that is drawn; -1 before the first has come. */
  current = -1;

  private readonly scans = new Map<number, PointObject>();
  private readonly tiles = new Map<number, PointObject>();
  private readonly machine = new Group();
  private readonly marker: Mesh;
  private piste: Object3D = new Object3D();

  constructor(private readonly table: PoseTable) {
    this.machine.add(makeRings());
    this.machine.matrixAutoUpdate = false;
    this.marker = new Mesh(
      new SphereGeometry(1, 16, 12),
      new MeshBasicMaterial({ color: 0xff5ac8, depthTest: false }),
    );
    this.marker.visible = false;
    this.marker.renderOrder = 2;
    this.overlay.add(this.machine, this.marker);
  }

  /** Draws these scans, newest first; those that have not come yet are left out, and older ones stay until they do. */
  showScans(wanted: readonly number[], blockOf: (scan: number) => PointBlock | undefined): void {
    const current = wanted[0];
    if (current === undefined) return;
    const blocks = wanted.map((scan) => ({ scan, block: this.scans.get(scan)?.block ?? blockOf(scan) }));
    if (blocks[0]?.block === undefined) return;
    for (const [scan, object] of this.scans) {
      if (wanted.includes(scan)) continue;
      object.dispose();
      this.scans.delete(scan);
    }
    blocks.forEach(({ scan, block }, age) => {
      if (block === undefined) return;
      const object = this.scans.get(scan) ?? this.addScan(scan, block);
      object.fade = 1 - (0.55 * age) / Math.max(1, wanted.length);
    });
    this.current = current;
    const pose = poseMatrix(this.table, current);
    this.anchor = hasPose(this.table, current) ? anchorOf(pose) : kWorld;
    this.machine.matrix.copy(pose);
    this.machine.matrixWorldNeedsUpdate = true;
  }

  get shownScans(): ReadonlyMap<number, PointObject> {
    return this.scans;
  }

  get shownTiles(): number {
    return [...this.tiles.values()].filter(({ object }) => object.visible).length;
  }

  hasTile(id: number): boolean {
    return this.tiles.has(id);
  }

  /** All points that are drawn now. */
  *drawn(): Generator<PointObject> {
    for (const objects of [this.scans, this.tiles]) {
      for (const object of objects.values()) if (object.object.visible) yield object;
    }
  }

  showTiles(chosen: readonly Tile[], blockOf: (tile: number) => PointBlock | undefined): void {
    for (const object of this.tiles.values()) object.object.visible = false;
    for (const { id } of chosen) {
      const kept = this.tiles.get(id);
      const block = kept?.block ?? blockOf(id);
      if (block === undefined) continue;
      const object = kept ?? new PointObject(block, this.style);
      if (kept === undefined) this.points.add(object.object);
      object.object.visible = true;
      this.tiles.delete(id); // to the end: most recently used
      this.tiles.set(id, object);
    }
    let total = 0;
    for (const object of this.tiles.values()) total += object.block.count;
    for (const [id, object] of this.tiles) {
      if (total <= kMaxTilePoints || object.object.visible) break;
      total -= object.block.count;
      object.dispose();
      this.tiles.delete(id);
    }
  }

  setLayer(name: string, object: Object3D): void {
    const old = this.layers.get(name);
    if (old !== undefined) disposeAll(old);
    this.layers.set(name, object);
    this.overlay.add(object);
  }

  set ringsVisible(visible: boolean) {
    this.machine.visible = visible;
  }

  set scansVisible(visible: boolean) {
    for (const object of this.scans.values()) object.object.visible = visible;
  }

  /** Marks a point of the scan that is shown, or a place in the world; undefined takes the mark away. */
  mark(place: Vector | undefined, radius_m = 0.15): void {
    this.marker.visible = place !== undefined;
    if (place === undefined) return;
    this.marker.position.set(...place);
    this.marker.scale.setScalar(radius_m);
  }

  /** Petals as lines along the firing order, steps as short posts; on the points of scan `i`. */
  showPiste(i: number, piste: Piste | undefined): void {
    disposeAll(this.piste);
    const object = this.scans.get(i);
    this.piste =
      piste === undefined || object === undefined ? new Object3D() : makePiste(piste, object.block);
    this.piste.matrixAutoUpdate = false;
    this.piste.matrix.copy(poseMatrix(this.table, i));
    this.overlay.add(this.piste);
  }

  private addScan(scan: number, block: PointBlock): PointObject {
    const object = new PointObject(block, this.style);
    object.place(poseMatrix(this.table, scan));
    this.scans.set(scan, object);
    this.points.add(object.object);
    return object;
  }
}

const kStepPost_m = 0.2;
/** Farther apart, two samples that follow each other lie on different things: a flake and the snow behind it. */
const kMaxLink_m = 2;

const near = (a: Vector, b: Vector) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < kMaxLink_m;

function makePiste(piste: Piste, block: PointBlock): Object3D {
  const segments = new SegmentBuilder();
  const at = (k: number): Vector | undefined => {
    const i = piste.shown[k]!;
    return i >= 0 && i < block.count ? [block.x[i]!, block.y[i]!, block.z[i]!] : undefined;
  };
  piste.petals.forEach(([first, last], petal) => {
    const tint = new Color(petal % 2 === 0 ? 0x56b4e9 : 0xcc79a7);
    let before: Vector | undefined;
    for (let k = Math.max(0, first); k <= Math.min(last, piste.z.length - 1); ++k) {
      const here = at(k);
      if (here !== undefined && before !== undefined && near(before, here)) segments.add(before, here, tint);
      before = here ?? before;
    }
  });
  const tint = new Color(0xff5ac8);
  for (const k of piste.steps) {
    const here = at(k);
    if (here !== undefined) segments.add(here, [here[0], here[1], here[2] + kStepPost_m], tint);
  }
  return segments.build(2);
}
