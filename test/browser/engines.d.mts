/** Where an engine is. @throws if it is nowhere. */
export function find(name: 'firefox' | 'jsc'): string;
