import { execFile, execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';

// A fresh project with the package as npm packs it, and the tools of package.json beside this file.

const root = join(import.meta.dirname, '../..');
const tools = createRequire(join(import.meta.dirname, 'package.json'));
const execFileAsync = promisify(execFile);
const npm = { encoding: 'utf8', shell: process.platform === 'win32', stdio: 'pipe' } as const;

/** Installs compilers, bundlers and checkers; takes no time if they are there. */
export function installTools(): void {
  execFileSync('npm', ['install', '--silent', '--no-audit', '--no-fund'], { ...npm, cwd: import.meta.dirname });
}

/** Imports a tool. */
export async function tool<T>(name: string): Promise<T> {
  return (await import(/* @vite-ignore */ pathToFileURL(tools.resolve(name)).href)) as T;
}

/** Path of a file of a tool. */
export function toolFile(...path: string[]): string {
  return join(import.meta.dirname, 'node_modules', ...path);
}

export class Project {
  readonly folder = mkdtempSync(join(tmpdir(), 'phys2d-project-'));
  /** The packed package. */
  readonly tarball: string;

  constructor() {
    const [packed] = JSON.parse(
      execFileSync('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', this.folder], {
        ...npm,
        cwd: root,
      }),
    ) as [{ filename: string }];
    this.tarball = join(this.folder, packed.filename);
    this.write({ 'package.json': '{ "name": "consumer", "private": true }' });
    execFileSync('npm', ['install', '--silent', '--offline', '--no-audit', '--no-fund', this.tarball], {
      ...npm,
      cwd: this.folder,
    });
  }

  write(files: Readonly<Record<string, string>>): void {
    for (const [name, text] of Object.entries(files)) {
      const file = join(this.folder, name);
      mkdirSync(dirname(file), { recursive: true });
      writeFileSync(file, text);
    }
  }

  /** Runs Node in the project. @returns what it prints, to both outputs. */
  async node(...args: string[]): Promise<string> {
    try {
      const { stdout } = await execFileAsync(process.execPath, args, { cwd: this.folder, maxBuffer: 2 ** 24 });
      return stdout.trim();
    } catch (error) {
      const { stdout, stderr } = error as { stdout: string; stderr: string };
      return `${stdout}${stderr}`.trim();
    }
  }

  remove(): void {
    rmSync(this.folder, { recursive: true, force: true });
  }
}
