export { solveVelocityOne, warmStartOne } from './one-point';
export { solvePositionTwo, solveVelocityTwo, warmStartTwo } from './two-point';
