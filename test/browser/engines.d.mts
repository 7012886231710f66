/** Where an engine is. @throws if it is nowhere. */
export function find(name: 'chromium' | 'firefox' | 'jsc'): string;
