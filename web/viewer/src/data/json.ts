import { DataError } from './errors';

/** Reads JSON that is not trusted: every getter says which key is not what it should be. */
export class JsonReader {
  constructor(
    private readonly value: unknown,
    private readonly path: string,
  ) {}

  at(key: string): JsonReader {
    const object = this.object();
    return new JsonReader(object[key], `${this.path}.${key}`);
  }

  get missing(): boolean {
    return this.value === undefined || this.value === null;
  }

  number(): number {
    if (typeof this.value !== 'number' || !Number.isFinite(this.value)) throw this.wrong('a number');
    return this.value;
  }

  count(): number {
    const value = this.number();
    if (!Number.isInteger(value) || value < 0) throw this.wrong('a count');
    return value;
  }

  string(): string {
    if (typeof this.value !== 'string') throw this.wrong('a string');
    return this.value;
  }

  /** Absent is false. */
  flag(): boolean {
    return this.value === true;
  }

  list(): JsonReader[] {
    if (!Array.isArray(this.value)) throw this.wrong('a list');
    return this.value.map((item, i) => new JsonReader(item, `${this.path}[${i}]`));
  }

  /** `length` numbers, or any count of them when it is not given; null in the list becomes NaN. */
  numbers(length?: number): Float64Array {
    if (!Array.isArray(this.value)) throw this.wrong('a list of numbers');
    if (length !== undefined && this.value.length !== length) throw this.wrong(`${length} numbers`);
    const numbers = new Float64Array(this.value.length);
    this.value.forEach((item: unknown, i) => {
      if (item !== null && typeof item !== 'number') throw this.wrong('a list of numbers');
      numbers[i] = item ?? NaN;
    });
    return numbers;
  }

  private object(): Record<string, unknown> {
    if (typeof this.value !== 'object' || this.value === null || Array.isArray(this.value))
      throw this.wrong('an object');
    return this.value as Record<string, unknown>;
  }

  private wrong(expected: string): DataError {
    return new DataError(`${this.path}: expected ${expected}`);
  }
}
