import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { collectComplaints, findChromium, launchChromium } from '../test/browser';

const kPage = resolve(import.meta.dirname, '../dist/report.html');
const kName = '</script><img src=x onerror="document.title=1"><b>drive & co';

const wave = (count: number, scale: number) =>
  Array.from({ length: count }, (_, i) => scale * (2 + Math.sin(i / 40)));

/** A run with everything, under the keys that berm writes. */
function fullRun(count = 2000): object {
  const x = Array.from({ length: count }, (_, i) => i / 10);
  const zeros = x.map(() => 0);
  return {
    schema: 'berm.report/1',
    version: '0.1.0',
    run: {
      ...bareRun().run,
      state: 'lossy',
      skipped: [{ scan: kName, reason: kName }],
      notes: [kName],
      counts: {
        scans: { selected: 3, labelled: 2, skipped: 1 },
        points: { total: 9, drivable: 5, obstacle: 4 },
      },
      stages: { read: { cpu_mean_ms: 1, p50_ms: 1, p95_ms: 2, p99_ms: 3, max_ms: 4 } },
      machine: {
        machine: { name: 'haul_truck' },
        sensor: { model: 'made', scan_hz: 10 },
        road: {
          vehicle_width_m: 6,
          min_width_vehicles: 3,
          tyre_height_m: 3,
          min_berm_tyres: 0.5,
          max_grade_percent: 10,
        },
      },
      edges: {
        left: { km: 0.2 },
        right: { km: 0.2 },
        road: { width_rule: { holds: 5, uncertain: 2, broken: 3 } },
      },
    },
    evaluation: {
      ground: { f1: 0.9, precision: 0.9, recall: 0.9, iou: 0.8 },
      left_out: { snow: 'no truth' },
    },
    scans: {
      rows: count,
      rows_per_value: 1,
      x,
      columns: {
        points: wave(count, 100),
        drivable: wave(count, 60),
        obstacle: wave(count, 40),
        slope_deg: wave(count, 3).map((v, i) => (i % 50 < 5 ? null : v)),
        slope_sigma_deg: wave(count, 0.3),
      },
    },
    times: {
      rows: count,
      rows_per_value: 1,
      x,
      columns: { read_ms: wave(count, 1), ground_ms: wave(count, 4) },
      histogram: {
        first_ms: 0.001,
        bins_per_decade: 10,
        scans: { read_ms: [0, 5, 9, 1], ground_ms: [0, 0, 4, 11] },
      },
    },
    odometry: {
      rows: count,
      x,
      columns: { health: x.map((t) => (t > 50 && t < 60 ? 3 : 0)), sigma_m: wave(count, 0.01) },
    },
    road: {
      rows: count,
      x,
      columns: {
        width_m: wave(count, 8),
        width_sigma_m: wave(count, 0.1),
        grade_percent: wave(count, 2),
        left_berm_height_m: wave(count, 0.7),
        right_berm_height_m: wave(count, 0.5),
        width_rule: x.map((t) => (t < 20 ? 2 : 0)),
      },
    },
    trajectory: { poses: count, path_m: 200, t_s: x, x_m: x, y_m: wave(count, 10), z_m: zeros },
    edges: [{ side: 'left', x_m: x, y_m: wave(count, 12), z_m: zeros }],
    terrain: {
      x_m: -20,
      y_m: -20,
      cell_m: 1,
      columns: 2,
      rows: 2,
      low_m: -1,
      high_m: 3.5,
      shade: 'tQC1tQ==',
    },
    origin_m: [500000, 5000000, 300],
    trouble: [],
  };
}

function bareRun() {
  return {
    schema: 'berm.report/1',
    version: '0.1.0',
    run: { version: '0.1.0', state: 'whole', recording: { path: kName } },
    trouble: [],
  };
}

