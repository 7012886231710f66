/** The text of src/solver/simd-code.ts. */
export function compile(): Promise<string>;
