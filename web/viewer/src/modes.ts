import { Channel } from './data/points';
import type { RampName } from './colours';

/** By what points can be coloured. The order is that of the keys 1, 2, 3... */
export const kModes = [
  { id: 'label', title: 'Label', ramp: 'viridis', unit: '', channel: Channel.label },
  { id: 'height', title: 'Height', ramp: 'viridis', unit: 'm', channel: 0 },
  { id: 'intensity', title: 'Intensity', ramp: 'inferno', unit: '', channel: Channel.intensity },
  { id: 'ground', title: 'Above ground', ramp: 'balance', unit: 'm', channel: 0 },
  { id: 'time', title: 'Time', ramp: 'cividis', unit: '', channel: Channel.time },
  { id: 'ring', title: 'Ring', ramp: 'cividis', unit: '', channel: Channel.ring },
] as const satisfies readonly { id: string; title: string; ramp: RampName; unit: string; channel: number }[];

export type Mode = (typeof kModes)[number]['id'];

export const modeIndex = (mode: Mode) => kModes.findIndex((candidate) => candidate.id === mode);
