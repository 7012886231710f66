/** A file of an example that is a page, as it is served. */
export function readExample(name: string, file: string): Promise<string>;
/** What lets pages share memory with workers. */
export const HEADERS: Readonly<Record<string, string>>;
