import type { Physics2DDevice, Vec2, World } from '../src/index.js';
import { buildBreakableChain } from '../test/scenes/breakable-chain.js';
import { buildBridge } from '../test/scenes/bridge.js';
import { buildCallbacks } from '../test/scenes/callbacks.js';
import { buildCradle } from '../test/scenes/cradle.js';
import { buildCrowd } from '../test/scenes/crowd.js';
import { buildGallery } from '../test/scenes/gallery.js';
import { buildGearTrain } from '../test/scenes/gear-train.js';
import { buildHills } from '../test/scenes/hills.js';
import { buildJointGrid } from '../test/scenes/joint-grid.js';
import { buildLoadedRopes } from '../test/scenes/loaded-ropes.js';
import { buildMaterials } from '../test/scenes/materials.js';
import { buildPinball } from '../test/scenes/pinball.js';
import { buildPlatformer } from '../test/scenes/platformer.js';
import type { Play } from '../test/scenes/play.js';
import { buildPulleyLift } from '../test/scenes/pulley-lift.js';
import { buildPyramid } from '../test/scenes/pyramid.js';
import { buildRagdoll, buildStairs } from '../test/scenes/ragdoll.js';
import { buildRatchet, hangWeight } from '../test/scenes/ratchet.js';
import { buildSoftBodies } from '../test/scenes/soft-body.js';
import { rain } from '../test/scenes/speed/piles.js';
import type { SpeedScene } from '../test/scenes/speed/scene.js';
import { drumOf } from '../test/scenes/speed/worlds.js';
import { buildTower } from '../test/scenes/stacks.js';
import { buildArch, buildCardHouse, buildDominoes } from '../test/scenes/standing.js';
import { buildThinWalls } from '../test/scenes/thin-walls.js';
import { buildTileRun } from '../test/scenes/tile-run.js';
import { buildTopDown } from '../test/scenes/top-down.js';
import { buildBreakableWall } from '../test/scenes/wall.js';
import { buildWreckingBall } from '../test/scenes/wrecking-ball.js';

/** A scene of the playground. */
export interface Scene {
  /** In links. */
  readonly id: string;
  readonly title: string;
  /** One sentence about what to look at. */
  readonly note: string;
  /** What is to be seen at the start, [minX, minY, maxX, maxY] in m. */
  readonly view: readonly [number, number, number, number];
  /** Default [0, 10]. */
  readonly gravity?: Readonly<Vec2>;
  /** Whether the arrow keys do something. */
  readonly controls?: boolean;
  build(phys2D: Physics2DDevice, world: World): Play;
}

type View = Scene['view'];
type Build = (phys2D: Physics2DDevice, world: World) => unknown;

const NOTHING: Play = {};

/** A scene that needs nobody. */
function still(id: string, title: string, note: string, view: View, build: Build, gravity?: Vec2): Scene {
  const run: Scene['build'] = (phys2D, world) => {
    build(phys2D, world);
    return NOTHING;
  };
  return { id, title, note, view, build: run, ...(gravity === undefined ? {} : { gravity }) };
}

/** A scene of the bench in a world of ours. */
function ofBench(scene: SpeedScene): Build {
  return (phys2D, world) => {
    const device: Physics2DDevice = Object.create(phys2D);
    device.createWorld = () => world;
    scene.start(device);
  };
}

