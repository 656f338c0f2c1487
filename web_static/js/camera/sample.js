/**
 * The message with which a page sends what it has read in one picture (docs/protocols.md, section 5): version, 0, number
 * of channels, number of the sample, times of picture and sending in s of this page, and the values, NaN where unknown.
 */

const VERSION = 1;
const HEADER = 24; // bytes

/**
 * @param {{seq: number, pictureTime: number, sentTime: number, values: readonly number[]}} sample times in s
 * @returns {ArrayBuffer}
 */
export function encodeSample({ seq, pictureTime, sentTime, values }) {
  const message = new DataView(new ArrayBuffer(HEADER + 4 * values.length));
  message.setUint8(0, VERSION);
  message.setUint16(2, values.length, true);
  message.setUint32(4, seq, true);
  message.setFloat64(8, pictureTime, true);
  message.setFloat64(16, sentTime, true);
  values.forEach((value, i) => message.setFloat32(HEADER + 4 * i, value, true));
  return message.buffer;
}
