export { solveVelocityOne, warmStartOne } from './one-point';
export { finishPoints, pushPoints, pushPointsFurther, solveVelocityPoints, warmStartPoints } from './points';
export { solvePositionTwo, solveVelocityTwo, warmStartTwo } from './two-point';
