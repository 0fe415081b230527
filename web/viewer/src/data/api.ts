import { DataError } from './errors';
import { decodeOctree, type Voxel } from './octree';
import { decodePoints, type PointBlock } from './points';
import { decodePoses, type PoseTable } from './poses';
import * as model from './model';

async function get(path: string, signal?: AbortSignal): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, signal === undefined ? {} : { signal });
  } catch (error) {
    if (signal?.aborted) throw error;
    throw new DataError(
      'the server does not answer',
      'Is berm view still running? Start it again and reload this page.',
    );
  }
  if (response.ok) return response;
  const body = (await response.json().catch(() => ({}))) as { error?: unknown; hint?: unknown };
  const text = (value: unknown, fallback: string) => (typeof value === 'string' ? value : fallback);
  throw new DataError(
    text(body.error, `${path}: status ${response.status}`),
    text(body.hint, ''),
    response.status,
  );
}

const json = async (path: string, signal?: AbortSignal): Promise<unknown> => (await get(path, signal)).json();
const binary = async (path: string, signal?: AbortSignal) => (await get(path, signal)).arrayBuffer();

/** What a server of docs/view_api.md has to say. Everything is checked here; errors are DataErrors. */
export const api = {
  runs: async (): Promise<model.RunInfo[]> => model.parseRuns(await json('api/runs')),
  scans: async (run: number): Promise<PoseTable> => decodePoses(await binary(`api/runs/${run}/scans`)),
  scan: async (run: number, i: number, signal?: AbortSignal): Promise<PointBlock> =>
    decodePoints(await binary(`api/runs/${run}/scans/${i}`, signal)),
  labels: async (run: number) => model.parseLabels(await json(`api/runs/${run}/labels`)),
  trajectory: async (run: number) => decodePoses(await binary(`api/runs/${run}/trajectory`)),
  globalTrajectory: async (run: number) => decodePoses(await binary(`api/runs/${run}/global`)),
  edges: async (run: number) => model.parseEdges(await json(`api/runs/${run}/edges`)),
  octree: async (run: number): Promise<Voxel[]> => decodeOctree(await binary(`api/runs/${run}/octree`)),
  tiles: async (run: number) => model.parseTiles(await json(`api/runs/${run}/map`)),
  tile: async (run: number, tile: number, signal: AbortSignal): Promise<PointBlock> =>
    decodePoints(await binary(`api/runs/${run}/map/${tile}`, signal)),
  piste: async (run: number, i: number, signal: AbortSignal) =>
    model.parsePiste(await json(`api/runs/${run}/piste/${i}`, signal)),
};
