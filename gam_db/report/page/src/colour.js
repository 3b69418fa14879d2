// Colour: normal is grey, colour begins above the limit (lightness falls steadily, so that it is read without hue).
import {D, unpack} from './data.js';

const dark = matchMedia('(prefers-color-scheme:dark)');
const HEAT = [[253, 216, 144], [248, 158, 62], [224, 82, 44], [150, 14, 56]];
const THEMES = {
  light: {below: [229, 233, 237], near: [196, 206, 214], calibration: [226, 239, 228], pause: [246, 247, 249], ground: [255, 255, 255], hatch: [178, 189, 198]},
  dark: {below: [45, 55, 62], near: [72, 86, 95], calibration: [28, 52, 38], pause: [26, 33, 37], ground: [18, 23, 26], hatch: [74, 88, 97]},
};
export const isDark = () => dark.matches;
export const theme = () => THEMES[dark.matches ? 'dark' : 'light'];
export const onTheme = again => dark.addEventListener('change', again);
export const mix = (a, b, t) => [0, 1, 2].map(k => Math.round(a[k] + (b[k] - a[k]) * t));
export const rgb = colour => `rgb(${colour.map(Math.round).join()})`;

/** The colour of what is above: 0 just above the limit, 1 where every state is new. */
export function heat(part) {
  const place = Math.min(0.9999, Math.max(0, part)) * 3, at = Math.floor(place);
  return mix(HEAT[at], HEAT[at + 1], place - at);
}

let bytes = null;
export async function loadStrips() { bytes = await unpack(D.strips, Uint8Array); }
export const byteOf = (signal, column) => bytes[signal.place * D.columns + column];

// The code of a byte: gam_db/report/strips.py.
export const NOTHING = 0, CALIBRATION = 1, PAUSE = 2, AT_LIMIT = 127;

/** What a machine was in a column: judged signals, those above, how far the worst is, and what else is known. */
export function column(signals, at) {
  let judged = 0, above = 0, worst = 0, other = NOTHING, unjudged = false;
  for (const signal of signals) {
    const byte = byteOf(signal, at);
    if (byte <= PAUSE) { if (byte === CALIBRATION || other === NOTHING) other = byte; continue; }
    if (signal.limit == null) { unjudged = true; continue; }
    judged++;
    if (byte > AT_LIMIT) above++;
    worst = Math.max(worst, byte);
  }
  return {judged, above, worst, other, unjudged};
}

/** The colour of a column; null is hatched: there is data, and nothing to judge it by. */
export function colourOf(found, byWorst) {
  const its = theme();
  if (found.judged) {
    if (!found.above) return mix(its.below, its.near, (found.worst - 3) / 124);
    return heat(byWorst ? (found.worst - 128) / 127 : Math.sqrt(found.above / found.judged));
  }
  if (found.unjudged) return null;
  return [its.ground, its.calibration, its.pause][found.other];
}

/** Draw signals as one strip into an image, `high` pixels from row `top` on. */
export function drawStrip(image, signals, byWorst, top, high) {
  const its = theme();
  for (let x = 0; x < D.columns; x++) {
    const colour = colourOf(column(signals, x), byWorst);
    for (let y = top; y < top + high; y++) {
      const [r, g, b] = colour || ((x + y) % 4 === 0 ? its.hatch : its.ground), at = (y * image.width + x) * 4;
      image.data[at] = r; image.data[at + 1] = g; image.data[at + 2] = b; image.data[at + 3] = 255;
    }
  }
}

/** A canvas with one strip. */
export function stripInto(canvas, signals, byWorst, high) {
  canvas.width = D.columns; canvas.height = high;
  const context = canvas.getContext('2d'), image = context.createImageData(D.columns, high);
  drawStrip(image, signals, byWorst, 0, high);
  context.putImageData(image, 0, 0);
}
