import { describe, expect, it } from 'vitest';
import { readReport } from './data';
import { piecesOf, plansOf, roundLength } from './plan';

describe('the plan', () => {
  const path = {
    poses: 4,
    path_m: 3,
    t_s: [0, 1, 2, 3],
    x_m: [0, 1, 2, 3],
    y_m: [0, 0, 0, 0],
    z_m: [0, 0, 0, 0],
  };
  const read = (parts: object) =>
    readReport(JSON.stringify({ schema: 'berm.report/1', trajectory: path, ...parts }));

  it('is one line without odometry', () => {
    const report = read({});
    expect(piecesOf(report.trajectory!, report).map((piece) => piece.style)).toEqual(['path']);
  });

  it('changes where the health does, and the pieces touch', () => {
    const report = read({ odometry: { rows: 4, x: [0, 1, 2, 3], columns: { health: [0, 0, 3, 3] } } });
    const pieces = piecesOf(report.trajectory!, report);
    expect(pieces.map((piece) => piece.style)).toEqual(['path good', 'path lost']);
    expect(pieces[1]!.x[0]).toBe(pieces[0]!.x.at(-1));
    expect(pieces[1]!.x.at(-1)).toBe(3);
  });

  it('lays over each other only what is in one world', () => {
    const edges = [{ side: 'left', x_m: [0, 1], y_m: [2, 2], z_m: [0, 0] }];
    const odometry = { rows: 4, x: [0, 1, 2, 3], columns: { health: [0, 0, 0, 0] } };
    const styles = (parts: object) =>
      plansOf(read(parts)).map((plan) => plan.drawings.map((drawing) => drawing.style));
    expect(styles({ edges })).toEqual([['left', 'path']]);
    expect(styles({ edges, odometry })).toEqual([['left', 'path good']]);
    expect(styles({ edges, odometry, run: { poses: {} } })).toEqual([['left'], ['path good']]);
    expect(styles({ edges, odometry, global_trajectory: path })).toEqual([
      ['left', 'path good'],
      ['path good'],
    ]);
    expect(plansOf(readReport('{"schema": "berm.report/1"}'))).toEqual([]);
  });

  it('draws the ground where the run mapped it', () => {
    const terrain = {
      x_m: -1,
      y_m: -2,
      cell_m: 0.5,
      columns: 2,
      rows: 2,
      low_m: 0,
      high_m: 3,
      shade: 'tQC1tQ==',
    };
    const [plan] = plansOf(read({ terrain }));
    expect([...plan!.ground!.shade]).toEqual([181, 0, 181, 181]);
    expect(plan!.drawings).toHaveLength(1);
    for (const broken of [
      { shade: 'tQ==' },
      { shade: '%' },
      { shade: 7 },
      { columns: -2 },
      { cell_m: 0 },
      { rows: 1e9 },
    ])
      expect(plansOf(read({ terrain: { ...terrain, ...broken } }))[0]!.ground).toBeUndefined();
  });

  it('has a bar of a round length', () => {
    expect([0.7, 1, 19, 20, 99, 501].map(roundLength)).toEqual([0.5, 1, 10, 20, 50, 500]);
  });
});
