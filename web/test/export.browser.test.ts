import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { McapIndexedReader, McapStreamReader } from '@mcap/core';
import protobuf from 'protobufjs';
import 'protobufjs/ext/descriptor';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { findBerm, runBerm } from './berm_program';

// Files of `berm export`, opened by the readers that Foxglove itself uses.

const berm = findBerm();
const canExport =
  berm !== undefined && /^ +export /m.test(execFileSync(berm, ['--help'], { encoding: 'utf8' }));
if (!canExport) console.warn('No berm with `export` was built ($BERM_PROGRAM): its files are not read back');

const kScans = 5;
const folder = mkdtempSync(join(tmpdir(), 'berm-export-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

class Bytes {
  constructor(private readonly bytes: Uint8Array) {}
  size = () => Promise.resolve(BigInt(this.bytes.length));
  read = (offset: bigint, length: bigint) =>
    Promise.resolve(this.bytes.slice(Number(offset), Number(offset + length)));
}

interface FromDescriptor {
  fromDescriptor(bytes: Uint8Array): protobuf.Root;
}

const decode = (schema: { name: string; data: Uint8Array }, message: Uint8Array): Record<string, unknown> => {
  const root = (protobuf.Root as unknown as FromDescriptor).fromDescriptor(schema.data);
  const type = root.lookupType(schema.name);
  return type.toObject(type.decode(message), { longs: Number, defaults: true, arrays: true });
};

describe.skipIf(!canExport)('berm export --to foxglove', () => {
  let bytes: Uint8Array;
  let reader: McapIndexedReader;

  beforeAll(async () => {
    const recording = join(folder, 'recording');
    const out = join(folder, 'out');
    runBerm(berm!, ['sim', 'groomer_clear', '--seconds', String(kScans / 10), '-o', recording, '-q']);
    runBerm(berm!, ['run', recording, '--machine', 'groomer', '-o', out, '-q']);
    runBerm(berm!, ['export', out, '--to', 'foxglove', '-o', join(folder, 'run.mcap'), '-q']);
    bytes = readFileSync(join(folder, 'run.mcap'));
    reader = await McapIndexedReader.Initialize({ readable: new Bytes(bytes) });
  });

  test('its index leads to all messages, in the order of time', async () => {
    expect(reader.statistics?.messageCount).toBe(BigInt(3 * kScans));
    expect([...reader.channelsById.values()].map((channel) => channel.topic)).toEqual([
      '/points',
      '/tf',
      '/pose',
      '/edges',
    ]);
    let last = -1n;
    let count = 0;
    for await (const message of reader.readMessages({ topics: ['/points'] })) {
      expect(message.logTime).toBeGreaterThan(last);
      last = message.logTime;
      count += 1;
    }
    expect(count).toBe(kScans);
  });

  test('read as a stream its checksums hold', () => {
    const stream = new McapStreamReader({ validateCrcs: true });
    stream.append(bytes);
    const kinds = new Map<string, number>();
    for (let record = stream.nextRecord(); record !== undefined; record = stream.nextRecord())
      kinds.set(record.type, (kinds.get(record.type) ?? 0) + 1);
    expect(kinds.get('Message')).toBe(3 * kScans);
    expect(kinds.get('Footer')).toBe(1);
    expect(stream.done()).toBe(true);
  });

  test('its messages are those of their schemas', async () => {
    const seen = new Map<string, Record<string, unknown>>();
    for await (const message of reader.readMessages()) {
      const channel = reader.channelsById.get(message.channelId)!;
      expect(channel.messageEncoding).toBe('protobuf');
      seen.set(channel.topic, decode(reader.schemasById.get(channel.schemaId)!, message.data));
    }
    const cloud = seen.get('/points') as {
      frame_id?: string;
      frameId?: string;
      fields: { name: string }[];
      data: Uint8Array;
    } & Record<string, unknown>;
    expect(cloud.frame_id ?? cloud.frameId).toBe('base_link');
    expect(cloud.fields.map((field) => field.name)).toEqual([
      'x',
      'y',
      'z',
      'red',
      'green',
      'blue',
      'alpha',
      'intensity',
      'label',
      'ring',
    ]);
    const stride = (cloud['point_stride'] ?? cloud['pointStride']) as number;
    expect(stride).toBe(20);
    expect(cloud.data.length % stride).toBe(0);
    expect(cloud.data.length / stride).toBeGreaterThan(1000);
    const view = new DataView(cloud.data.buffer, cloud.data.byteOffset, cloud.data.byteLength);
    expect(Math.hypot(view.getFloat32(0, true), view.getFloat32(4, true))).toBeLessThan(300);
    const transform = seen.get('/tf') as { rotation: { w: number } };
    expect(Math.abs(transform.rotation.w)).toBeLessThanOrEqual(1);
    expect(seen.get('/pose')).toHaveProperty('pose.position.x');
  });
});