export const groups: readonly { readonly title: string; readonly scenes: readonly Scene[] }[] = [
  {
    title: 'Classics',
    scenes: [
      {
        id: 'materials',
        title: 'Mixed materials',
        note: 'Rubber, ice, steel, wood and foam go round on belts, a lift and a pusher.',
        view: [-10.2, -9.6, 11, 1],
        build: buildMaterials,
      },
      {
        id: 'callbacks',
        title: 'Event callbacks',
        note: 'A sensor throws things up, through platforms that let pass what comes from below.',
        view: [-8.6, -12, 8.6, 1],
        build: buildCallbacks,
      },
      still('constraints', 'All constraints', 'One of each kind.', [0, 0, 15, 10], buildGallery),
    ],
  },
  {
    title: 'Stacks',
    scenes: [
      still('pyramid', 'Pyramid', '210 boxes that stand still.', [-13, -21.5, 13, 1.5], (phys2D, world) =>
        buildPyramid(phys2D, world, 20),
      ),
      still('tower', 'Tower', '16 boxes, each a little off the one below.', [-9, -17.5, 9, 1], (phys2D, world) =>
        buildTower(phys2D, world, { count: 16, offset: 0.1, friction: 0.6 }),
      ),
      still('dominoes', 'Dominoes', 'A ball tips over the first.', [-4, -3.4, 12.4, 1], buildDominoes),
      still('arch', 'Arch', '17 wedges without mortar carry four boxes.', [-12, -15, 12, 1], buildArch),
      still(
        'cards',
        'House of cards',
        'Cards of 2 mm that lean on each other.',
        [-1.8, -2.1, 1.8, 0.2],
        buildCardHouse,
      ),
      still('wall', 'Breakable wall', 'Mortar holds until it breaks.', [-9, -9, 13, 1.4], buildBreakableWall),
    ],
  },
  {
    title: 'Joints',
    scenes: [
      still('bridge', 'Bridge', '16 planks and their load.', [-8.6, -5, 8.6, 4.6], buildBridge),
      still('wrecking-ball', 'Wrecking ball', 'A heavy ball on a light chain.', [-10, -10.4, 11, 1], buildWreckingBall),
      still('ropes', 'Ropes', 'Over drums with and without friction, and a wheel.', [-9, -2.6, 9, 9], buildLoadedRopes),
      still('chain', 'Breaking chain', 'It breaks where it is weakest.', [-5, -5.4, 5, 3], buildBreakableChain),
      still('ragdolls', 'Ragdolls', 'Joints with limits and friction.', [-6, -12, 10, 6], (phys2D, world) => {
        buildStairs(phys2D, world);
        for (let i = 0; i < 5; i += 1) {
          const { parts } = buildRagdoll(phys2D, world, [-3.4 + 0.3 * i, -1.5 - 2.6 * i]);
          parts[0]!.setVelocity([1 + 0.5 * i, 0]);
        }
      }),
      still('gears', 'Gear train', 'A motor drives the first wheel.', [-1.4, -2, 4.6, 2], buildGearTrain),
      still(
        'lift',
        'Pulley lift',
        'One rope: what is on the right moves half as far.',
        [-6, -9, 6, 5],
        buildPulleyLift,
      ),
      still(
        'cradle',
        "Newton's cradle",
        'What hits on one side leaves on the other.',
        [-6.2, -5, 6.2, 1.4],
        buildCradle,
      ),
      still(
        'grid',
        'Joint grid',
        '400 discs and 760 joints, which keep it in shape.',
        [-5, -2, 25, 26],
        (phys2D, world) => buildJointGrid(phys2D, world, 20),
      ),
      still('soft', 'Soft bodies', 'Discs on elastic distances.', [-8.6, -9.4, 8.6, 1.2], buildSoftBodies),
      still(
        'ratchet',
        'Ratchet',
        'A custom constraint: it turns one way only.',
        [-3.4, -2, 3.4, 3],
        (phys2D, world) => {
          const { wheel } = buildRatchet(phys2D, world);
          hangWeight(phys2D, world, wheel, 1, 2);
        },
      ),
    ],
  },
  {
    title: 'Play',
    scenes: [
      {
        id: 'car',
        title: 'Car',
        note: 'Springs, guides and a motor; it drives by itself. Arrows: faster, back, brake.',
        view: [-7, -5, 7, 3],
        controls: true,
        build: buildHills,
      },
      {
        id: 'platformer',
        title: 'Platformer',
        note: 'Run and jump with the arrows.',
        view: [-10, -7, 6, 4],
        controls: true,
        build: buildPlatformer,
      },
      {
        id: 'top-down',
        title: 'Top-down car',
        note: 'It drifts when the tyres lose grip. Steer with the arrows.',
        view: [-12.6, -8.6, 12.6, 8.6],
        gravity: [0, 0],
        controls: true,
        build: (phys2D, world) => ({ beforeStep: buildTopDown(phys2D, world).beforeStep! }),
      },
      {
        id: 'pinball',
        title: 'Pinball',
        note: 'The arrows left and right move the flippers.',
        view: [-6, -17, 6, 2],
        gravity: [0, 5],
        controls: true,
        build: buildPinball,
      },
    ],
  },
  {
    title: 'Speed and size',
    scenes: [
      still('thin-walls', 'Bullets', '180 m/s against walls of 4 cm.', [-9, -5.4, 9, 5.4], buildThinWalls, [0, 0]),
      still('tiles', 'Tile floor', 'Nothing catches on the joints, at 16 m/s.', [-18, -3, 18, 11], buildTileRun),
      still('drum', 'Drum', '300 boxes in a drum that turns.', [-11, -11, 11, 11], ofBench(drumOf(300))),
      still('rain', 'Rain', '1,000 circles and polygons.', [-12.5, -21, 12.5, 2], ofBench(rain)),
      still('crowd', '5,000 bodies', 'All of them awake at first.', [-31, -58, 31, 3], (phys2D, world) =>
        buildCrowd(phys2D, world),
      ),
    ],
  },
];

export const scenes: readonly Scene[] = groups.flatMap((group) => group.scenes);

/** The scene of that name, or the first one. */
export function sceneOf(id: string | null): Scene {
  return scenes.find((scene) => scene.id === id) ?? scenes[0]!;
}
