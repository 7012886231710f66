// Union–find: `parent` links each number to another one of its set, and in the end to the root, which represents the set and links to itself.

/** The root of a number's set. Halves the path on the way (Tarjan & van Leeuwen 1984). */
export function rootOf(parent: Int32Array, number: number): number {
  let root = number;
  while (parent[root] !== root) {
    parent[root] = parent[parent[root]!]!;
    root = parent[root]!;
  }
  return root;
}

/** Unites the sets of two numbers. The lowest number of a set is its root. */
export function unite(parent: Int32Array, a: number, b: number): void {
  const rootA = rootOf(parent, a);
  const rootB = rootOf(parent, b);
  if (rootA < rootB) {
    parent[rootB] = rootA;
  } else {
    parent[rootA] = rootB;
  }
}
