// Union–find: `parent` leads from each number to another one of its set, in the end to the one that stands for the set, which leads to itself.

/** The one that stands for the set of a number, halving the way on the way (Tarjan & van Leeuwen 1984). */
export function rootOf(parent: Int32Array, number: number): number {
  let root = number;
  while (parent[root] !== root) {
    parent[root] = parent[parent[root]!]!;
    root = parent[root]!;
  }
  return root;
}

/** Makes one set of those of two numbers. The lowest number of a set stands for it. */
export function unite(parent: Int32Array, a: number, b: number): void {
  const rootA = rootOf(parent, a);
  const rootB = rootOf(parent, b);
  if (rootA < rootB) {
    parent[rootB] = rootA;
  } else {
    parent[rootA] = rootB;
  }
}
