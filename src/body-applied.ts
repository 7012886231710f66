/** The forces on a body for its next step alone, and those of its last step; for a sleeping body, of the step in which it fell asleep. */
export class Applied {
  /** N */
  x = 0.5;
  y = 0.5;
  /** N·m */
  torque = 0.5;
  lastX = 0.5;
  lastY = 0.5;
  lastTorque = 0.5;
  /** Whether the same forces were applied in the last step, in which it slept. */
  isKept = false;

  constructor() {
    this.clear();
  }

  clear(): void {
    this.stay();
    this.pass();
  }

  /** A step of an awake body begins: its forces become those of the last step. */
  pass(): void {
    this.lastX = this.x;
    this.lastY = this.y;
    this.lastTorque = this.torque;
    this.stay();
    this.isKept = false;
  }

  /** A step begins, and the body sleeps on. */
  stay(): void {
    this.isKept = this.pushes();
    this.x = 0;
    this.y = 0;
    this.torque = 0;
  }

  pushes(): boolean {
    return this.x !== 0 || this.y !== 0 || this.torque !== 0;
  }

  pushedBefore(): boolean {
    return this.lastX !== 0 || this.lastY !== 0 || this.lastTorque !== 0;
  }
}
