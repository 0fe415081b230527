import { DataError } from './errors';

const kRecordBytes = 20;

export interface Voxel {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly size_m: number;
  readonly side: 'left' | 'right';
  /** 0..1 */
  readonly probability: number;
}

export function decodeOctree(buffer: ArrayBuffer): Voxel[] {
  if (buffer.byteLength < 4) throw new DataError(`octree: ${buffer.byteLength} bytes, expected a count`);
  const view = new DataView(buffer);
  const count = view.getUint32(0, true);
  if (buffer.byteLength !== 4 + count * kRecordBytes) {
    throw new DataError(
      `octree: ${count} announced take ${4 + count * kRecordBytes} bytes, ${buffer.byteLength} came`,
    );
  }
  return Array.from({ length: count }, (_, i) => {
    const at = 4 + i * kRecordBytes;
    return {
      x: view.getFloat32(at, true),
      y: view.getFloat32(at + 4, true),
      z: view.getFloat32(at + 8, true),
      size_m: view.getFloat32(at + 12, true),
      side: view.getUint8(at + 16) === 0 ? 'left' : 'right',
      probability: view.getUint8(at + 17) / 255,
    };
  });
}
