import { expect, test } from 'vitest';
import { keyName, kCommands } from '../src/commands';
import { kModes } from '../src/modes';

test('no key does two things', () => {
  const keys = kCommands.flatMap((command) => command.keys);
  expect(new Set(keys).size).toBe(keys.length);
});

test('every way to colour has its key', () => {
  expect(kCommands.filter((command) => command.group === 'Colour').map((command) => command.text)).toEqual(
    kModes.map((mode) => mode.title),
  );
});

test('keys have the names of the table', () => {
  expect(keyName({ key: ' ', shiftKey: false })).toBe('Space');
  expect(keyName({ key: 'ArrowLeft', shiftKey: true })).toBe('Shift+ArrowLeft');
  expect(keyName({ key: '?', shiftKey: true })).toBe('?');
  expect(keyName({ key: 'M', shiftKey: true })).toBe('Shift+M');
  expect(keyName({ key: 'm', shiftKey: false })).toBe('m');
});
