import { DataError } from './errors';

const kRecordBytes = 44;

/** Stamps and poses, of scans or of a trajectory. */
export interface PoseTable {
  readonly count: number;
  /** Seconds since `startNs`. */
  readonly time_s: Float64Array;
  readonly startNs: bigint;
  readonly points: Uint32Array;
  /** Seven numbers each: x y z qx qy qz qw of T_world_base; all NaN where it is not known. */
  readonly pose: Float32Array;
  readonly health: Uint8Array;
}

/** Refuses an answer whose count is not the one of the bytes that are there, and stamps that run backwards. */
export function decodePoses(buffer: ArrayBuffer): PoseTable {
  if (buffer.byteLength < 4) throw new DataError(`poses: ${buffer.byteLength} bytes, expected a count`);
  const view = new DataView(buffer);
  const count = view.getUint32(0, true);
  if (buffer.byteLength !== 4 + count * kRecordBytes) {
    throw new DataError(
      `poses: ${count} announced take ${4 + count * kRecordBytes} bytes, ${buffer.byteLength} came`,
    );
  }
  const table = {
    count,
    startNs: count > 0 ? view.getBigInt64(4, true) : 0n,
    time_s: new Float64Array(count),
    points: new Uint32Array(count),
    pose: new Float32Array(7 * count),
    health: new Uint8Array(count),
  };
  for (let i = 0; i < count; ++i) {
    const at = 4 + i * kRecordBytes;
    // The difference of two stamps fits a double to the nanosecond; a stamp since 1970 does not.
    table.time_s[i] = Number(view.getBigInt64(at, true) - table.startNs) * 1e-9;
    if (i > 0 && table.time_s[i]! < table.time_s[i - 1]!)
      throw new DataError(`poses: stamp ${i} is before the one it follows`);
    table.points[i] = view.getUint32(at + 8, true);
    for (let k = 0; k < 7; ++k) table.pose[7 * i + k] = view.getFloat32(at + 12 + 4 * k, true);
    table.health[i] = view.getUint8(at + 40);
  }
  return table;
}

export function hasPose(table: PoseTable, i: number): boolean {
  return i >= 0 && i < table.count && Number.isFinite(table.pose[7 * i]!);
}

/** The last entry at or before `time_s`; the first one for times before it; -1 for an empty table. */
export function indexAt(table: PoseTable, time_s: number): number {
  let low = 0;
  let high = table.count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (table.time_s[middle]! <= time_s) low = middle + 1;
    else high = middle;
  }
  return table.count === 0 ? -1 : Math.max(0, low - 1);
}
