import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { find } from './engines.mjs';

export interface Served {
  readonly type: string;
  readonly body: Buffer | string;
}

/** Firefox has no driver here: it opens the page at `/`, which posts what it found as JSON. @returns that. */
export async function askFirefox<T>(serve: (url: string) => Served | null): Promise<T> {
  let tell: (told: T) => void;
  const answered = new Promise<T>((resolve) => {
    tell = resolve;
  });
  const server = createServer((request, response) => {
    if (request.method === 'POST') {
      let text = '';
      request.setEncoding('utf8');
      request.on('data', (part: string) => {
        text += part;
      });
      request.on('end', () => {
        response.end();
        tell(JSON.parse(text) as T);
      });
      return;
    }
    const served = serve(request.url ?? '/');
    response.writeHead(served === null ? 404 : 200, { 'Content-Type': served?.type ?? 'text/plain' });
    response.end(served?.body ?? '');
  });
  await new Promise<void>((resolve) => {
    server.listen(0, '127.0.0.1', resolve);
  });
  const { port } = server.address() as AddressInfo;
  const profile = mkdtempSync(join(tmpdir(), 'phys2d-firefox-'));
  const options = ['--headless', '--no-remote', '--profile', profile, `http://127.0.0.1:${port}/`];
  const firefox = spawn(find('firefox'), options, { stdio: 'ignore', env: { ...process.env, HOME: profile } });
  const ended = new Promise<never>((_, reject) => {
    firefox.on('error', reject);
    firefox.on('exit', (code) => reject(new Error(`Firefox ended with ${code}`)));
  });
  try {
    return await Promise.race([answered, ended]);
  } finally {
    ended.catch(() => {});
    const gone = new Promise((resolve) => {
      firefox.once('exit', resolve);
    });
    if (firefox.exitCode === null && firefox.kill()) {
      await gone;
    }
    server.closeAllConnections();
    server.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
