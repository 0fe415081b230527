import { indexAt, type PoseTable } from '../data/poses';

/** Time of one or several runs that are played together, in seconds since the first stamp of the earliest. */
export class Timeline {
  readonly duration_s: number;
  private readonly offsets: readonly number[];

  /**
   * Runs whose stamps overlap share one time; others are laid over each other from their first scan on, so that two drives
   * along one way can be compared as well.
   */
  constructor(private readonly tables: readonly PoseTable[]) {
    const filled = tables.filter((table) => table.count > 0);
    const starts = filled.map((table) => table.startNs);
    const first = starts.reduce((low, start) => (start < low ? start : low), starts[0] ?? 0n);
    const toStart = (table: PoseTable) => (table.count === 0 ? 0 : Number(table.startNs - first) * 1e-9);
    const latestStart = Math.max(0, ...filled.map(toStart));
    const firstEnd = Math.min(...filled.map((table) => toStart(table) + length(table)));
    const overlap = latestStart <= firstEnd;
    this.offsets = tables.map((table) => (overlap ? toStart(table) : 0));
    this.duration_s = Math.max(0, ...tables.map((table, run) => this.offsets[run]! + length(table)));
  }

  // A stamp in an address has six digits behind the point: what was rounded down still names its scan.
  private static readonly kRounding_s = 1e-6;

  /** The scan of `run` at `time_s`; -1 if it has none. */
  scanAt(run: number, time_s: number): number {
    return indexAt(this.tables[run]!, time_s - this.offsets[run]! + Timeline.kRounding_s);
  }

  timeOf(run: number, scan: number): number {
    return this.offsets[run]! + (this.tables[run]!.time_s[scan] ?? 0);
  }

  /** The time `steps` scans of the first run away, within the run. */
  step(time_s: number, steps: number): number {
    const table = this.tables[0];
    if (table === undefined || table.count === 0) return 0;
    const scan = Math.min(table.count - 1, Math.max(0, this.scanAt(0, time_s) + steps));
    return this.timeOf(0, scan);
  }
}

const length = (table: PoseTable) => (table.count === 0 ? 0 : table.time_s[table.count - 1]!);

/** The longest step of the clock: what a tab in the background slept through is not made up for. */
const kMaxTick_s = 0.25;

export class Clock {
  playing = false;
  speed = 1;
  time_s = 0;
  private last_ms: number | undefined;

  constructor(private readonly duration_s: number) {}

  toggle(): void {
    if (!this.playing && this.time_s >= this.duration_s) this.time_s = 0;
    this.playing = !this.playing;
    this.last_ms = undefined;
  }

  seek(time_s: number): void {
    this.time_s = Math.min(this.duration_s, Math.max(0, time_s));
  }

  /** Moves on by the time since the last call, if `ready`: while a scan is on its way, time stands. */
  tick(now_ms: number, ready: boolean): boolean {
    if (!this.playing) return false;
    const elapsed_s = this.last_ms === undefined ? 0 : (now_ms - this.last_ms) / 1000;
    this.last_ms = now_ms;
    if (!ready) return false;
    this.seek(this.time_s + Math.min(kMaxTick_s, elapsed_s) * this.speed);
    if (this.time_s >= this.duration_s) this.playing = false;
    return true;
  }
}
