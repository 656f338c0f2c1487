/** What the page of the 3D view adds to the window of its frame. */

/** The state of the picture (app/scene/viewer_page.py). */
interface PictureState {
  /** Age of the picture in s; Infinity before the first. */
  age(): number;
  /** Age of the drawn pose in s; Infinity before the first. */
  lag(): number;
  /** False while the canvas has no drawing context. */
  draws(): boolean;
}

/** The part of viser's inner state that this program uses; viser publishes no types of it. */
interface ViserState {
  camera?: {
    filmOffset: number;
    getFilmWidth(): number;
    updateProjectionMatrix(): void;
  };
  cameraControl?: {
    getFocalOffset(): { x: number };
    setFocalOffset(x: number, y: number, z: number, isSmooth: boolean): void;
  };
  requestRender(): void;
}

interface Window {
  bodydriveView?: PictureState;
  __viserMutable?: ViserState;
}
