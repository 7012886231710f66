export { addForces, advance, advancePoses, moveOn } from './bodies';
export { solvePositionOne, solveVelocityOne, warmStartOne } from './one-point';
export { finishPoints, pushPoints, pushPointsLinearly, solveVelocityPoints, warmStartPoints } from './points';
export { solvePositionTwo, solveVelocityTwo, warmStartTwo } from './two-point';
