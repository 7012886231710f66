/** The values of `RigidBody.kind`: numbers, because the solver asks for it in every loop. In a file of their own, so that bundlers inline them. */
export const DYNAMIC = 0;
export const KINEMATIC = 1;
export const STATIC = 2;
