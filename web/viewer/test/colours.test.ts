import { describe, expect, test } from 'vitest';
import { labelColour, labelTexels, rampColour, rampTexels, type Colour } from '../src/colours';

const channels = (colour: Colour) =>
  [(colour >> 16) & 255, (colour >> 8) & 255, colour & 255].map((v) => v / 255);
const linear = (v: number) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);

/** What people who lack one kind of cones see, in linear RGB: Machado et al. 2009, severity 1. */
const kVision = {
  all: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  protan: [0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998],
  deutan: [0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881],
  tritan: [1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039],
};

function lab(colour: Colour, m: readonly number[]): number[] {
  const c = channels(colour).map(linear);
  const [r, g, b] = [0, 3, 6].map((k) =>
    Math.min(1, Math.max(0, m[k]! * c[0]! + m[k + 1]! * c[1]! + m[k + 2]! * c[2]!)),
  );
  const f = (t: number) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116);
  const x = f((0.4124 * r! + 0.3576 * g! + 0.1805 * b!) / 0.9505);
  const y = f(0.2126 * r! + 0.7152 * g! + 0.0722 * b!);
  const z = f((0.0193 * r! + 0.1192 * g! + 0.9505 * b!) / 1.089);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

const luminance = (colour: Colour) => {
  const [r, g, b] = channels(colour).map(linear);
  return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
};
const contrast = (a: Colour, b: Colour) => {
  const [high, low] = [luminance(a), luminance(b)].sort((p, q) => q - p);
  return (high! + 0.05) / (low! + 0.05);
};

const kNames = ['unlabeled', 'falling_snow', 'drivable', 'terrain', 'obstacle'];

describe('colours of labels', () => {
  test.each(Object.entries(kVision))('stay apart for %s', (_, matrix) => {
    for (const a of kNames) {
      for (const b of kNames) {
        if (a >= b) continue;
        const [p, q] = [lab(labelColour(a, 0), matrix), lab(labelColour(b, 0), matrix)];
        expect(Math.hypot(...p.map((value, k) => value - q[k]!)), `${a} and ${b}`).toBeGreaterThan(20);
      }
    }
  });

  test('stand out from the background', () => {
    for (const name of kNames) expect(contrast(labelColour(name, 0), 0x10151c), name).toBeGreaterThan(3);
  });

  test('are found by names as files have them, and some colour for every other', () => {
    expect(labelColour('Falling snow', 9)).toBe(labelColour('falling_snow', 0));
    for (let id = 0; id < 256; ++id) expect(labelColour('<script>', id)).toBeGreaterThan(0);
  });

  test('hide what is hidden', () => {
    const texels = labelTexels([{ id: 2, name: 'falling_snow' }], new Set(['falling_snow']));
    expect([texels[4 * 2 + 3], texels[4 * 3 + 3]]).toEqual([0, 255]);
  });
});

describe('ramps', () => {
  test('begin and end at their anchors and clamp', () => {
    expect(rampColour('viridis', 0)).toBe(0x440154);
    expect(rampColour('viridis', 1)).toBe(0xfde725);
    expect(rampColour('viridis', 7)).toBe(0xfde725);
    expect(rampColour('viridis', -7)).toBe(0x440154);
  });

  test.each(['viridis', 'inferno', 'cividis'] as const)('%s grows brighter all the way', (name) => {
    const lightness = Array.from({ length: 65 }, (_, i) => lab(rampColour(name, i / 64), kVision.all)[0]!);
    for (let i = 1; i < lightness.length; ++i)
      expect(lightness[i]).toBeGreaterThanOrEqual(lightness[i - 1]! - 0.01);
  });

  test('fill all texels', () => {
    expect(
      rampTexels('balance')
        .filter((_, i) => i % 4 === 3)
        .every((alpha) => alpha === 255),
    ).toBe(true);
  });
});

describe('text', () => {
  // As in style.css: text, quiet text, text of what is off; on page, panel and buttons.
  test.each([
    [0xe8edf3, 0x212b37, 4.5],
    [0xaeb9c7, 0x161d26, 4.5],
    [0xaeb9c7, 0x212b37, 4.5],
    [0xe8edf3, 0x14527a, 4.5],
    [0xaeb9c7, 0x14527a, 3],
  ])('%i on %i has contrast enough', (text, back, least) => {
    expect(contrast(text, back)).toBeGreaterThan(least);
  });
});