/** As berm does it: no character of markup is left in the data. */
function fill(data: object): string {
  const json = JSON.stringify(data).replace(
    /[<>&\u2028\u2029]/g,
    (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`,
  );
  return readFileSync(kPage, 'utf8').replace(/(id="run">)[^<]*/, (_all, begin: string) => begin + json);
}

/** Elements with text of their own whose contrast to what is behind them is below 4.5 (large text: 3). */
function faintTexts(): string[] {
  const channel = (v: number) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
  const parse = (text: string) => (text.match(/[\d.]+/g) ?? []).map(Number);
  const light = (c: number[]) =>
    0.2126 * channel(c[0]! / 255) + 0.7152 * channel(c[1]! / 255) + 0.0722 * channel(c[2]! / 255);
  const behind = (element: Element | null): number[] => {
    for (let at = element; at; at = at.parentElement) {
      const c = parse(getComputedStyle(at).backgroundColor);
      if (c.length === 3 || (c[3] ?? 0) > 0.99) return c;
    }
    return [255, 255, 255];
  };
  const faint: string[] = [];
  for (const element of document.querySelectorAll('main *')) {
    const own = [...element.childNodes].some(
      (node) => node.nodeType === Node.TEXT_NODE && node.textContent!.trim() !== '',
    );
    if (!own || element.closest('svg')) continue;
    const style = getComputedStyle(element);
    const [a, b] = [light(parse(style.color)), light(behind(element))].sort((p, q) => q - p) as [
      number,
      number,
    ];
    const ratio = (a + 0.05) / (b + 0.05);
    if (ratio < (parseFloat(style.fontSize) >= 24 ? 3 : 4.5))
      faint.push(`${element.tagName} ${element.textContent} ${ratio}`);
  }
  return faint;
}

describe.skipIf(findChromium() === undefined)('the report, opened from a file', () => {
  const folder = mkdtempSync(join(tmpdir(), 'berm-report-'));
  let browser: Browser;
  let page: Page;

  const open = async (data: object, options: Parameters<Browser['newPage']>[0] = {}) => {
    const file = join(folder, 'report.html');
    writeFileSync(file, fill(data));
    page = await browser.newPage(options);
    const complaints = collectComplaints(page);
    const asked: string[] = [];
    page.on('request', (request) => asked.push(request.url()));
    page.on('dialog', (dialog) => complaints.push(dialog.message()));
    await page.goto(pathToFileURL(file).href);
    await page.waitForSelector('footer');
    return { complaints, asked };
  };

  beforeAll(async () => {
    browser = await launchChromium();
  });
  afterEach(() => page.close());
  afterAll(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
  });

  it('draws everything, asks for nothing and complains of nothing', async () => {
    const { complaints, asked } = await open(fullRun());
    await expect.poll(() => page.locator('.plot canvas').count()).toBeGreaterThanOrEqual(7);
    const inked = await page.locator('.plot canvas').evaluateAll((canvases) =>
      canvases.map((canvas) => {
        const c = canvas as HTMLCanvasElement;
        const { data } = c.getContext('2d')!.getImageData(0, 0, c.width, c.height);
        const colours = new Set<number>();
        for (let i = 0; i < data.length; i += 4)
          if (data[i + 3]! > 250) colours.add((data[i]! << 16) | (data[i + 1]! << 8) | data[i + 2]!);
        return colours.size;
      }),
    );
    for (const colours of inked) expect(colours).toBeGreaterThan(3);
    expect(await page.locator('.plan polyline.lost').count()).toBe(1);
    expect(await page.locator('.plan image.ground').getAttribute('href')).toMatch(/^data:image\/png/);
    expect(asked.filter((url) => !url.startsWith('file:') && !url.startsWith('data:'))).toEqual([]);
    expect(asked.filter((url) => url.startsWith('file:'))).toHaveLength(1);
    expect(complaints).toEqual([]);
  });

  it('has a part for everything that a run can tell', async () => {
    await open(fullRun(60));
    expect(await page.locator('h2').allTextContents()).toEqual([
      'Warnings',
      'Summary',
      'Where it drove',
      'Road',
      'Along the run',
      'Against the truth',
      'Counts and losses',
      'Time per stage',
      'Machine and recording',
    ]);
    expect(await page.locator('figcaption strong').allTextContents()).toEqual([
      'From above',
      'Standard deviation of the odometry',
      'Width of the road',
      'Grade',
      'Height of the berms',
      'Slope of the ground ahead',
      'Shares of labels',
      'How many scans took how long',
      'Time per scan and stage',
    ]);
    expect(await page.locator('.histograms .bars:not(.axis)').count()).toBe(2);
    await page.close();
    await open({ ...fullRun(60), odometry: undefined });
    const titles = await page.locator('figcaption strong').allTextContents();
    for (const title of ['Height of the machine', 'Elevation along the way', 'Slope along the way'])
      expect(titles).toContain(title);
  });

  it('leaves out what the run does not have', async () => {
    const { complaints } = await open(bareRun());
    expect(await page.locator('h2').allTextContents()).toEqual([
      'Warnings',
      'Summary',
      'Machine and recording',
    ]);
    expect(await page.locator('figure').count()).toBe(0);
    expect(complaints).toEqual([]);
  });

  it('shows markup in names as text', async () => {
    await open(fullRun(30));
    expect(await page.locator('.warnings').innerText()).toContain(kName);
    expect(await page.locator('img, main b').count()).toBe(0);
    expect(await page.title()).toContain('berm report');
  });

  it('puts warnings first', async () => {
    await open(fullRun(30));
    expect((await page.locator('h2').allTextContents())[0]).toBe('Warnings');
    expect(await page.locator('.warnings li').first().innerText()).toContain(
      '1 of 3 scans could not be read',
    );
  });

  it('has a table behind every plot, reached by keyboard', async () => {
    await open(fullRun());
    const figures = await page.locator('figure').count();
    expect(await page.locator('figure details').count()).toBe(figures);
    const summary = page.locator('figure summary').first();
    await summary.focus();
    await page.keyboard.press('Enter');
    await page.locator('figure details').first().locator('table').waitFor();
    await page.keyboard.press('Tab');
    const focused = await page.evaluate(() => document.activeElement?.getAttribute('role'));
    expect(focused).toBe('region');
    expect(await page.locator('figure .plot:not([aria-label]), figure .plan:not([aria-label])').count()).toBe(
      0,
    );
  });

  it('hides and shows a line by keyboard', async () => {
    await open(fullRun());
    const key = page.locator('.legend button', { hasText: 'ground' });
    await key.focus();
    await page.keyboard.press('Enter');
    expect(await key.getAttribute('aria-pressed')).toBe('false');
  });

  it('fits a phone', async () => {
    await open(fullRun(), { viewport: { width: 360, height: 740 } });
    await expect.poll(() => page.locator('.plot canvas').count()).toBeGreaterThanOrEqual(7);
    for (const summary of await page.locator('summary').all()) await summary.click();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
  });

  it.each(['light', 'dark'] as const)('can be read in %s colours', async (colorScheme) => {
    await open(fullRun(), { colorScheme });
    for (const summary of await page.locator('summary').all()) await summary.click();
    expect(await page.evaluate(faintTexts)).toEqual([]);
  });

  it('prints black on white, also from a dark screen', async () => {
    await open(fullRun(), { colorScheme: 'dark' });
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    const colours = await page.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      return [style.color, style.backgroundColor];
    });
    expect(colours).toEqual(['rgb(27, 31, 36)', 'rgb(255, 255, 255)']);
    expect((await page.pdf({ format: 'A4' })).length).toBeGreaterThan(20_000);
  });
});
