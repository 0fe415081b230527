import { createHash } from 'node:crypto';
import type { Page } from 'playwright-core';

export interface Picture {
  readonly hash: string;
  readonly width: number;
  readonly height: number;
  /** Share of pixels that are much brighter than the background. */
  readonly bright: number;
  /** How many colours there are, of 4096. */
  readonly colours: number;
  /** Whether the left half is the right one, with a gap of 2 pixels between them. */
  readonly twice: boolean;
}

/** Presses the key that saves a picture and looks at what is in the file. */
export async function savePicture(page: Page): Promise<Picture> {
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('c')]);
  const chunks: Buffer[] = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk as Buffer);
  const file = Buffer.concat(chunks);
  const facts = await page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(
      new Blob([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], { type: 'image/png' }),
    );
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const colours = new Set<number>();
    let bright = 0;
    for (let i = 0; i < data.length; i += 4) {
      colours.add(((data[i]! >> 4) << 8) | ((data[i + 1]! >> 4) << 4) | (data[i + 2]! >> 4));
      if (Math.max(data[i]!, data[i + 1]!, data[i + 2]!) > 90) ++bright;
    }
    const pane = Math.floor((bitmap.width - 2) / 2);
    const half = (left: number) => context.getImageData(left, 0, pane, bitmap.height).data;
    const [first, second] = [half(0), half(bitmap.width - pane)];
    return {
      twice: first.every((value, i) => value === second[i]),
      width: bitmap.width,
      height: bitmap.height,
      bright: (4 * bright) / data.length,
      colours: colours.size,
    };
  }, file.toString('base64'));
  return { hash: createHash('sha256').update(file).digest('hex'), ...facts };
}
