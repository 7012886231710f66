/** The values of `Shape.kind`: numbers, because loops over pairs ask for it. In a file of their own, so that bundlers inline them. */
export const CIRCLE = 0;
export const POLYGON = 1;
