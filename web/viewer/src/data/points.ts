import { DataError } from './errors';

/** "BRM1" in the file. */
export const kPointsMagic = 0x314d5242;
export const kPointsHeaderBytes = 16;
export const kBytesPerPoint = 16;

export const Channel = { intensity: 1, label: 2, time: 4, ring: 8 } as const;

/** Points of a scan (base_link) or of a tile of the map (world): views into the answer, nothing is copied. */
export interface PointBlock {
  readonly count: number;
  /** Sum of the Channels that are real; the arrays of the others hold zeros. */
  readonly channels: number;
  readonly x: Float32Array<ArrayBuffer>;
  readonly y: Float32Array<ArrayBuffer>;
  readonly z: Float32Array<ArrayBuffer>;
  readonly intensity: Uint8Array<ArrayBuffer>;
  readonly label: Uint8Array<ArrayBuffer>;
  readonly time: Uint8Array<ArrayBuffer>;
  readonly ring: Uint8Array<ArrayBuffer>;
}

/** Refuses an answer whose count is not the one of the bytes that are there. */
export function decodePoints(buffer: ArrayBuffer): PointBlock {
  if (buffer.byteLength < kPointsHeaderBytes) {
    throw new DataError(`points: ${buffer.byteLength} bytes, expected a header of ${kPointsHeaderBytes}`);
  }
  const header = new DataView(buffer);
  const magic = header.getUint32(0, true);
  if (magic !== kPointsMagic)
    throw new DataError(`points: begin with 0x${magic.toString(16)}, expected BRM1`);
  const count = header.getUint32(4, true);
  const expected = kPointsHeaderBytes + count * kBytesPerPoint;
  if (buffer.byteLength !== expected) {
    throw new DataError(`points: ${count} announced take ${expected} bytes, ${buffer.byteLength} came`);
  }
  const floats = (i: number) => new Float32Array(buffer, kPointsHeaderBytes + 4 * count * i, count);
  const bytes = (i: number) => new Uint8Array(buffer, kPointsHeaderBytes + count * (12 + i), count);
  return {
    count,
    channels: header.getUint32(12, true),
    x: floats(0),
    y: floats(1),
    z: floats(2),
    intensity: bytes(0),
    label: bytes(1),
    time: bytes(2),
    ring: bytes(3),
  };
}
