import { describe, expect, test, vi } from 'vitest';
import { ByteCache } from '../src/data/cache';
import { Loader } from '../src/data/loader';

describe('cache', () => {
  test('drops what was not asked for longest, and never holds more than it may', () => {
    const cache = new ByteCache<number>(10, (bytes) => bytes);
    cache.set('a', 4);
    cache.set('b', 4);
    expect(cache.get('a')).toBe(4);
    cache.set('c', 4);
    expect([cache.has('a'), cache.has('b'), cache.has('c')]).toEqual([true, false, true]);
    expect(cache.bytes).toBe(8);
  });

  test('keeps one value that is larger than all of it', () => {
    const cache = new ByteCache<number>(10, (bytes) => bytes);
    cache.set('a', 4);
    cache.set('huge', 100);
    expect([cache.size, cache.has('huge')]).toEqual([1, true]);
    cache.set('b', 4);
    expect([cache.size, cache.has('b'), cache.bytes]).toEqual([1, true, 4]);
  });

  test('counts a value that is replaced once', () => {
    const cache = new ByteCache<number>(10, (bytes) => bytes);
    for (let i = 0; i < 5; ++i) cache.set('a', 3);
    expect(cache.bytes).toBe(3);
  });

  test('stays bounded under churn', () => {
    const cache = new ByteCache<number>(1000, (bytes) => bytes);
    for (let i = 0; i < 10_000; ++i) {
      cache.set(String(i % 777), 1 + (i % 90));
      expect(cache.bytes).toBeLessThanOrEqual(1000);
    }
  });
});

/** Fetches that come when the test says so. */
class Wire {
  readonly asked: string[] = [];
  readonly signals = new Map<string, AbortSignal>();
  private readonly settle = new Map<string, (value: string | Error) => void>();

  want = (key: string) => ({
    key,
    fetch: (signal: AbortSignal) => {
      this.asked.push(key);
      this.signals.set(key, signal);
      return new Promise<string>((resolve, reject) => {
        this.settle.set(key, (value) => (value instanceof Error ? reject(value) : resolve(value)));
        signal.addEventListener('abort', () => reject(new Error('aborted')));
      });
    },
  });

  async answer(key: string, value: string | Error = key): Promise<void> {
    this.settle.get(key)!(value);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

const loader = (parallel = 2) => {
  const loaded = vi.fn();
  const failed = vi.fn();
  return {
    loader: new Loader<string>(new ByteCache<string>(100, () => 1), loaded, failed, parallel),
    loaded,
    failed,
  };
};

describe('loader', () => {
  test('fetches a few at a time, in order, each once', async () => {
    const wire = new Wire();
    const { loader: it, loaded } = loader();
    const wanted = ['a', 'b', 'c'].map(wire.want);
    it.want(wanted);
    it.want(wanted);
    expect(wire.asked).toEqual(['a', 'b']);
    await wire.answer('a');
    expect(wire.asked).toEqual(['a', 'b', 'c']);
    expect(loaded).toHaveBeenCalledWith('a', 'a');
    await wire.answer('b');
    await wire.answer('c');
    it.want(wanted);
    expect(wire.asked).toHaveLength(3);
    expect(it.waiting).toBe(0);
  });

  test('lets go of what is not wanted any more, and takes it up again when it is', async () => {
    const wire = new Wire();
    const { loader: it, failed } = loader();
    it.want(['a', 'b', 'c'].map(wire.want));
    it.want([wire.want('d')]);
    expect(wire.signals.get('a')!.aborted).toBe(true);
    it.want([wire.want('a')]);
    await new Promise((resolve) => setTimeout(resolve));
    expect(wire.asked.filter((key) => key === 'a')).toHaveLength(2);
    expect(wire.asked).not.toContain('c');
    await wire.answer('a');
    expect(it.get('a')).toBe('a');
    expect(failed).not.toHaveBeenCalled();
  });

  test('says what failed, once, and goes on with the rest', async () => {
    const wire = new Wire();
    const { loader: it, failed } = loader(1);
    it.want(['a', 'b'].map(wire.want));
    await wire.answer('a', new Error('broken'));
    expect(failed).toHaveBeenCalledTimes(1);
    expect(it.hasFailed('a')).toBe(true);
    it.want(['a', 'b'].map(wire.want));
    expect(wire.asked).toEqual(['a', 'b']);
  });
});
