// What any engine gets right, if it is given the right scene: bad figures of a claim are its own then, not its adapter's.

const DT = 1 / 60;

/** @returns for each check what came out, what should, and whether it is near enough. */
export function checks(device) {
  return [
    free(device),
    ...fall(device, false),
    ...fall(device, true),
    ...period(device),
    bounce(device),
    ...ramp(device),
    ...densities(device),
    apart(device),
    rotated(device),
    removed(device),
    asleep(device),
    ...kinematic(device),
    ...compound(device),
    ...(device.lacksLimits ? [] : [limited(device)]),
    awake(device),
  ];
}

function check(what, value, expected, tolerance) {
  return { what, value, expected, good: Math.abs(value - expected) <= tolerance };
}

function repeat(world, seconds, look = () => {}) {
  for (let i = 1; i <= Math.round(seconds / DT); i += 1) {
    world.step(DT);
    look(i);
  }
}

function plain(device, friction, more = {}) {
  return device.createMaterial({ staticFriction: friction, dynamicFriction: friction, rollingFriction: 0, ...more });
}

function add(device, world, shape, params) {
  const body = device.createRigidBody({ linearDrag: 0, angularDrag: 0, shapes: [shape].flat(), ...params });
  world.addRigidBody(body);
  return body;
}

function box(device, width, height, material) {
  return device.createPolygonShape({ vertices: device.createBoxVertices(width, height), material });
}

/** Thrown and turning: units, signs and drag. */
function free(device) {
  const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
  const body = add(device, world, box(device, 1, 1, plain(device, 0)), {
    position: [2, 3],
    rotation: 0.5,
    velocity: [3, -4],
    angularVelocity: 2,
  });
  repeat(world, 1);
  const [x, y] = body.getPosition();
  const [vx, vy] = body.getVelocity();
  const [cx, cy] = body.transformLocalPointToWorld([1, 0]);
  const off = [
    x - 5,
    y - 4,
    vx - 3,
    vy - 6,
    body.getAngularVelocity() - 2,
    cx - x - Math.cos(2.5),
    cy - y - Math.sin(2.5),
  ];
  // Half a step of gravity is 0.083 m.
  return check('thrown: farthest off', Math.max(...off.map(Math.abs)), 0, 0.2);
}

/** Onto a ground, of one shape or as one of several tiles. */
function fall(device, tiled) {
  const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = plain(device, 0.6);
  const tile = (x) => device.createPolygonShape({ vertices: device.createRectangleVertices(x, 0, x + 4, 2), material });
  if (tiled) {
    add(device, world, [-10, -6, -2, 2, 6].map(tile), { type: 'static', position: [0, 0] });
  } else {
    add(device, world, box(device, 20, 2, material), { type: 'static', position: [0, 1] });
  }
  const body = add(device, world, box(device, 1, 1, material), { position: [5, -1.5] });
  const ball = add(device, world, device.createCircleShape({ radius: 0.5, material }), { position: [-5, -1.5] });
  repeat(world, 4);
  const on = tiled ? 'on tiles of one body' : 'on the ground';
  return [
    check(`box rests ${on} at`, body.getPosition()[1], -0.5, 0.02),
    check(`ball rests ${on} at`, ball.getPosition()[1], -0.5, 0.02),
  ];
}

/** A bar of 2 m that hangs on its end, at a small amplitude, with the inertia that the engine gives it. */
function period(device) {
  const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
  const pivot = device.createRigidBody({ type: 'static', position: [1, 2] });
  world.addRigidBody(pivot);
  const vertices = device.createBoxVertices(0.2, 2);
  const shape = device.createPolygonShape({ vertices, group: 2, mask: 1, material: plain(device, 0, { density: 3 }) });
  const [s, c] = [Math.sin(0.2), Math.cos(0.2)];
  const bar = add(device, world, shape, { position: [1 + s, 2 + c], rotation: -0.2 });
  world.addConstraint(device.createPointConstraint({ bodyA: pivot, bodyB: bar, anchorA: [0, 0], anchorB: [0, -1] }));
  const crossings = [];
  let last = s;
  repeat(world, 10, (step) => {
    const x = bar.getPosition()[0] - 1;
    if (x < 0 !== last < 0) {
      crossings.push(step - x / (x - last));
    }
    last = x;
  });
  const found = (2 * DT * (crossings.at(-1) - crossings[0])) / (crossings.length - 1);
  const expected = 2 * Math.PI * Math.sqrt((bar.getInertia() / bar.getMass() + 1) / 10) * (1 + 0.04 / 16);
  return [
    check('hanging bar: period, s', found, expected, 0.03 * expected),
    // That of matter-js is four times as large on purpose.
    check('hanging bar: inertia', Math.log(bar.getInertia() / ((1.2 * 4.04) / 12)) / Math.log(4), 0.5, 0.51),
  ];
}

