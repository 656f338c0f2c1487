/** What passes between a page and the engine that reads its camera's pictures (web_static/js/camera/pose_engine.js). */

/** One of MediaPipe's 33 landmarks. */
export interface Landmark {
  x: number;
  y: number;
  z: number;
  /** From 0 to 1. */
  visibility?: number;
}

export interface Pose {
  /** x and y as shares of the width and height of the picture, z of its width, less is nearer. */
  picture: readonly Landmark[];
  /** m from the middle of the hips: to the right of the picture, down, away from the camera. */
  world: readonly Landmark[];
}

/** With it, the page begins; `base` is the folder of MediaPipe, `isTouched` says that the screen is touched. */
export type Beginning = { base: string; isTouched: boolean };

/** The answer to a picture, null: nobody is there; also the first, when the engine is ready. */
export type Answer = { pose: Pose | null } | { failed: string };
