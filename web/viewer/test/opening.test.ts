import { afterEach, describe, expect, test, vi } from 'vitest';
import { encodePoints, encodePoses, kLabels, madePoses, madeScan } from '../../test/made_data';
import { open, scanKey } from '../src/data/opening';

const run = (id: number) => ({ id, name: `run ${id}`, is_run: true, scans: 20, layers: { labels: true } });

/** A server of `count` runs that keeps in mind what it was asked for; `broken` is answered by nonsense. */
function serve(count: number, broken = ''): string[] {
  const asked: string[] = [];
  vi.stubGlobal('fetch', (path: string) => {
    asked.push(path);
    const [, , id, what, scan] = path.split('/');
    if (path === broken) return Promise.resolve(new Response('no more'));
    if (id === undefined)
      return Promise.resolve(Response.json(Array.from({ length: count }, (_, i) => run(i))));
    if (what === 'labels') return Promise.resolve(Response.json(kLabels));
    return Promise.resolve(
      new Response(scan === undefined ? encodePoses(madePoses()) : encodePoints(madeScan(Number(scan), 50))),
    );
  });
  return asked;
}

afterEach(() => vi.unstubAllGlobals());

describe('opening', () => {
  test('asks for all of the first picture before the first answer comes', async () => {
    const asked = serve(1);
    const opening = open('');
    expect([...asked].sort()).toEqual([
      'api/runs',
      'api/runs/0/labels',
      'api/runs/0/scans',
      'api/runs/0/scans/0',
    ]);
    const { runs, scans, state } = await opening;
    expect(asked).toHaveLength(4);
    expect(runs[0]!.table.count).toBe(20);
    expect(scans.get(scanKey(0, 0))!.count).toBe(50);
    expect(state.trail).toBe(8); // 6000 points a scan, with poses
  });

  test('asks for the scan of the time in the address, of every run', async () => {
    const asked = serve(2);
    const { scans, state } = await open('#t=0.35');
    expect([...scans.keys()]).toEqual([scanKey(0, 3), scanKey(1, 3)]);
    expect(asked).not.toContain('api/runs/0/scans/0');
    expect(state.trail).toBe(1);
  });

  test('a scan that is broken is left to whoever shows it', async () => {
    serve(1, 'api/runs/0/scans/0');
    expect((await open('')).scans.size).toBe(0);
  });

  test('says when there is nothing to show', async () => {
    serve(0);
    await expect(open('')).rejects.toThrow('nothing to show');
  });
});
