import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { decodePoses, hasPose } from '../viewer/src/data/poses';
import { anchorOf, kWorld, toAnchor } from '../viewer/src/scene/rig';
import { poseMatrix } from '../viewer/src/scene/run_view';
import { decodeState } from '../viewer/src/view_state';
import { findBerm, findData, runBerm, startView, type View } from './berm_program';
import { collectComplaints, findChromium, launchChromium } from './browser';
import { startMock } from './mock_server';
import { savePicture } from './pictures';

/** Where there is no graphics card and the processor is shared, a picture can take long. */
const kPatience_ms = 90_000;
const kSize = { width: 1200, height: 760 };
const kDist = join(import.meta.dirname, '../dist/viewer');
const chromium = findChromium();
const berm = findBerm();
const data = findData();
if (chromium === undefined) console.warn('No Chromium: the pages are not tested in a browser');
if (berm === undefined)
  console.warn('No berm with `view` was built ($BERM_PROGRAM): only made data are looked at');

let browser: Browser;
const folder = mkdtempSync(join(tmpdir(), 'berm-viewer-'));
beforeAll(async () => {
  if (chromium !== undefined) browser = await launchChromium();
});
afterAll(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

interface Opened {
  readonly page: Page;
  readonly complaints: string[];
}

async function open(url: string, hash = ''): Promise<Opened> {
  const page = await browser.newPage({ viewport: kSize, acceptDownloads: true });
  page.setDefaultTimeout(kPatience_ms);
  const complaints = collectComplaints(page);
  await page.goto(url + hash);
  await page.waitForSelector('canvas[data-scan]', { timeout: kPatience_ms });
  return { page, complaints };
}

const scanOf = async (page: Page) =>
  Number((await page.getAttribute('canvas.canvas', 'data-scan'))?.split(',')[0]);

async function waitForScan(page: Page, scan: number): Promise<void> {
  await page.waitForSelector(`canvas[data-scan="${scan}"], canvas[data-scan^="${scan},"]`, {
    timeout: 60_000,
  });
}

/** What must hold for every run, made or real. `scans`: how many it has. `ground_m`: where ground is ahead, in the frame of the machine. */
function checkRun(start: () => Promise<string>, scans: number, ground_m: number): void {
  let url = '';
  beforeAll(async () => {
    url = await start();
  });

  test('plays, steps and scrubs by keyboard', async () => {
    const { page, complaints } = await open(url);
    expect(await scanOf(page)).toBe(0);
    await page.keyboard.press('ArrowRight');
    await waitForScan(page, 1);
    await page.keyboard.press('Space');
    await page.waitForFunction(
      () => Number(document.querySelector('canvas')?.dataset['scan']?.split(',')[0]) >= 3,
    );
    await page.keyboard.press('Space');
    const paused = await scanOf(page);
    await page.waitForTimeout(500);
    expect(Math.abs((await scanOf(page)) - paused)).toBeLessThanOrEqual(1);
    await page.keyboard.press('End');
    await waitForScan(page, scans - 1);
    await page.keyboard.press('Home');
    await waitForScan(page, 0);
    const scrub = (await page.locator('.scrub').boundingBox())!;
    await page.mouse.click(scrub.x + scrub.width / 2, scrub.y + scrub.height / 2);
    await page.waitForFunction(
      () => Number(document.querySelector('canvas')?.dataset['scan']?.split(',')[0]) > 0,
    );
    expect(Math.abs((await scanOf(page)) - scans / 2)).toBeLessThanOrEqual(2);
    expect(complaints).toEqual([]);
    await page.close();
  });

  test('shows another picture for another way to colour, and never a blank one', async () => {
    const { page, complaints } = await open(url, '#layers=scan,rings&size=3');
    const hashes = new Set<string>();
    let modes = 0;
    for (let key = 1; key <= 6; ++key) {
      if (await page.locator(`.mode-grid button:nth-child(${key})`).isDisabled()) continue;
      await page.keyboard.press(String(key));
      const picture = await savePicture(page);
      expect(picture.bright).toBeGreaterThan(0.005);
      expect(picture.colours).toBeGreaterThan(20);
      hashes.add(picture.hash);
      ++modes;
    }
    expect(modes).toBeGreaterThanOrEqual(4);
    expect(hashes.size).toBe(modes);
    expect(complaints).toEqual([]);
    await page.close();
  });

  test('measures a distance that is known from the camera', async () => {
    const distance_m = 30;
    const table = decodePoses(await (await fetch(`${url}api/runs/0/scans`)).arrayBuffer());
    const machine = hasPose(table, 0) ? anchorOf(poseMatrix(table, 0)) : kWorld;
    const { page, complaints } = await open(
      url,
      `#camera=top&view=${ground_m},0,0,${distance_m},180,89.9&tool=distance&trail=5&hide=falling_snow`,
    );
    await page.waitForTimeout(500);
    const box = (await page.locator('canvas.canvas').boundingBox())!;
    const pixels = 240;
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2 + pixels / 2];
    await page.mouse.click(x, y);
    await page.waitForFunction(() => document.querySelector('.hud-hint')?.textContent?.includes('second'));
    await page.mouse.click(x, y - pixels);
    await page.locator('[data-test=measurement]').waitFor({ state: 'visible' });
    await page.waitForFunction(() => location.hash.includes(';'));
    const marks = decodeState(new URL(page.url()).hash).marks.map((mark) => toAnchor(mark, machine));
    // A pinhole straight above looks down; what is to the front of the machine is up on the screen.
    const focal_px = box.height / 2 / Math.tan((25 * Math.PI) / 180);
    marks.forEach(([forward, left, up], k) => {
      const scale = focal_px / (distance_m - up);
      expect(Math.abs(left * scale)).toBeLessThan(12);
      expect(Math.abs((forward - ground_m) * scale - (k - 0.5) * pixels)).toBeLessThan(12);
    });
    const text = (await page.locator('[data-test=measurement]').textContent()) ?? '';
    const [a, b] = marks;
    const apart_m = Math.hypot(b![0] - a![0], b![1] - a![1], b![2] - a![2]);
    expect(Math.abs(Number(/^([\d.]+) m/.exec(text)?.[1]) - apart_m)).toBeLessThan(0.01);
    expect(apart_m).toBeGreaterThan(5);
    expect(complaints).toEqual([]);
    await page.close();
  });

  test('shows the same from the same address', async () => {
    const { page } = await open(url, '#t=0.35&colour=height&camera=driver&size=4&layers=scan,rings');
    await waitForScan(page, 3);
    await page.keyboard.press('a');
    await page.waitForFunction(() => location.hash.includes('175'));
    const first = await savePicture(page);
    const address = page.url();
    await page.close();
    const again = await open(address);
    await waitForScan(again.page, 3);
    expect((await savePicture(again.page)).hash).toBe(first.hash);
    expect(again.complaints).toEqual([]);
    await again.page.close();
  });
}

