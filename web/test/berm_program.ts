import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const kRoot = resolve(import.meta.dirname, '../..');

/** A built berm that has `view`: $BERM_PROGRAM, or that of a preset; undefined if there is none. */
export function findBerm(): string | undefined {
  const places = [
    process.env['BERM_PROGRAM'],
    ...['release', 'dev'].map((preset) => join(kRoot, 'build', preset, 'berm')),
  ];
  return places.find((place): place is string => place !== undefined && existsSync(place) && hasView(place));
}

function hasView(program: string): boolean {
  try {
    return /^ +view /m.test(execFileSync(program, ['--help'], { encoding: 'utf8' }));
  } catch {
    return false;
  }
}

/** Exit code 3 says that something was lost and what: no reason to stop. */
export function runBerm(program: string, args: readonly string[]): void {
  try {
    execFileSync(program, args, { stdio: ['ignore', 'ignore', 'pipe'] });
  } catch (error) {
    if ((error as { status?: number }).status !== 3) throw error;
  }
}

/** The folder of recordings for tests, as scripts/common.sh finds it. */
export function findData(): string | undefined {
  const folder = process.env['BERM_DATA'] ?? join(kRoot, '../shared/data');
  return existsSync(folder) ? folder : undefined;
}

export interface View {
  readonly process: ChildProcess;
  readonly url: string;
  readonly started_ms: number;
}

/** Starts `berm view` on a free port and waits for its address. */
export function startView(program: string, folders: readonly string[]): Promise<View> {
  const started_ms = performance.now();
  const child = spawn(program, ['view', ...folders, '--port', '0', '--no-browser'], {
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  return new Promise((resolve, reject) => {
    let printed = '';
    let complaint = '';
    child.stderr.on('data', (text: Buffer) => (complaint += text.toString()));
    child.on('exit', (code) => reject(new Error(`berm view ended with ${code}: ${complaint}`)));
    child.stdout.on('data', (text: Buffer) => {
      printed += text.toString();
      const url = /http:\/\/\S+\n/.exec(printed)?.[0].trim();
      if (url !== undefined) resolve({ process: child, url, started_ms });
    });
  });
}

/** Seconds that a processor has worked for the server so far; NaN where the system does not say. */
export function workOf(view: View): number {
  try {
    const stat = readFileSync(`/proc/${view.process.pid}/stat`, 'utf8');
    const fields = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
    return (Number(fields[11]) + Number(fields[12])) / 100;
  } catch {
    return NaN;
  }
}
