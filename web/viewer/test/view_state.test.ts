import { describe, expect, test } from 'vitest';
import { decodeState, defaultState, encodeState, kLayers, type ViewState } from '../src/view_state';
import { randomNumbers } from '../../test/made_data';
import { kModes } from '../src/modes';

describe('the view in the address', () => {
  test('comes back as it was, whatever it was', () => {
    const random = randomNumbers(7);
    const number = (low: number, high: number) => Math.round(100 * (low + (high - low) * random())) / 100;
    for (let i = 0; i < 300; ++i) {
      const state: ViewState = {
        time_s: number(0, 1000),
        speed: [0.1, 1, 8][i % 3]!,
        mode: kModes[i % kModes.length]!.id,
        pointSize: number(1, 12),
        edl: random() < 0.5,
        trail: 1 + Math.floor(49 * random()),
        camera: (['follow', 'top', 'driver', 'free'] as const)[i % 4]!,
        view: {
          target: [number(-9, 9), number(-9, 9), 0],
          distance_m: number(1, 99),
          azimuth_deg: number(-180, 180),
          elevation_deg: number(-89, 89),
        },
        layers: new Set(kLayers.filter(() => random() < 0.5)),
        hidden: new Set(random() < 0.5 ? ['falling_snow', 'a b&c=d#é'] : []),
        tool: (['none', 'distance', 'profile'] as const)[i % 3]!,
        marks:
          i % 3 === 0
            ? []
            : [
                [1, 2.5, -3],
                [number(-1e4, 1e4), 0, 1],
              ],
        halfWidth_m: i % 3 === 0 ? 0.5 : number(0.1, 3),
      };
      expect(decodeState(`#${encodeState(state)}`)).toEqual(state);
    }
  });

  test.each([
    '',
    '#',
    '#t=&colour=&view=',
    '#t=NaN&speed=Infinity&size=x',
    '#colour=blood&camera=moon&tool=saw',
    '#view=1,2,3',
    '#view=1,2,3,a,5,6',
    '#%',
    '#marks=1,2,3',
  ])('is the default where it makes no sense: %s', (hash) =>
    expect(decodeState(hash)).toEqual(defaultState()),
  );

  test('stays within bounds', () => {
    const state = decodeState(
      '#t=-5&speed=1e9&size=500&trail=1e9&view=0,0,0,-1,0,500&tool=distance&marks=1,2,3;4,5;1,1,1;2,2,2',
    );
    expect(state.time_s).toBe(0);
    expect(state.speed).toBe(8);
    expect(state.pointSize).toBe(12);
    expect(state.trail).toBe(50);
    expect(state.view.distance_m).toBeGreaterThan(0);
    expect(state.view.elevation_deg).toBeLessThan(90);
    expect(state.marks).toEqual([
      [1, 2, 3],
      [1, 1, 1],
    ]);
  });
});
