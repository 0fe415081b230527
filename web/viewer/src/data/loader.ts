import type { ByteCache } from './cache';

export interface Wanted<Value> {
  readonly key: string;
  readonly fetch: (signal: AbortSignal) => Promise<Value>;
}

interface Running {
  readonly key: string;
  readonly abort: AbortController;
}

/**
 * Fetches what is wanted, most urgent first, few at a time, into a bounded cache. Each call of `want` replaces the list
 * of the one before: what nobody wants any more is taken off, so that scrubbing does not queue up. What failed is not
 * asked for again.
 */
export class Loader<Value> {
  private queue: Wanted<Value>[] = [];
  private readonly running = new Set<Running>();
  private readonly failed = new Set<string>();

  constructor(
    private readonly cache: ByteCache<Value>,
    private readonly onLoad: (key: string, value: Value) => void,
    private readonly onError: (key: string, error: unknown) => void,
    /** As many connections as browsers open to one server. */
    private readonly parallel = 6,
  ) {}

  get(key: string): Value | undefined {
    return this.cache.get(key);
  }

  hasFailed(key: string): boolean {
    return this.failed.has(key);
  }

  /** How much of what is wanted has not come yet. */
  get waiting(): number {
    return this.running.size + this.queue.length;
  }

  want(wanted: readonly Wanted<Value>[]): void {
    const keys = new Set(wanted.map((item) => item.key));
    const coming = new Set<string>();
    for (const item of this.running) {
      if (!keys.has(item.key)) item.abort.abort();
      if (!item.abort.signal.aborted) coming.add(item.key);
    }
    this.queue = wanted.filter(
      ({ key }) => !this.cache.has(key) && !coming.has(key) && !this.failed.has(key),
    );
    this.pump();
  }

  private pump(): void {
    while (this.running.size < this.parallel) {
      const next = this.queue.shift();
      if (next === undefined) return;
      void this.run(next);
    }
  }

  private async run({ key, fetch }: Wanted<Value>): Promise<void> {
    const item = { key, abort: new AbortController() };
    this.running.add(item);
    try {
      const value = await fetch(item.abort.signal);
      this.cache.set(key, value);
      this.running.delete(item);
      this.onLoad(key, value);
    } catch (error) {
      this.running.delete(item);
      if (!item.abort.signal.aborted) {
        this.failed.add(key);
        this.onError(key, error);
      }
    }
    this.pump();
  }
}
