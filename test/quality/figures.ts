import type { Physics2DDevice } from '../../src/index.js';
import type { Claim, Figure } from './claims/index.js';

/** A figure with the scene that it is of. */
export interface Measured extends Figure {
  readonly claim: string;
  readonly scene: string;
}

export function measure(claims: Readonly<Record<string, Claim>>, phys2D: Physics2DDevice): Measured[] {
  return Object.entries(claims).flatMap(([claim, { scene, measure }]) =>
    measure(phys2D).map((figure) => ({ claim, scene, ...figure })),
  );
}

export function isMissed({ value, limit }: Figure): boolean {
  return limit !== undefined && !(value <= limit);
}

function digits(value: number): string {
  return value === 0 ? '0' : Math.abs(value) < 1e-9 ? '< 1e-9' : String(Number(value.toPrecision(3)));
}

/** The table of all figures, as committed. */
export function tableOf(measured: readonly Measured[]): string {
  const sorted = [...measured].sort((a, b) => (a.claim < b.claim ? -1 : a.claim > b.claim ? 1 : 0));
  const rows = sorted.map((figure, i) => {
    const scene = sorted[i - 1]?.scene === figure.scene ? '' : figure.scene;
    const target = figure.limit === undefined ? '' : `${figure.limit}`;
    const value = isMissed(figure) ? `**${digits(figure.value)}**` : digits(figure.value);
    return `| ${scene} | ${figure.what} | ${value} | ${target} | ${figure.unit} |`;
  });
  return [
    '# Figures of the solver',
    '',
    'Written by `npm run figures`; a test fails if they are others. At most the target is wanted; what misses it is bold. Steps of 1/60 s, 10 m/s², default settings, no',
    'sleep but in the row about places far away.',
    '',
    '| scene | figure | value | target | unit |',
    '| --- | --- | --- | --- | --- |',
    ...rows,
    '',
  ].join('\n');
}
