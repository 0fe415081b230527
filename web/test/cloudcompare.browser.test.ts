import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { findBerm, runBerm } from './berm_program';

// Files of `berm export`, opened by CloudCompare (package cloudcompare of Debian and Ubuntu, which reads no LAS).

const kProgram = process.env['BERM_CLOUDCOMPARE'] ?? '/usr/bin/CloudCompare';
const berm = findBerm();
const canTry = berm !== undefined && existsSync(kProgram);
if (!canTry) console.warn('No CloudCompare, or no berm with `export`: its point clouds are not opened by it');

const folder = mkdtempSync(join(tmpdir(), 'berm-cloudcompare-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** Rows of numbers of a text file; lines that begin with no number are left out. */
const rowsOf = (file: string) =>
  readFileSync(file, 'utf8')
    .split('\n')
    .filter((line) => /^[-\d]/.test(line))
    .map((line) => line.split(/[\s,]+/).map(Number));

/** Opens a file and saves it as text with four digits. */
function convert(file: string): number[][] {
  const out = `${file}.asc`;
  const format = ['-C_EXPORT_FMT', 'ASC', '-PREC', '4'];
  execFileSync(
    kProgram,
    ['-SILENT', '-AUTO_SAVE', 'OFF', ...format, '-O', file, '-SAVE_CLOUDS', 'FILE', out],
    { env: { ...process.env, QT_QPA_PLATFORM: 'offscreen' }, stdio: 'ignore' },
  );
  return rowsOf(out);
}

describe.skipIf(!canTry)('CloudCompare', () => {
  let expected: number[][] = [];
  const file = (format: string) => join(folder, `cloud.${format}`);

  beforeAll(() => {
    const [recording, out] = [join(folder, 'recording'), join(folder, 'out')];
    runBerm(berm!, ['sim', 'groomer_clear', '--seconds', '0.3', '-o', recording, '-q']);
    runBerm(berm!, ['run', recording, '--machine', 'groomer', '-o', out, '-q']);
    for (const format of ['ply', 'csv'])
      runBerm(berm!, ['export', out, '--to', format, '-o', file(format), '-q']);
    expected = rowsOf(file('csv'));
  });

  test.each(['ply', 'csv'])('reads all points of %s, each where it is', (format) => {
    const points = convert(file(format));
    expect(expected.length).toBeGreaterThan(10_000);
    expect(points).toHaveLength(expected.length);
    let worst_m = 0;
    points.forEach((point, i) => {
      for (const axis of [0, 1, 2]) worst_m = Math.max(worst_m, Math.abs(point[axis]! - expected[i]![axis]!));
    });
    expect(worst_m).toBeLessThan(0.002); // millimetres in the one, floats in the other
  });
});
