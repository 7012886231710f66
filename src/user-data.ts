/**
 * Declares the types of your `userData`, once for the whole program; what you do not declare is `unknown`:
 *
 * ```
 * declare module 'phys2d' {
 *   interface UserData {
 *     shape: { damage: number };
 *     body: Entity;
 *   }
 * }
 * ```
 *
 * Then `shape.userData` is `{ damage: number } | null` wherever a shape comes from: an event, a query, a list. The names are `body`,
 * `shape`, `constraint` and `material`. For code that uses `import`; with `require` it is `unknown`.
 */
// biome-ignore lint/suspicious/noEmptyInterface: it is for others to fill
export interface UserData {}

/** The `userData` of a kind of object, or `null` where none was given. */
export type UserDataOf<Kind extends string> = UserData extends { [K in Kind]: infer T } ? T | null : unknown;
