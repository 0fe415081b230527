import { expect, test } from 'vitest';
import { madeMap, madePiste } from '../../test/made_data';
import { parseEdges, parseLabels, parsePiste, parseRuns, parseTiles } from '../src/data/model';

const kRun = {
  id: 0,
  name: 'out',
  is_run: true,
  scans: 3,
  machine: 'car',
  sensor: '',
  layers: { map: true, edges: false },
};

test('runs are read; layers that are not named are not there', () => {
  const [run] = parseRuns([kRun]);
  expect(run!.name).toBe('out');
  expect([...run!.layers]).toEqual(['map']);
});

test.each([
  [{ ...kRun, scans: -1 }, 'runs[0].scans'],
  [{ ...kRun, scans: 2.5 }, 'runs[0].scans'],
  [{ ...kRun, name: 7 }, 'runs[0].name'],
  [null, 'runs[0]'],
])('a run that is wrong is refused by the place where: %#', (run, place) => {
  expect(() => parseRuns([run])).toThrow(place);
});

test('labels have ids of one byte', () => {
  expect(parseLabels([{ id: 255, name: 'x' }])).toEqual([{ id: 255, name: 'x' }]);
  expect(() => parseLabels([{ id: 256, name: 'x' }])).toThrow('256');
});

const line = (confidence: readonly number[]) => ({
  truth: false,
  features: [
    {
      properties: { line: 4, side: 'left', confidence },
      geometry: {
        coordinates: [
          [1, 2, 3],
          [4, 5, 6],
        ],
      },
    },
  ],
});

test('edges are read; a confidence must be there for each vertex', () => {
  const edges = parseEdges(line([0.5, 1]));
  expect([...edges.lines[0]!.vertices]).toEqual([1, 2, 3, 4, 5, 6]);
  expect(() => parseEdges(line([0.5]))).toThrow('2 numbers');
});

test('tiles are read', () => {
  const tree = parseTiles(madeMap());
  expect(tree.tiles).toHaveLength(12);
  expect(tree.max).toEqual([50, 20, 3]);
  expect(() => parseTiles({ bounds: { min: [0, 0], max: [1, 1, 1] }, tiles: [] })).toThrow('3 numbers');
});

test('a piste is read; steps outside the series are left out, series of other lengths refused', () => {
  const made = madePiste(0);
  expect(parsePiste({ ...made, steps: [1, -1, 5.5, 1e9] }).steps).toEqual(new Float64Array([1]));
  expect(() => parsePiste({ ...made, shown: [1] })).toThrow('piste.shown');
});
