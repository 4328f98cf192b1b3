/**
 * How the camera of the turntable moves. In the world, y points up, and a picture lies in the plane of x and z with
 * its side as the unit. The camera looks at a target. Its angle goes clockwise from the picture's lower edge; its
 * height is an angle, too.
 */
import { CAMERA } from '../state/asked-view';
import type { Camera } from '../state/viewing';

type Vector3 = readonly [x: number, y: number, z: number];

/** A place in the frame, from its middle to the right and down. The unit is the frame's shorter side. */
export type Spot = readonly [u: number, v: number];

/** The lowest and highest camera in degrees: over the ground, or around one body. */
export type Heights = readonly [least: number, most: number];
export const ALL_AROUND: Heights = [-85, 90];

/** A place on the ground counts if it is at most this many times as far away as the target. */
const FAR = 3;

/** From a low camera, much ground lies in few pixels. This limit keeps the ground from moving faster than the pointer. */
const LOW = 0.3;

/** Turns the camera by `round` degrees around the target, and by `up` degrees in height. */
export function turned([angle, height, ...rest]: Camera, round: number, up: number, [least, most]: Heights): Camera {
  return [(((angle + round) % 360) + 360) % 360, Math.min(most, Math.max(least, height + up)), ...rest];
}

/** The direction from the target towards the camera, with a length of one. */
export function towards([angle, height]: Camera): Vector3 {
  const run = Math.cos(radians(height));
  return [-Math.sin(radians(angle)) * run, Math.sin(radians(height)), Math.cos(radians(angle)) * run].map((value) => Number(value.toFixed(3))) as unknown as Vector3;
}

/**
 * Multiplies the distance to the target by `times`. The place on the ground seen at `at` stays where it is in the
 * frame.
 */
export function nearer(camera: Camera, times: number, at?: Spot): Camera {
  const [angle, height, distance, lens, ...target] = camera;
  const [least, most] = CAMERA[2];
  const next = Math.min(most, Math.max(least, distance * times));
  const fixed = (at && ground(camera, at)) ?? target;
  const moved = target.map((value, k) => (fixed[k] ?? 0) + ((value - (fixed[k] ?? 0)) * next) / distance) as [number, number, number];
  return inReach([angle, height, next, lens, ...moved]);
}

/** Drags the ground from one spot of the frame to another. If either spot shows sky, it drags as if both were in the middle. */
export function dragged(camera: Camera, from: Spot, to: Spot): Camera {
  const [angle, height, distance, lens, x, y, z] = camera;
  const [before, now] = [ground(camera, from), ground(camera, to)];
  if (before && now) return inReach([angle, height, distance, lens, x + before[0] - now[0], y, z + before[2] - now[2]]);
  const [sin, cos] = [Math.sin(radians(angle)), Math.cos(radians(angle))];
  const unit = 2 * distance * Math.tan(radians(lens) / 2);
  const [right, away] = [(to[0] - from[0]) * unit, ((to[1] - from[1]) * unit) / Math.max(Math.sin(radians(height)), LOW)];
  return inReach([angle, height, distance, lens, x - cos * right + sin * away, y, z - sin * right - cos * away]);
}

/** The place on the ground at a spot; undefined if it is too far away, or sky. */
function ground(camera: Camera, [u, v]: Spot): Vector3 | undefined {
  const [angle, height, distance, lens, x, y, z] = camera;
  const [sin, cos] = [Math.sin(radians(angle)), Math.cos(radians(angle))];
  const [rise, run] = [Math.sin(radians(height)), Math.cos(radians(height))];
  const wide = 2 * Math.tan(radians(lens) / 2);
  // The ray through the spot: a sum of the camera's forward, right and up.
  const ray = [sin * run + u * wide * cos - v * wide * sin * rise, -rise - v * wide * run, -cos * run + u * wide * sin + v * wide * cos * rise];
  const [dx = 0, dy = 0, dz = 0] = ray;
  const far = dy < 0 ? (distance * rise) / -dy : Infinity;
  if (far > FAR * distance) return undefined;
  return [x - sin * run * distance + far * dx, y, z + cos * run * distance + far * dz];
}

function inReach(camera: Camera): Camera {
  return camera.map((value, k) => (k < 4 ? value : Math.min(CAMERA[k]?.[1] ?? 0, Math.max(CAMERA[k]?.[0] ?? 0, value)))) as unknown as Camera;
}

function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}
