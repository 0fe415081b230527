import { expect, test } from 'vitest';
import { encodePoses, madePoses } from '../../test/made_data';
import { decodePoses } from '../src/data/poses';
import { makeEdges, pathPoses } from '../src/scene/layers';
import { faded } from '../src/scene/lines';
import { kSideColours } from '../src/colours';

const table = (x: readonly number[]) =>
  decodePoses(
    encodePoses(madePoses(x.length).map((pose, i) => ({ ...pose, pose: [x[i]!, 0, 0, 0, 0, 0, 1] }))),
  );

test('a path leaves out poses that hardly moved, but neither its ends nor its gaps', () => {
  expect(pathPoses(table([0, 0.1, 0.2, 0.3, 0.4, 1.4, 1.5]))).toEqual([0, 3, 5, 6]);
  expect(pathPoses(table([0, 1, NaN, NaN, 2, 3]))).toEqual([0, 1, -1, 4, 5]);
  expect(pathPoses(table([]))).toEqual([]);
});

test('a path has a bounded number of pieces, however long it is', () => {
  const kept = pathPoses(table(Array.from({ length: 50_000 }, (_, i) => 0.7 * i)));
  expect(kept.length).toBeLessThan(2100);
  expect(kept.at(-1)).toBe(49_999);
});

test('an edge fades where it is uncertain', () => {
  const line = {
    line: 0,
    side: 'left',
    kind: '',
    vertices: new Float32Array(9),
    confidence: Float64Array.of(1, 0.5, 0),
  };
  const edges = makeEdges({ truth: false, lines: [line] }) as unknown as {
    geometry: { attributes: Record<string, { data: { array: ArrayLike<number> } }> };
  };
  const colours = Array.from(edges.geometry.attributes['instanceColorStart']!.data.array);
  const expected = [1, 0.6, 0.6, 0.2].flatMap((share) => faded(kSideColours['left']!, share).toArray());
  expected.forEach((value, i) => expect(colours[i]).toBeCloseTo(value, 5));
});
