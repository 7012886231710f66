/** A README with the figures of the pages between its marks; without a page on speed, how to measure it. */
export function withFigures(readme: string, quality: string, speed: string | null): string;