describe.skipIf(chromium === undefined)('made data', () => {
  let mock: Awaited<ReturnType<typeof startMock>>;
  const start = async () => (mock = await startMock(['made <img src=x onerror=alert(1)>'], kDist)).url;
  checkRun(start, 20, 14);
  afterAll(() => mock.server.close());

  test('markup in a name stays text', async () => {
    const { page, complaints } = await open(mock.url);
    expect(await page.locator('.run h1').textContent()).toBe('made <img src=x onerror=alert(1)>');
    expect(await page.locator('img').count()).toBe(0);
    expect(complaints).toEqual([]);
    await page.close();
  });

  test('a profile holds points, a waveform finds the point below the cursor', async () => {
    const { page, complaints } = await open(
      mock.url,
      '#tool=profile&marks=12,-8,1;12,8,1&layers=scan,map,piste',
    );
    await page.waitForFunction(() =>
      /[1-9]\d* points/.test(document.querySelector('[aria-label="Height profile"] h2')?.textContent ?? ''),
    );
    await page.keyboard.press('Escape');
    await page.waitForSelector('[aria-label=Waveform] canvas');
    expect(await page.locator('[aria-label=Waveform] h2').textContent()).toContain('10 petals');
    const plot = (await page.locator('[aria-label=Waveform] .u-over').boundingBox())!;
    const before = await savePicture(page);
    await page.mouse.move(plot.x + plot.width / 2, plot.y + plot.height / 2);
    await page.waitForTimeout(300);
    expect((await savePicture(page)).hash).not.toBe(before.hash);
    expect(complaints).toEqual([]);
    await page.close();
  });

  test('a scan that is broken is said, and the others are still shown', async () => {
    const { page } = await open(mock.url);
    await page.route('**/api/runs/0/scans/1', (route) =>
      route.fulfill({ body: Buffer.from('BRM1 but no more') }),
    );
    await page.reload();
    await page.waitForSelector('canvas[data-scan]');
    await page.waitForSelector('.message.error');
    expect(await page.locator('.message.error').first().textContent()).toContain('points:');
    await page.keyboard.press('End');
    await waitForScan(page, 19);
    await page.close();
  });

  test('keys are listed, and Escape closes the list', async () => {
    const { page } = await open(mock.url);
    await page.keyboard.press('?');
    expect(await page.locator('dialog.help').isVisible()).toBe(true);
    expect(await page.locator('dialog.help dt').count()).toBeGreaterThan(30);
    await page.keyboard.press('Escape');
    expect(await page.locator('dialog.help').isVisible()).toBe(false);
    await page.close();
  });

  test('everything that can be pressed has a name', async () => {
    const { page } = await open(mock.url);
    const nameless = await page.evaluate(
      () =>
        [...document.querySelectorAll('button, input, select, canvas[role]')].filter(
          (element) =>
            !(
              element.getAttribute('aria-label') ??
              element.closest('label')?.textContent ??
              element.textContent
            )?.trim(),
        ).length,
    );
    expect(nameless).toBe(0);
    await page.close();
  });

  test('two runs stand side by side and keep step', async () => {
    const two = await startMock(['one', 'two'], kDist);
    const { page, complaints } = await open(two.url);
    expect(await page.locator('.pane-title').allTextContents()).toEqual(['one', 'two']);
    await page.keyboard.press('End');
    await page.waitForSelector('canvas[data-scan="19,19"]');
    expect((await savePicture(page)).bright).toBeGreaterThan(0.005);
    expect(complaints).toEqual([]);
    await page.close();
    two.server.close();
  });

  test('each of two runs has its steps and its waveform', async () => {
    const two = await startMock(['one', 'two'], kDist);
    const { page, complaints } = await open(two.url, '#layers=scan,piste');
    for (const name of ['one', 'two']) {
      const drawer = page.locator(`[aria-label="Waveform of ${name}"]`);
      await drawer.locator('canvas').waitFor();
      expect(await drawer.locator('h2').textContent()).toContain('10 petals');
      const pane = (await page.locator('.pane-title', { hasText: name }).boundingBox())!;
      const plot = (await drawer.locator('.u-over').boundingBox())!;
      expect(plot.x + plot.width / 2).toBeGreaterThan(pane.x);
      const before = await savePicture(page);
      await page.mouse.move(plot.x + plot.width / 2, plot.y + plot.height / 2);
      await page.waitForTimeout(300);
      expect((await savePicture(page)).hash).not.toBe(before.hash);
    }
    expect(complaints).toEqual([]);
    await page.close();
    two.server.close();
  });

  test('says what is missing where there is no WebGL', async () => {
    const page = await browser.newPage({ viewport: kSize });
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(mock.url);
    expect(await page.locator('.fatal h1').textContent()).toContain('no WebGL 2');
    await page.close();
  });
});

