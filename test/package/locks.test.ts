import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';

// Each lock file is complete, for all platforms, so that `npm ci` takes it, and names no registry.

const root = join(import.meta.dirname, '../..');

describe.each(['.', 'docs', 'bench', 'test/consumers'])('the lock file of %s', (folder) => {
  it('is what npm ci wants', () => {
    const options = { cwd: join(root, folder), stdio: 'pipe', shell: process.platform === 'win32' } as const;
    expect(() => execFileSync('npm', ['ci', '--dry-run', '--offline', '--ignore-scripts'], options)).not.toThrow();
  });

  it('says nothing of where packages were found', () => {
    const text = readFileSync(join(root, folder, 'package-lock.json'), 'utf8');
    expect(text).toContain('"lockfileVersion": 3');
    expect(text).not.toContain('"resolved"');
  });
});
