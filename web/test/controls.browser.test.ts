import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { decodeState } from '../viewer/src/view_state';
import { collectComplaints, findChromium, launchChromium } from './browser';
import { startMock } from './mock_server';
import { savePicture } from './pictures';

// Every control of the viewer does what it says: over made data, in the built pages.

const kDist = join(import.meta.dirname, '../dist/viewer');
const chromium = findChromium();
if (chromium === undefined) console.warn('No Chromium: the controls are not tried');

describe.skipIf(chromium === undefined)('the controls', () => {
  let browser: Browser;
  let mock: Awaited<ReturnType<typeof startMock>>;
  let page: Page;
  let complaints: string[] = [];

  beforeAll(async () => {
    browser = await launchChromium();
    mock = await startMock(['made'], kDist);
  });
  afterAll(async () => {
    await browser?.close();
    mock?.server.close();
  });

  const open = async (hash: string, url = mock.url) => {
    page = await browser.newPage({ viewport: { width: 1200, height: 760 }, acceptDownloads: true });
    page.setDefaultTimeout(90_000);
    complaints = collectComplaints(page);
    await page.goto(url + hash);
    await page.waitForSelector('canvas[data-scan]');
  };
  const close = async () => {
    expect(complaints).toEqual([]);
    await page.close();
  };
  const idle = async () => {
    await page.waitForSelector('canvas[data-waiting="0"]');
    await page.waitForTimeout(300);
  };
  const hashOf = async () => (await savePicture(page)).hash;
  const stateUntil = async (part: string) => {
    await page.waitForFunction((wanted) => location.hash.includes(wanted), part);
    return decodeState(new URL(page.url()).hash);
  };

  test('keys alone play, stop, step, jump and change the speed', async () => {
    await open('');
    const scan = (wanted: number) => page.waitForSelector(`canvas[data-scan="${wanted}"]`);
    const press = (...keys: string[]) =>
      keys.reduce((before, key) => before.then(() => page.keyboard.press(key)), Promise.resolve());
    await press('Shift+ArrowRight');
    await scan(10);
    await press('Shift+ArrowLeft', 'ArrowRight', '.', 'ArrowLeft');
    await scan(1);
    await press('ArrowUp', 'ArrowUp');
    expect((await stateUntil('speed=4')).speed).toBe(4);
    await press('ArrowDown', 'ArrowDown', 'ArrowDown');
    expect((await stateUntil('speed=0.5')).speed).toBe(0.5);
    await press('End');
    await scan(19);
    await press('Home');
    await scan(0);
    await press('Space');
    await page.waitForFunction(() => Number(document.querySelector('canvas')?.dataset['scan']) > 2);
    await press('Space');
    await close();
  });

  test('a layer that is put away or taken out changes the picture, and comes back as it was', async () => {
    await open('#layers=scan,map,edges,octree,trajectory,piste,rings&camera=follow');
    await page.waitForSelector('[aria-label=Waveform] canvas');
    await idle();
    const all = await hashOf();
    const seen = new Set([all]);
    const names = ['Scan', 'Map', 'Road edges', 'Edge voxels', 'Trajectory', 'Machine, rings of 5 to 50 m'];
    for (const name of names) {
      const box = page.getByRole('checkbox', { name, exact: true });
      await box.click();
      await idle();
      seen.add(await hashOf());
      await box.click();
    }
    for (const key of ['Shift+M', 'Shift+E', 'Shift+O', 'Shift+T', 'Shift+P']) {
      await page.keyboard.press(key);
      await idle();
      seen.add(await hashOf());
      await page.keyboard.press(key);
    }
    await idle();
    // A key does what its box does; the piste method was put away by its key alone.
    expect(seen.size).toBe(names.length + 2);
    expect(await page.getByRole('checkbox', { name: 'Trajectory with GNSS' }).isDisabled()).toBe(true);
    expect(await hashOf()).toBe(all);
    await close();
  });

  test('size of points, lighting, classes and scans together change the picture', async () => {
    await open('#layers=scan');
    await idle();
    const seen = [await hashOf()];
    for (const change of [
      () => page.keyboard.press(']'),
      () => page.keyboard.press('e'),
      () => page.getByRole('checkbox', { name: 'obstacle' }).click(),
      () => page.getByRole('checkbox', { name: 'drivable' }).click(),
      () => page.getByRole('slider', { name: 'Scans shown' }).fill('1'),
    ]) {
      await change();
      await idle();
      seen.push(await hashOf());
    }
    expect(new Set(seen).size).toBeGreaterThanOrEqual(5);
    const state = await stateUntil('hide=');
    expect([...state.hidden].sort()).toEqual(['drivable', 'obstacle']);
    expect(state.edl).toBe(false);
    expect(state.pointSize).toBe(3);
    await close();
  });

  test('each camera sees something else', async () => {
    await open('#layers=scan,rings');
    await idle();
    const seen = new Set<string>();
    for (const [key, name] of [
      ['f', 'follow'],
      ['t', 'top'],
      ['v', 'driver'],
    ] as const) {
      await page.keyboard.press(key);
      expect((await stateUntil(`camera=${name}`)).camera).toBe(name);
      await idle();
      seen.add(await hashOf());
    }
    expect(seen.size).toBe(3);
    const before = await hashOf();
    await page.keyboard.press('g'); // stays where it is, but not with the machine
    await stateUntil('camera=free');
    expect(await hashOf()).toBe(before);
    await close();
  });

  test('a point of the scan that is pointed at has its sample in the waveform', async () => {
    await open('#layers=scan,piste&trail=1');
    await page.waitForSelector('[aria-label=Waveform] canvas');
    await idle();
    const box = (await page.locator('canvas.canvas').boundingBox())!;
    const sample = page.locator('[aria-label=Waveform] .u-legend .u-series').first().locator('.u-value');
    const samples = new Set<string>();
    for (let i = 1; i < 30 && samples.size < 3; ++i) {
      const share = [(i * 0.37) % 0.8, (i * 0.23) % 0.6];
      await page.mouse.move(box.x + (0.1 + share[0]!) * box.width, box.y + (0.3 + share[1]!) * box.height);
      await page.waitForTimeout(100);
      if ((await page.locator('.hud-point').textContent()) === '') continue;
      const text = (await sample.textContent()) ?? '';
      if (/\d/.test(text)) samples.add(text);
    }
    expect(samples.size).toBe(3);
    await close();
  });

  test('a measurement tells distance, across, height and grade', async () => {
    await open('#tool=distance&marks=10,0,1;13,0,5');
    const label = page.locator('[data-test=measurement]');
    await label.waitFor();
    expect(await label.locator('b, span').allTextContents()).toEqual([
      '5.00 m',
      'across 3.00 m',
      'height 4.00 m',
      'grade 133.3 %',
    ]);
    await close();
  });

  test('two runs are turned together', async () => {
    const two = await startMock(['same', 'same again'], kDist);
    await open('#layers=rings&camera=follow', two.url);
    await idle();
    const pane = (await page.locator('canvas.canvas').boundingBox())!;
    const seen = new Set<string>();
    for (const place of [0, 0.25, 0.75]) {
      if (place > 0) {
        await page.mouse.move(pane.x + place * pane.width, pane.y + 200);
        await page.mouse.down();
        await page.mouse.move(pane.x + place * pane.width + 60, pane.y + 240, { steps: 3 });
        await page.mouse.up();
        await idle();
      }
      const picture = await savePicture(page);
      expect(picture.twice).toBe(true);
      seen.add(picture.hash);
    }
    expect(seen.size).toBe(3);
    await close();
    two.server.close();
  });
});