function bounce(device) {
  const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = plain(device, 0, { elasticity: 1 });
  add(device, world, box(device, 20, 2, material), { type: 'static', position: [0, 1] });
  const ball = add(device, world, device.createCircleShape({ radius: 0.25, material }), { position: [0, -4.25] });
  let height = 0;
  repeat(world, 2, (step) => {
    height = step * DT > 0.95 ? Math.max(height, -0.25 - ball.getPosition()[1]) : 0;
  });
  return check('ball of restitution 1, from 4 m, comes back to, m', height, 4, 0.8);
}

/** 20°: friction 0.5 holds but for some creep, 0 does not. */
function ramp(device) {
  const angle = Math.PI / 9;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [0.5, 0].map((friction) => {
    const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
    const material = plain(device, friction);
    add(device, world, box(device, 400, 2, material), { type: 'static', position: [-s, c], rotation: angle });
    const body = add(device, world, box(device, 1, 1, material), { position: [0.5 * s, -0.5 * c], rotation: angle });
    repeat(world, 2);
    const [x, y] = body.getPosition();
    const [expected, tolerance] = friction > 0 ? [0, 0.3] : [20 * s, 0.3];
    return check(`friction ${friction} on 20°: slid in 2 s, m`, x * c + y * s, expected, tolerance);
  });
}

/** A ball hits one of a quarter of its density: the momentum, and the masses. */
function densities(device) {
  const world = device.createWorld({ gravity: [0, 0], allowSleeping: false });
  const ball = (density, x, velocity) => {
    const shape = device.createCircleShape({ radius: 0.5, material: plain(device, 0, { density }) });
    return add(device, world, shape, { position: [x, 0], velocity: [velocity, 0] });
  };
  const [heavy, light] = [ball(4, 0, 5), ball(1, 3, 0)];
  repeat(world, 1);
  const momentum = 4 * heavy.getVelocity()[0] + light.getVelocity()[0];
  return [
    check('ball hits one of a quarter of its density: momentum', momentum, 20, 0.3),
    check('mass of a ball of density 4', heavy.getMass(), Math.PI, 0.05),
  ];
}

/** What is in one group that is not in its mask does not meet. */
function apart(device) {
  const world = device.createWorld({ gravity: [0, 0], allowSleeping: false });
  const ball = (x, velocity) => {
    const shape = device.createCircleShape({ radius: 0.5, group: 2, mask: 1 });
    return add(device, world, shape, { position: [x, 0], velocity: [velocity, 0] });
  };
  const body = ball(0, 3);
  ball(1.5, 0);
  repeat(world, 1);
  return check('goes through one of its own group', body.getPosition()[0], 3, 0.05);
}

/** A triangle, whose origin is not its centre of mass, falls on its long side. */
function rotated(device) {
  const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = plain(device, 0.6);
  add(device, world, box(device, 20, 2, material), { type: 'static', position: [0, 1] });
  const corners = [
    [-1, 0],
    [0, -1],
    [1, 0],
  ];
  const shape = device.createPolygonShape({ vertices: corners, material });
  const body = add(device, world, shape, { position: [3, -1] });
  repeat(world, 4);
  const [x, y] = body.getPosition();
  return check('triangle rests with its origin off by', Math.hypot(x - 3, y), 0, 0.03);
}

function removed(device) {
  const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = plain(device, 0.6);
  const ground = add(device, world, box(device, 20, 2, material), { type: 'static', position: [0, 1] });
  const body = add(device, world, box(device, 1, 1, material), { position: [0, -0.5] });
  repeat(world, 1);
  world.removeRigidBody(ground);
  repeat(world, 1);
  return check('falls, in 1 s after its ground is removed, to', body.getPosition()[1], 4.5, 0.2);
}

