/** What the server or its bytes got wrong: what happened, and what to do about it. */
export class DataError extends Error {
  constructor(
    message: string,
    readonly hint = '',
    readonly status = 0,
  ) {
    super(message);
    this.name = 'DataError';
  }
}
