import { type RigidBody, phys2D as ruler, type Shape } from '../../../src/index.js';

/** What a body was made of: the size of a box, or the radius of a disc. */
export type Outline =
  | { readonly size: number }
  | { readonly radius: number }
  | { readonly vertices: [number, number][] };

function shapeOf(outline: Outline): Shape {
  if ('radius' in outline) {
    return ruler.createCircleShape(outline);
  }
  const vertices = 'size' in outline ? ruler.createBoxVertices(outline.size, outline.size) : outline.vertices;
  return ruler.createPolygonShape({ vertices });
}

/**
 * The deepest overlap of any two of these bodies, and of any with the ground below y = 0 if there is one, by phys2D's own exact distance,
 * whatever engine moved them.
 */
export function deepestOverlap(
  bodies: readonly RigidBody[],
  outlineOf: (body: RigidBody, i: number) => Outline,
  ground = true,
): number {
  const utils = ruler.createCollisionUtils();
  const world = ruler.createWorld();
  const put = (shape: Shape, position: ArrayLike<number>, rotation: number): Shape => {
    world.addRigidBody(ruler.createRigidBody({ position, rotation, shapes: [shape] }));
    return shape;
  };
  const shapes = bodies.map((body, i) => put(shapeOf(outlineOf(body, i)), body.getPosition(), body.getRotation()));
  if (ground) {
    shapes.push(put(ruler.createPolygonShape({ vertices: ruler.createBoxVertices(2000, 2) }), [0, 1], 0));
  }
  let deepest = 0;
  const found: Shape[] = [];
  for (const shape of shapes) {
    const count = world.shapeQuery(shape, found);
    for (const other of found.slice(0, count)) {
      if (other.id > shape.id) {
        deepest = Math.max(deepest, -utils.signedDistance(shape, other, [0, 0], [0, 0], [0, 0]));
      }
    }
  }
  return deepest;
}
