import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { findBerm, runBerm, startView, type View } from './berm_program';
import { collectComplaints, findChromium, launchChromium } from './browser';

// A map of 1 km with 20 million points, and a recording of 10,000 scans. They take 1 GB and minutes to make, so that this
// is left out unless $BERM_LARGE names a folder for them; what is there already is taken as it is.
//   BERM_LARGE=/tmp/large npx vitest run --config vitest.browser.config.ts test/large

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

const median = (values: readonly number[]) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;

describe.skipIf(!canTry)('large', () => {
  const [recording, run] = [join(folder, 'recording'), join(folder, 'run')];
  const views: View[] = [];
  let browser: Browser;
  let page: Page;
  let complaints: string[] = [];

  beforeAll(async () => {
    mkdirSync(folder, { recursive: true });
    const long = ['--seconds', String(kScans / 10), '--set', 'vehicle.speed_m_per_s=0.38'];
    if (!existsSync(recording)) runBerm(berm!, ['sim', 'flat_road', '-o', recording, ...long, '-q']);
    if (!existsSync(run)) {
      runBerm(berm!, ['sim', 'haul_road', '-o', join(folder, 'short'), '--seconds', '10', '-q']);
      runBerm(berm!, ['run', join(folder, 'short'), '-m', 'haul_truck', '-o', run, '-q']);
    }
    const maker = process.env['BERM_LARGE_MAP'] ?? join(resolve(berm!, '..'), 'bench/berm_large_map');
    if (!existsSync(join(run, 'map'))) execFileSync(maker, [run]);
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
    const began_ms = views.at(-1)!.started_ms;
    await page.waitForFunction(
      () => Number(document.querySelector('canvas')?.dataset['tiles']) > 0,
      undefined,
      {
        timeout: 240_000,
      },
    );
    const map_ms = performance.now() - began_ms;
    await page.waitForFunction(
      () => document.querySelector('canvas')?.dataset['waiting'] === '0',
      undefined,
      {
        timeout: 240_000,
      },
    );
    const whole_ms = performance.now() - began_ms;
    const frames = await turn(page, 40);
    console.log(
      `map: first picture ${Math.round(scan_ms)} ms after berm view, first tiles ${Math.round(map_ms)} ms, ` +
        `all of the view ${Math.round(whole_ms)} ms; a frame takes ${Math.round(median(frames))} ms while it turns`,
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
        `after its key; a frame takes ${Math.round(median(frames))} ms while it turns`,
    );
    await page.screenshot({ path: join(folder, 'recording.png') });
    expect(complaints).toEqual([]);
  });
});
