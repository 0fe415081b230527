const kNone = '–';
/** Between a number and its unit, where a line may not end. */
export const kGap = '\u00a0';

/** `value` with so many decimals and thin groups: 1,234.5; a dash for what is not known. */
export function fixed(value: number | null | undefined, decimals = 0): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return kNone;
  const rounded = Number(value.toFixed(decimals)) || 0; // no -0
  return rounded
    .toLocaleString('en', { minimumFractionDigits: decimals, maximumFractionDigits: decimals })
    .replace('-', '−');
}

/** With so many digits that three of them tell something, at most three behind the point. */
export function rounded(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return kNone;
  const size = Math.abs(value);
  return fixed(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

export function percent(share: number | null | undefined, decimals = 1): string {
  if (share === null || share === undefined || !Number.isFinite(share)) return kNone;
  return `${fixed(100 * share, decimals)}${kGap}%`;
}

/** 6,933,305 as "6.9 million". */
export function large(value: number): string {
  if (value >= 1e9) return `${fixed(value / 1e9, 1)}${kGap}billion`;
  return value >= 1e6 ? `${fixed(value / 1e6, 1)}${kGap}million` : fixed(value);
}

export function duration(seconds: number): string {
  if (seconds < 90) return `${fixed(seconds, seconds < 10 ? 1 : 0)}${kGap}s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 90
    ? `${minutes}${kGap}min`
    : `${Math.floor(minutes / 60)}${kGap}h ${String(minutes % 60).padStart(2, '0')}${kGap}min`;
}

export function length(metres: number): string {
  return metres < 1000
    ? `${fixed(metres, metres < 10 ? 1 : 0)}${kGap}m`
    : `${fixed(metres / 1000, 2)}${kGap}km`;
}

/** "1 scan", "2 scans" */
export function count(number: number, singular: string, plural = `${singular}s`): string {
  return `${fixed(number)} ${number === 1 ? singular : plural}`;
}

/** falling_snow as "falling snow". */
export const words = (key: string): string => key.replaceAll('_', ' ');
