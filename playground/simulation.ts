import { phys2D, type World } from '../src/index.js';
import { PHASES } from '../src/profile.js';
import { FixedStepRunner } from '../src/runner.js';
import { type Controls, HANDS_OFF, type Play } from '../test/scenes/play.js';
import { type Scene, sceneOf } from './scenes.js';
import type { Settings } from './settings.js';

const DT = 1 / 60;

/** ms of a part of a frame. */
export type Times = Map<string, number>;

/** A scene that runs: its world, its pace, and what it costs. Knows nothing of a page. */
export class Simulation {
  readonly controls: Controls = { ...HANDS_OFF };
  /** Of the last frame; empty if there was no step in it. */
  readonly times: Times = new Map();
  playing = true;
  /** Grows with each restart. */
  generation = 0;
  scene!: Scene;
  world!: World;
  play!: Play;
  runner!: FixedStepRunner;
  /** Something happened that is not in the link: a hand, a key, a setting in the middle of the run. */
  touched = false;

  constructor(public settings: Settings) {
    this.restart();
  }

  get steps(): number {
    return this.world.timeStamp;
  }

  /** The scene from its start, with the present settings. */
  restart(): void {
    const { settings } = this;
    this.scene = sceneOf(settings.scene);
    this.world = phys2D.createWorld({
      gravity: settings.gravity ?? this.scene.gravity ?? [0, 10],
      velocityIterations: settings.velocityIterations,
      positionIterations: settings.positionIterations,
      substeps: settings.substeps,
      allowSleeping: settings.sleep,
      ...(settings.broadphase === 'sweep' ? { broadphase: phys2D.createSweepAndPruneBroadphase() } : {}),
    });
    this.world.clock = () => performance.now();
    this.play = this.scene.build(phys2D, this.world);
    this.runner = FixedStepRunner.create({ world: this.world, deltaTime: DT, maxSteps: 4 });
    this.touched = false;
    this.generation += 1;
  }

  /** Puts settings into the running world; those that it cannot take any more wait for the restart. */
  apply(settings: Settings): void {
    const { world } = this;
    const old = this.settings;
    this.settings = settings;
    if (settings.scene !== old.scene || settings.broadphase !== old.broadphase) {
      this.restart();
      return;
    }
    world.velocityIterations = settings.velocityIterations;
    world.positionIterations = settings.positionIterations;
    world.substeps = settings.substeps;
    world.setGravity(settings.gravity ?? this.scene.gravity ?? [0, 10]);
    if (world.allowSleeping !== settings.sleep) {
      world.allowSleeping = settings.sleep;
    }
    this.touched ||=
      this.steps > 0 &&
      (settings.velocityIterations !== old.velocityIterations ||
        settings.positionIterations !== old.positionIterations ||
        settings.substeps !== old.substeps ||
        String(settings.gravity) !== String(old.gravity) ||
        settings.sleep !== old.sleep);
  }

  /** Makes the steps that are due after so many seconds of the clock. @returns how many. */
  advance(elapsed: number): number {
    this.times.clear();
    return this.playing ? this.timed(() => this.runner.advance(elapsed * this.settings.speed, () => this.before())) : 0;
  }

  /** One step, or more, at once. */
  step(count = 1): void {
    this.times.clear();
    this.timed(() => {
      for (let i = 0; i < count; i += 1) {
        this.before();
        this.world.step(DT);
      }
      return count;
    });
  }

  hash(): string {
    return this.world.hash();
  }

  private before(): void {
    const { controls } = this;
    this.touched ||= controls.left || controls.right || controls.up || controls.down;
    this.play.beforeStep?.(controls);
  }

  private timed(run: () => number): number {
    const start = performance.now();
    const count = run();
    if (count > 0) {
      addTimes(this.times, this.world, performance.now() - start);
    }
    return count;
  }
}

/** The time that all steps took, shared out as the phases of the last step did. */
function addTimes(times: Times, { profile }: World, total: number): void {
  const sum = PHASES.reduce((all, phase) => all + profile![phase], 0);
  for (const phase of PHASES) {
    times.set(phase, sum > 0 ? (total * profile![phase]) / sum : 0);
  }
}