function asleep(device) {
  const slept = [true, false].map((allowSleeping) => {
    const world = device.createWorld({ gravity: [0, 10], allowSleeping });
    const material = plain(device, 0.6);
    add(device, world, box(device, 20, 2, material), { type: 'static', position: [0, 1] });
    const body = add(device, world, box(device, 1, 1, material), { position: [0, -0.5] });
    repeat(world, 10);
    return body.sleeping ? 1 : 0;
  });
  return check('sleeps where it may, not where it may not (10)', Number(slept.join('')), 10, 0);
}

/** One turns and goes where it is told, and takes along what lies on it. */
function kinematic(device) {
  const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = plain(device, 1);
  const params = { type: 'kinematic', velocity: [1, 0] };
  const belt = add(device, world, box(device, 20, 2, material), { ...params, position: [0, 1] });
  const rider = add(device, world, box(device, 1, 1, material), { position: [0, -0.5], velocity: [1, 0] });
  const wheel = add(device, world, box(device, 1, 1, material), {
    type: 'kinematic',
    position: [0, -20],
    angularVelocity: 2,
  });
  repeat(world, 1);
  belt.setVelocity([3, 0]);
  repeat(world, 1);
  const turned = wheel.getRotation();
  const turns = Math.round((turned - 4) / (2 * Math.PI));
  return [
    check('kinematic body goes 4 m in 2 s', belt.getPosition()[0], 4, 0.05),
    check('box on it goes along', rider.getPosition()[0], 4, 0.5),
    check('kinematic body turns by 4 rad in 2 s', turned - 2 * Math.PI * turns, 4, 0.05),
  ];
}

/** An L of two boxes around its centre of mass: what it weighs, and that it turns freely around that. */
function compound(device) {
  const world = device.createWorld({ gravity: [0, 0], allowSleeping: false });
  const material = plain(device, 0);
  const part = (left, top, right, bottom) =>
    device.createPolygonShape({ vertices: device.createRectangleVertices(left, top, right, bottom), material });
  const shapes = [part(-0.55, 0.05, 0.95, 0.55), part(-0.55, -0.95, -0.05, 0.05)];
  const body = add(device, world, shapes, { position: [1, 2], angularVelocity: 3 });
  repeat(world, 1);
  const [x, y] = body.getPosition();
  const boxInertia = (width, height, x, y) => width * height * ((width ** 2 + height ** 2) / 12 + x ** 2 + y ** 2);
  const inertia = boxInertia(1.5, 0.5, 0.2, 0.3) + boxInertia(0.5, 1, -0.3, -0.45);
  return [
    check('body of two boxes: mass', body.getMass(), 1.25, 0.01),
    // That of matter-js is four times as large on purpose.
    check('body of two boxes: inertia', Math.log(body.getInertia() / inertia) / Math.log(4), 0.5, 0.51),
    check('body of two boxes turns around its centre: off by', Math.hypot(x - 1, y - 2), 0, 0.01),
  ];
}

/** A bar that turns about a joint comes to the limit of its angle, and no farther. */
function limited(device) {
  const world = device.createWorld({ gravity: [0, 10], allowSleeping: false });
  const bodyA = device.createRigidBody({ type: 'static', position: [0, 0] });
  world.addRigidBody(bodyA);
  const shape = device.createPolygonShape({ vertices: device.createBoxVertices(2, 0.2), material: plain(device, 0) });
  const bodyB = add(device, world, shape, { position: [1, 0] });
  world.addConstraint(device.createPointConstraint({ bodyA, bodyB, anchorA: [0, 0], anchorB: [-1, 0] }));
  world.addConstraint(device.createAngleConstraint({ bodyA, bodyB, lowerBound: -0.5, upperBound: 0.5 }));
  repeat(world, 3);
  return check('bar with a limit of 0.5 rad hangs at', bodyB.getRotation(), 0.5, 0.05);
}

/** What is woken before each step does not fall asleep. */
function awake(device) {
  const world = device.createWorld({ gravity: [0, 10] });
  const material = plain(device, 0.6);
  add(device, world, box(device, 20, 2, material), { type: 'static', position: [0, 1] });
  const body = add(device, world, box(device, 1, 1, material), { position: [0, -0.5] });
  let slept = 0;
  body.wake();
  repeat(world, 10, () => {
    slept += body.sleeping ? 1 : 0;
    body.wake();
  });
  return check('steps after which it sleeps though it is woken', slept, 0, 0);
}
