import { Timeline } from '../playback/clock';
import { decodeState, type ViewState } from '../view_state';
import { api } from './api';
import { DataError } from './errors';
import type { LabelName, RunInfo } from './model';
import type { PointBlock } from './points';
import { hasPose, type PoseTable } from './poses';

/** Scans that are shown together at first where one alone says little: fewer points than this, and poses to place them. */
const kSparse_points = 30_000;
const kSparseTrail = 8;

/** What the server said about a run. */
export interface OpenedRun {
  readonly info: RunInfo;
  readonly table: PoseTable;
  readonly labels: readonly LabelName[];
}

/** All that the first picture is made of. */
export interface Opening {
  readonly runs: readonly OpenedRun[];
  readonly state: ViewState;
  readonly timeline: Timeline;
  /** The scans of the first moment, by `scanKey`; those that cannot be had are left out. */
  readonly scans: ReadonlyMap<string, PointBlock>;
}

export const scanKey = (run: number, scan: number) => `${run}/scan/${scan}`;

/**
 * Asks for everything that the first picture needs, before the code that draws it is there. What is known beforehand (a
 * server shows one run at least, and an address without a time its first scan) is asked for without waiting for answers.
 */
export async function open(hash: string): Promise<Opening> {
  const state = decodeState(hash);
  const guess = state.time_s === 0 ? quietly(api.scan(0, 0)) : undefined;
  const firstRun = Promise.all([api.scans(0), api.labels(0)]);
  firstRun.catch(() => undefined); // what `runs` says comes first
  const infos = await api.runs();
  if (infos.length === 0)
    throw new DataError('there is nothing to show', 'Give berm view a run or a recording.');
  const runs = await Promise.all(
    infos.map(async (info, i): Promise<OpenedRun> => {
      const [table, labels] = await (i === 0 ? firstRun : Promise.all([api.scans(i), api.labels(i)]));
      return { info, table, labels };
    }),
  );
  if (hash === '' && isSparse(runs)) state.trail = kSparseTrail;
  const timeline = new Timeline(runs.map((run) => run.table));
  return { runs, state, timeline, scans: await firstScans(runs, timeline, state.time_s, guess) };
}

async function firstScans(
  runs: readonly OpenedRun[],
  timeline: Timeline,
  time_s: number,
  guess: Promise<PointBlock | undefined> | undefined,
): Promise<Map<string, PointBlock>> {
  const scans = new Map<string, PointBlock>();
  const fetchOne = async (run: number) => {
    const scan = timeline.scanAt(run, time_s);
    if (scan < 0) return;
    const block = await (run === 0 && scan === 0 && guess !== undefined
      ? guess
      : quietly(api.scan(run, scan)));
    if (block !== undefined) scans.set(scanKey(runs[run]!.info.id, scan), block);
  };
  await Promise.all(runs.map((_, run) => fetchOne(run)));
  return scans;
}

/** A scan that is broken is asked for again by whoever shows it, and said there. */
const quietly = (scan: Promise<PointBlock>) => scan.catch(() => undefined);

const isSparse = (runs: readonly OpenedRun[]) =>
  runs.every(
    ({ table }) =>
      table.count > 0 && hasPose(table, 0) && table.points[0]! > 0 && table.points[0]! < kSparse_points,
  );