describe.skipIf(chromium === undefined || berm === undefined)('berm view', () => {
  const views: View[] = [];
  const start = async (...folders: string[]) => {
    const view = await startView(berm!, folders);
    views.push(view);
    return view;
  };
  afterAll(() => views.forEach((view) => view.process.kill()));

  describe('of a groomer in snowfall', () => {
    const [recording, run] = [join(folder, 'groomer'), join(folder, 'groomer-run')];
    checkRun(
      async () => {
        runBerm(berm!, ['sim', 'groomer_snowfall', '-o', recording, '--seconds', '5']);
        runBerm(berm!, ['run', recording, '--machine', 'groomer', '-o', run]);
        return (await start(run)).url;
      },
      50,
      14,
    );

    test('stands beside its recording', async () => {
      const { page, complaints } = await open((await start(recording, run)).url);
      await page.keyboard.press('End');
      await page.waitForSelector('canvas[data-scan="49,49"]', { timeout: kPatience_ms });
      expect(complaints).toEqual([]);
      await page.close();
    });
  });

  test('opens the browser of the desktop at its address', async () => {
    const programs = join(folder, 'programs');
    const called = join(folder, 'called');
    mkdirSync(programs);
    writeFileSync(
      join(programs, 'xdg-open'),
      `#!/bin/sh\necho "$1" > '${called}.part' && mv '${called}.part' '${called}'\n`,
      {
        mode: 0o755,
      },
    );
    const recording = join(folder, 'short');
    runBerm(berm!, ['sim', 'groomer_clear', '-o', recording, '--seconds', '0.2']);
    const child = spawn(berm!, ['view', recording, '--port', '0'], {
      env: { ...process.env, PATH: `${programs}:${process.env['PATH']}`, DISPLAY: ':0' },
    });
    let printed = '';
    child.stdout.on('data', (text: Buffer) => (printed += text.toString()));
    await expect.poll(() => existsSync(called), { timeout: 30_000 }).toBe(true);
    expect(readFileSync(called, 'utf8')).toBe(printed);
    expect(printed).toMatch(/^http:\/\/127\.0\.0\.1:\d+\/\n$/);
    child.kill();
  });

  describe.skipIf(data === undefined)('of KITTI', () => {
    const run = join(folder, 'kitti-run');
    checkRun(
      async () => {
        runBerm(berm!, ['run', join(data!, 'kitti00'), '--machine', 'car', '-o', run]);
        return (await start(run)).url;
      },
      16,
      10,
    );
  });
});
