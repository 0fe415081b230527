import { linkSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

// A recording of many scans out of a short one: its scans are named again and again (hard links: no place on the disk),
// at later times, farther on the way that the machine took.

const kRate_hz = 10;

const rowsOf = (file: string) =>
  readFileSync(file, 'utf8')
    .trimEnd()
    .split('\n')
    .map((line) => line.split(' ').map(Number));

const nameOf = (scan: number) => String(scan).padStart(6, '0');

/** Writes the sequence folder `target` with `scans` scans from the one in `source`, which is 10 scans a second. */
export function repeatRecording(source: string, target: string, scans: number): void {
  rmSync(target, { recursive: true, force: true });
  mkdirSync(join(target, 'scans'), { recursive: true });
  const files = readdirSync(join(source, 'scans')).sort();
  const length_s = files.length / kRate_hz;
  for (let i = 0; i < scans; ++i)
    linkSync(join(source, 'scans', files[i % files.length]!), join(target, 'scans', `${nameOf(i)}.pcd`));
  const times = Array.from({ length: scans }, (_, i) => (i / kRate_hz).toFixed(9));
  writeFileSync(join(target, 'times.txt'), `${times.join('\n')}\n`);
  const poses = rowsOf(join(source, 'gnss.tum')).filter((pose) => pose[0]! < length_s);
  const [first, last] = [poses[0]!, poses.at(-1)!];
  const lines: string[] = [];
  for (let round = 0; round * length_s * kRate_hz < scans; ++round) {
    for (const pose of poses) {
      const moved = pose.map((value, k) => {
        if (k === 0) return (value + round * length_s).toFixed(9);
        return (k < 4 ? value + round * (last[k]! - first[k]!) : value).toFixed(9);
      });
      lines.push(moved.join(' '));
    }
  }
  writeFileSync(join(target, 'gnss.tum'), `${lines.join('\n')}\n`);
  writeFileSync(join(target, 'sequence.json'), readFileSync(join(source, 'sequence.json')));
}
