import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { existsSync, mkdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { findBerm, startView, workOf, type View } from './berm_program';
import { collectComplaints, findChromium, launchChromium } from './browser';
import { repeatRecording } from './large_recording';

// A map of 1 km with 20 million points, and a recording of 10,000 scans. They take 0.8 GB, so that this is left out unless
// $BERM_LARGE names a folder for them; what is there already is taken as it is.
//   BERM_LARGE=~/large npx vitest run --config vitest.browser.config.ts test/large

const kScans = 10_000;
const folder = process.env['BERM_LARGE'] ?? '';
const berm = findBerm();
const canTry = folder !== '' && berm !== undefined && findChromium() !== undefined;
if (!canTry)
  console.warn('$BERM_LARGE is not set: no map of 20 million points and no 10,000 scans are tried');

/** Milliseconds between frames while the view is turned by keyboard, `steps` times. */
async function turn(page: Page, steps: number): Promise<number[]> {
  await page.evaluate(() => {
    const frames: number[] = [];
    Object.assign(window, { frames });
    const note = (now: number) => {
      frames.push(now);
      requestAnimationFrame(note);
    };
    requestAnimationFrame(note);
  });
  for (let i = 0; i < steps; ++i) await page.keyboard.press('a');
  const frames = await page.evaluate(() => (window as unknown as { frames: number[] }).frames);
  return frames.slice(1).map((frame, i) => frame - frames[i]!);
}

/** Not at once, as elsewhere: a test that says nothing for a minute is taken for dead. Exit code 3 is no failure. */
const call = (program: string, args: readonly string[]) =>
  promisify(execFile)(program, args).catch((error: unknown) => {
    if ((error as { code?: number }).code !== 3) throw error;
  });

const median = (values: readonly number[]) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;

describe.skipIf(!canTry)('large', () => {
  const [recording, run] = [join(folder, 'recording'), join(folder, 'run')];
  const views: View[] = [];
  let browser: Browser;
  let page: Page;
  let complaints: string[] = [];

  beforeAll(async () => {
    mkdirSync(folder, { recursive: true });
    const [drive, road] = [join(folder, 'drive'), join(folder, 'road')];
    if (!existsSync(join(recording, 'sequence.json'))) {
      await call(berm!, ['sim', 'groomer_clear', '-o', drive, '--seconds', '20', '--force', '-q']);
      repeatRecording(drive, recording, kScans);
    }
    if (!existsSync(join(run, 'map/tiles.json'))) {
      await call(berm!, ['sim', 'haul_road', '-o', road, '--seconds', '10', '--force', '-q']);
      await call(berm!, ['run', road, '-m', 'haul_truck', '-o', run, '--force', '-q']);
      const maker = process.env['BERM_LARGE_MAP'] ?? join(resolve(berm!, '..'), 'bench/berm_large_map');
      await call(maker, [run]);
    }
    browser = await launchChromium();
    page = await browser.newPage({ viewport: { width: 1200, height: 760 } });
    complaints = collectComplaints(page);
    await page.waitForTimeout(3000); // a new window prepares pages of its own
  }, 3_600_000);
  afterAll(async () => {
    views.forEach((view) => view.process.kill());
    await browser?.close();
  });

  const show = async (path: string, hash = ''): Promise<number> => {
    const view = await startView(berm!, [path]);
    views.push(view);
    await page.goto(view.url + hash, { waitUntil: 'commit' });
    await page.waitForSelector('canvas[data-scan]', { timeout: 120_000 });
    return performance.now() - view.started_ms;
  };

  test('a map of 20 million points', async () => {
    const scan_ms = await show(run, '#camera=free&view=500,0,0,900,250,35&colour=height');
    const since = (began_ms: number) => Math.round(performance.now() - began_ms);
    const began_ms = views.at(-1)!.started_ms;
    const until = (key: string, value: string) =>
      page.waitForSelector(`canvas[data-${key}="${value}"]`, { timeout: 240_000 });
    await until('map', 'whole');
    const open_ms = since(began_ms);
    await page.keyboard.press('3');
    await page.waitForFunction(() => location.hash.includes('colour=intensity'));
    const live_ms = since(began_ms);
    await until('waiting', '0');
    const whole_ms = since(began_ms);
    const frames = await turn(page, 40);
    console.log(
      `map: first picture ${Math.round(scan_ms)} ms after berm view, 1 km of map ${open_ms} ms, obeys a key ` +
        `${live_ms} ms, all detail of the view ${whole_ms} ms; a frame takes ${Math.round(median(frames))} ms while it turns; the server worked for ` +
        `${workOf(views.at(-1)!).toFixed(2)} s`,
    );
    await page.screenshot({ path: join(folder, 'map.png') });
    expect(complaints).toEqual([]);
  });

  test('a recording of 10,000 scans', async () => {
    const first_ms = await show(recording);
    const began = performance.now();
    await page.keyboard.press('End');
    await page.waitForSelector(`canvas[data-scan="${kScans - 1}"]`, { timeout: 60_000 });
    const end_ms = performance.now() - began;
    const frames = await turn(page, 40);
    console.log(
      `recording: first picture ${Math.round(first_ms)} ms after berm view, the last scan ${Math.round(end_ms)} ms ` +
        `after its key; a frame takes ${Math.round(median(frames))} ms while it turns; the server worked for ` +
        `${workOf(views.at(-1)!).toFixed(2)} s`,
    );
    await page.screenshot({ path: join(folder, 'recording.png') });
    expect(complaints).toEqual([]);
  });
});
