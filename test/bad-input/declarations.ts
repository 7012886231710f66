import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

export interface Parameter {
  readonly name: string;
  readonly type: string;
  readonly optional: boolean;
}

export interface Callable {
  /** The class, or '' for a function. */
  readonly owner: string;
  readonly name: string;
  readonly kind: 'function' | 'static' | 'method' | 'setter';
  readonly parameters: readonly Parameter[];
}

/** What the published types declare. */
export class Declarations {
  readonly callables: Callable[] = [];
  /** Options by the name of their interface. */
  readonly options = new Map<string, Parameter[]>();
  /** Properties of classes that may be set and are no accessors, such as `RigidBody.userData`. */
  readonly plain: string[] = [];
  private readonly bases = new Map<string, readonly string[]>();

  constructor(folder: string) {
    for (const name of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
      if (name.endsWith('.d.ts')) {
        this.read(readFileSync(join(folder, name), 'utf8').replace(/\/\*[\s\S]*?\*\//g, ''));
      }
    }
  }

  /** A class or interface and all that it is made from. */
  line(name: string): string[] {
    return [name, ...(this.bases.get(name) ?? []).flatMap((base) => this.line(base))];
  }

  /** A declaration is one line each, as the compiler writes them. */
  private read(text: string): void {
    let owner = '';
    let isClass = false;
    for (const line of text.split('\n').map((each) => each.trim())) {
      const opens = /^(?:export )?(?:declare )?(?:abstract )?(class|interface) (\w+)(.*)\{$/.exec(line);
      if (opens !== null) {
        isClass = opens[1] === 'class';
        owner = opens[2]!;
        this.bases.set(
          owner,
          /extends ([\w, ]+?)(?: implements.*)?$/.exec(generic(opens[3]!).trim())?.[1]?.split(', ') ?? [],
        );
        this.options.set(owner, []);
      } else if (line === '}') {
        owner = '';
      } else if (owner !== '' && !isClass) {
        const property = /^(?:readonly )?(\w+)(\??): (.*);$/.exec(line);
        if (property !== null) {
          this.options.get(owner)!.push(parameter(`${property[1]}${property[2]}: ${property[3]}`));
        }
      } else {
        const property = /^(\w+)\??: .*;$/.exec(line);
        if (property !== null && owner !== '') {
          this.plain.push(`${owner}.${property[1]}`);
        }
        this.readCallable(owner, line);
      }
    }
  }

  private readCallable(owner: string, line: string): void {
    const found = /^(export declare function |static |set |)(\w+)(?:<.*?>)?\((.*)\)(?:: [^()]*)?;$/.exec(
      line.replace(/^(?:protected |abstract )+/, ''),
    );
    if (found === null || found[3] === '' || (owner === '' && found[1] !== 'export declare function ')) {
      return;
    }
    const kind =
      owner === '' ? 'function' : found[1] === 'static ' ? 'static' : found[1] === 'set ' ? 'setter' : 'method';
    this.callables.push({ owner, name: found[2]!, kind, parameters: split(found[3]!).map(parameter) });
  }
}

/** Without what is between angle brackets. */
function generic(text: string): string {
  const shorter = text.replace(/<[^<>]*>/g, '');
  return shorter === text ? text : generic(shorter);
}

function parameter(text: string): Parameter {
  const [, name, mark, type] = /^(?:\.\.\.)?(\w+)(\??): (.*)$/.exec(text)!;
  return { name: name!, type: type!.replace(/ \| undefined$/, ''), optional: mark === '?' || text.startsWith('...') };
}

/** At the commas that are not within brackets. */
function split(text: string): string[] {
  const parts = [''];
  let depth = 0;
  for (const [i, letter] of [...text].entries()) {
    depth += '([{<'.includes(letter) ? 1 : ')]}'.includes(letter) || (letter === '>' && text[i - 1] !== '=') ? -1 : 0;
    if (letter === ',' && depth === 0) {
      parts.push('');
    } else {
      parts[parts.length - 1] += letter;
    }
  }
  return parts.map((part) => part.trim());
}
