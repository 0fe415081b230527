import { readFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import { extname, join } from 'node:path';
import * as made from './made_data';

const kTypes: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
};

/** Answers of a made run `id`; a Buffer, JSON, or undefined for 404. */
function answer(id: number, rest: string): Buffer | object | undefined {
  const [what, which] = rest.split('/');
  const number = Number(which);
  switch (what) {
    case 'scans':
      return Buffer.from(
        which === undefined
          ? made.encodePoses(made.madePoses())
          : made.encodePoints(made.madeScan(number + 40 * id)),
      );
    case 'labels':
      return made.kLabels;
    case 'trajectory':
      return Buffer.from(made.encodePoses(made.madePoses(60)));
    case 'edges':
      return {
        type: 'FeatureCollection',
        truth: false,
        features: ['left', 'right'].map((side, line) => ({
          properties: { line, side, confidence: Array.from({ length: 40 }, (_, k) => k / 40) },
          geometry: {
            coordinates: Array.from({ length: 40 }, (_, k) => [k - 5, side === 'left' ? 5.5 : -5.5, 0.3]),
          },
        })),
      };
    case 'octree':
      return Buffer.from(
        made.encodeOctree(
          Array.from({ length: 300 }, (_, k) => ({
            x: 0.2 * k - 5,
            y: k % 2 === 0 ? 5.6 : -5.6,
            z: 0.2,
            size: 0.2,
            side: k % 2,
            p: 150 + (k % 100),
          })),
        ),
      );
    case 'map':
      return which === undefined ? made.madeMap() : Buffer.from(made.encodePoints(made.madeTile(number), 3));
    case 'piste':
      return number === 3 ? undefined : made.madePiste(number);
    default:
      return undefined;
  }
}

/** The API of docs/view_api.md over made data, and the built viewer; for tests where there is no berm. */
export function startMock(runs: readonly string[], dist: string): Promise<{ server: Server; url: string }> {
  const layers = {
    labels: true,
    edges: true,
    map: true,
    octree: true,
    trajectory: true,
    global_trajectory: false,
    piste: true,
  };
  const infos = runs.map((name, id) => ({
    id,
    name,
    is_run: true,
    scans: 20,
    machine: 'groomer',
    sensor: 'Livox Mid-70',
    start_ns: 0,
    layers,
  }));
  const server = createServer((request, response) => {
    const path = (request.url ?? '/').replace(/\?.*/, '');
    response.setHeader('Content-Security-Policy', "default-src 'self'");
    const match = /^\/api\/runs\/(\d+)\/(.+)$/.exec(path);
    const body =
      path === '/api/runs' ? infos : match !== null ? answer(Number(match[1]), match[2]!) : undefined;
    if (body instanceof Buffer) response.setHeader('Content-Type', 'application/octet-stream').end(body);
    else if (body !== undefined)
      response.setHeader('Content-Type', 'application/json').end(JSON.stringify(body));
    else if (path.startsWith('/api/'))
      response.writeHead(404).end(JSON.stringify({ error: 'there is none', hint: '' }));
    else {
      try {
        const file = readFileSync(join(dist, path === '/' ? 'index.html' : path));
        response
          .setHeader('Content-Type', kTypes[extname(path === '/' ? '.html' : path)] ?? 'text/html')
          .end(file);
      } catch {
        response.writeHead(404).end('none');
      }
    }
  });
  return new Promise((resolve) => {
    server.listen(0, '127.0.0.1', () => {
      const address = server.address();
      const port = typeof address === 'object' && address !== null ? address.port : 0;
      resolve({ server, url: `http://127.0.0.1:${port}/` });
    });
  });
}
