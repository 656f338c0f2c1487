/** The message of a phone that is a sensor, as app/hardware/shirt/orientation_sensors/phones.py reads it. */

const VERSION = 1;
const BYTES = 32;
export const LARGEST_PAGE = 2 ** 32 - 1;

/** How a device is held, in degrees. @typedef {{alpha: number, beta: number, gamma: number}} Angles the W3C's Device Orientation */

/**
 * @param {number} page a random number of this page, up to LARGEST_PAGE @param {number} seq counts its messages
 * @param {number} sent when it is sent, in s of this page's clock @param {Angles} angles
 */
export function sampleOf(page, seq, sent, { alpha, beta, gamma }) {
  const message = new DataView(new ArrayBuffer(BYTES));
  message.setUint8(0, VERSION);
  message.setUint32(4, page, true);
  message.setUint32(8, seq, true);
  message.setFloat64(12, sent, true);
  message.setFloat32(20, alpha, true);
  message.setFloat32(24, beta, true);
  message.setFloat32(28, gamma, true);
  return message.buffer;
}
