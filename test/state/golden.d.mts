/** A script that leaves `runAll` and `run` in a global `golden`, and needs nothing but the language. */
export function goldenScript(): Promise<string>;
