/**
 * What your `userData` is, if you say it once for the whole program; what is not said is `unknown`:
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
 * Then `shape.userData` is `{ damage: number } | null` wherever a shape comes from: an event, a query, a list. The names are `body`, `shape`, `constraint` and
 * `material`. For code that imports; what `require` gives has `unknown`.
 */
// biome-ignore lint/suspicious/noEmptyInterface: it is for others to fill
export interface UserData {}

/** The `userData` of a kind of object, or `null` where none was given. */
export type UserDataOf<Kind extends string> = UserData extends { [K in Kind]: infer T } ? T | null : unknown;
