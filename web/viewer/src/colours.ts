/** Colours as 0xRRGGBB. */
export type Colour = number;

/**
 * Colours of labels, those of `berm draw` on a dark background: the hues of Okabe and Ito (2008), "Color universal
 * design", moved until the closest two are as far apart as they can be for people who lack one kind of cones. The
 * classes below the line occur in truth only.
 */
const kLabelColours: Readonly<Record<string, Colour>> = {
  unlabeled: 0x9c74b2,
  no_return: 0x525458,
  falling_snow: 0xb0defa,
  drivable: 0x30b48a,
  terrain: 0xe6be42,
  obstacle: 0xd83c24,

  vegetation: 0x7f9f3c,
  building: 0xcc79a7,
  fence: 0x3d8bff,
  pole: 0xffffff,
  vehicle: 0x6a5cff,
};

const kOtherLabels: readonly Colour[] = [0xcc79a7, 0x3d8bff, 0x7f9f3c, 0xffffff, 0x6a5cff];

/** The colour of a label by its name ("falling snow" is falling_snow); others take turns by `id`. */
export function labelColour(name: string, id: number): Colour {
  return kLabelColours[name.toLowerCase().replace(/[\s-]+/g, '_')] ?? kOtherLabels[id % kOtherLabels.length]!;
}

export const kSideColours: Readonly<Record<string, Colour>> = { left: 0x56b4e9, right: 0xe69f00 };
export const kPathColour: Colour = 0xffffff;
export const kGlobalPathColour: Colour = 0xcc79a7;

/** Anchors of ramps, evenly spaced from 0 to 1: viridis, inferno and cividis of matplotlib; blue - white - orange. */
const kRamps = {
  viridis: [0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725],
  inferno: [0x1b0c41, 0x4a0c6b, 0x781c6d, 0xa52c60, 0xcf4446, 0xed6925, 0xfb9b06, 0xf7d13d, 0xfcffa4],
  cividis: [0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xfee838],
  balance: [0x2166ac, 0x4393c3, 0x92c5de, 0xb9d3e2, 0xd5d8dc, 0xeccbb2, 0xf4a582, 0xe08214, 0xb35806],
} as const;

export type RampName = keyof typeof kRamps;

const channels = (colour: Colour) => [(colour >> 16) & 255, (colour >> 8) & 255, colour & 255] as const;

/** The colour at `share` (0..1, clamped) of a ramp. */
export function rampColour(name: RampName, share: number): Colour {
  const anchors = kRamps[name];
  const place = Math.min(1, Math.max(0, share)) * (anchors.length - 1);
  const i = Math.min(anchors.length - 2, Math.floor(place));
  const low = channels(anchors[i]!);
  const high = channels(anchors[i + 1]!);
  return low.reduce(
    (colour, value, k) => (colour << 8) | Math.round(value + (high[k]! - value) * (place - i)),
    0,
  );
}

/** 256 texels RGBA of a ramp. */
export function rampTexels(name: RampName): Uint8Array<ArrayBuffer> {
  const texels = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) texels.set([...channels(rampColour(name, i / 255)), 255], 4 * i);
  return texels;
}

/** 256 texels RGBA, one per label id; alpha 0 hides the label. */
export function labelTexels(
  labels: readonly { id: number; name: string }[],
  hidden: ReadonlySet<string>,
): Uint8Array<ArrayBuffer> {
  const texels = new Uint8Array(4 * 256);
  for (let id = 0; id < 256; ++id) texels.set([...channels(labelColour('', id)), 255], 4 * id);
  for (const { id, name } of labels) {
    texels.set([...channels(labelColour(name, id)), hidden.has(name) ? 0 : 255], 4 * id);
  }
  return texels;
}

export const css = (colour: Colour) => `#${colour.toString(16).padStart(6, '0')}`;
