import { at, num, text, type Json } from './data';
import { h } from './dom';

/** The ground from above, lit from one side. */
export interface Terrain {
  /** South-western corner, m from the origin of the report. */
  x: number;
  y: number;
  cellM: number;
  columns: number;
  rows: number;
  lowM: number;
  highM: number;
  /** Row by row, the northern first: 0 not known, 1 dark to 255 bright. */
  shade: Uint8Array;
}

export function readTerrain(json: Json): Terrain | undefined {
  const [columns, rows, cellM] = [num(json, ['columns']), num(json, ['rows']), num(json, ['cell_m'])];
  const coded = text(json, 'shade');
  if (at(json, 'shade') === null || !(cellM > 0) || !(columns * rows > 0)) return undefined;
  let bytes: string;
  try {
    bytes = atob(coded);
  } catch {
    return undefined;
  }
  if (bytes.length !== columns * rows) return undefined;
  return {
    x: num(json, ['x_m']),
    y: num(json, ['y_m']),
    cellM,
    columns,
    rows,
    lowM: num(json, ['low_m']),
    highM: num(json, ['high_m']),
    shade: Uint8Array.from(bytes, (byte) => byte.charCodeAt(0)),
  };
}

/** The ground as a PNG in an address; what is not known is transparent. */
export function shadePicture({ columns, rows, shade }: Terrain): string {
  const canvas = h('canvas', { width: columns, height: rows });
  const context = canvas.getContext('2d');
  if (!context) return '';
  const picture = context.createImageData(columns, rows);
  shade.forEach((value, i) => picture.data.set([value, value, value, value === 0 ? 0 : 255], 4 * i));
  context.putImageData(picture, 0, 0);
  return canvas.toDataURL();
}
