// Numbers, times and verdicts in words: those of gam status.
import {D, FRAME} from './data.js';

export const whole = new Intl.NumberFormat('en-US');
export const plural = (n, one) => `${whole.format(n)} ${one}${n === 1 ? '' : 's'}`;

/** A share of 0 to 1, short. */
export const share = x => x == null || Number.isNaN(x) ? '–' : x > 0 && x < 0.001 ? '< 0.001' : x < 0.1 ? String(+x.toFixed(3)) : String(+x.toFixed(2));
/** A reading, in three digits. */
export const reading = x => x == null || Number.isNaN(x) ? '–' : Math.abs(x) >= 1e5 || (x !== 0 && Math.abs(x) < 1e-3) ? x.toExponential(1) : String(+x.toPrecision(3));
export const percent = x => x == null ? '–' : x > 0 && x < 0.001 ? '< 0.1 %' : x < 0.1 ? `${+(100 * x).toFixed(1)} %` : `${Math.round(100 * x)} %`;

const formats = new Map();
function parts(time, options) {
  const key = JSON.stringify(options);
  if (!formats.has(key)) formats.set(key, new Intl.DateTimeFormat('en-GB', {timeZone: D.zone, hourCycle: 'h23', ...options}));
  return formats.get(key).format(new Date(Math.floor(Number(time) / 1000))).replace(/,/g, '');
}
const DAY = 864e8;

/** An instant in the plant's time zone, or as the source counts; `over` is the length that an axis shows. */
export function when(time, over) {
  if (time == null) return '–';
  if (D.counter) return typeof time === 'string' ? time : whole.format(Math.round(time));
  if (over == null) return parts(time, {day: 'numeric', month: 'short', year: 'numeric', hour: '2-digit', minute: '2-digit'});
  if (over > 500 * DAY) return parts(time, {month: 'short', year: 'numeric'});
  if (over > 5 * DAY) return parts(time, {day: 'numeric', month: 'short'});
  if (over > DAY) return parts(time, {day: 'numeric', month: 'short', hour: '2-digit', minute: '2-digit'});
  return parts(time, over > 18e8 ? {hour: '2-digit', minute: '2-digit'} : {hour: '2-digit', minute: '2-digit', second: '2-digit'});
}

/** An instant without its year, where the page is about less than a year. */
export const shortly = time => time == null || D.counter || FRAME.span > 300 * DAY ? when(time) : parts(time, {day: 'numeric', month: 'short', hour: '2-digit', minute: '2-digit'});

/** Where the marks of an axis of time stand. */
export function ticks(from = FRAME.first, to = FRAME.last, many = 6) {
  const rough = (to - from) / many, found = [];
  let step;
  if (D.counter) {
    const power = 10 ** Math.floor(Math.log10(Math.max(1, rough)));
    step = [1, 2, 5, 10].map(k => k * power).find(s => s >= rough) || 10 * power;
  } else {
    const steps = [1e6, 2e6, 5e6, 1e7, 15e6, 3e7, 6e7, 12e7, 3e8, 6e8, 18e8, 36e8, 108e8, 216e8, 432e8, DAY, 2 * DAY, 7 * DAY, 14 * DAY, 30 * DAY, 90 * DAY, 365 * DAY];
    step = steps.find(s => s >= rough) || 365 * DAY;
  }
  let shift = 0;   // marks stand at round times of the plant's clock; days of a change of clock are an hour off
  if (!D.counter && step >= 36e8) {
    const at = new Date(from / 1000), there = Object.fromEntries(new Intl.DateTimeFormat('en-US', {timeZone: D.zone, hourCycle: 'h23', year: 'numeric', month: 'numeric', day: 'numeric', hour: 'numeric', minute: 'numeric', second: 'numeric'}).formatToParts(at).map(p => [p.type, +p.value]));
    shift = (Date.UTC(there.year, there.month - 1, there.day, there.hour, there.minute, there.second) - Math.floor(at / 1000) * 1000) * 1000;
  }
  for (let t = Math.ceil((from + shift) / step) * step - shift; t <= to; t += step) found.push(t);
  return found;
}

/** A length of time. */
export function lasting(length) {
  const n = Number(length);
  if (D.counter) return plural(n, 'step');
  for (const [unit, size] of [['d', DAY], ['h', 36e8], ['min', 6e7], ['s', 1e6]]) if (n >= 2 * size) return `${whole.format(Math.floor(n / size))} ${unit}`;
  return `${(n / 1e6).toPrecision(2)} s`;
}

const side = outside => outside == null ? '' : outside > 0.9 ? 'outside the calibrated range' : outside > 0.1 ? 'partly outside the calibrated range' : 'inside the calibrated range';
const sideShort = outside => outside == null ? '' : outside > 0.9 ? ', out of range' : outside > 0.1 ? ', partly out of range' : ', within range';
export const since = (signal, as = when) => `${signal.atLeast ? 'at least since' : 'since'} ${as(signal.since)}`;

/** What to do about a signal that would show no shift, by the reason. */
const BLIND = {
  range: 'most readings lie in a small part of its range: use --null for values that are not readings, or --exclude for their time',
  blocks: 'parts of its calibration differ from each other: calibrate longer, or use a window of whole cycles',
  cells: 'its grid does not fit the signal: use --bins auto',
  delay: 'the samples of a vector are too similar: use --tau auto --bins auto',
};

/** Why a signal cannot be judged, and what to do; two short sentences. */
export function unjudged(signal) {
  if (signal.status === 'setup' && (signal.verdict === 'ready' || signal.verdict === 'blind')) return ['its calibration was not a fair sample of what followed', 'calibrate longer, or later'];
  if (signal.status === 'standing') return ['it stands still', 'it is judged again once it moves'];
  if (signal.status === 'blind') return ['it would show no shift of its machine', BLIND[signal.blind]];
  switch (signal.verdict) {
    case 'constant': return ['it was constant in calibration', 'it never raises an alarm; calibrate it over a time in which it moves'];
    case 'no_data': return ['no usable reading in calibration', 'check the calibration interval and missing values'];
    case 'too_fine': return ['the grid is too fine for so short a calibration', signal.finest ? `use --bins ${signal.finest} or fewer, or calibrate longer` : 'calibrate longer'];
    case 'not_vouched': return [signal.vouching, 'name more machines of its pool as healthy'];
    case 'needs_data': return ['calibration is too short', signal.needed ? `about ${whole.format(signal.needed)} more vectors are needed` : 'calibrate longer'];
    default: return ['no full window is scored yet', `wait for ${whole.format(signal.window)} scored readings`];
  }
}

/** The episode or indicator by which a signal is above its limit, in words. */
export const judgedBy = signal => signal.episode == null ? 'by its indicator' : `episode ${signal.episode}${signal.status === 'proving' ? ', proving' : signal.by === 'indicator' ? ', by its indicator' : ''}${signal.label ? `, labelled ${signal.label.replace('_', ' ')}` : ''}`;

/** How far the indicator of a signal is above its limit. */
const far = signal => signal.far ? 'far ' : '';

/** The changes (a frozen sensor, half a stroke, another speed) that a signal would not show. */
const unseen = signal => signal.unseen ? `; would not see ${signal.unseen}` : '';

/** The machines whose calibration judges a signal that taught its pool nothing; empty if it is not judged. */
const vouched = signal => signal.vouching && signal.verdict !== 'not_vouched' ? `; ${signal.vouching}` : '';

/** The state of a signal in one line. */
export function brief(signal) {
  const silent = signal.silent == null ? '' : ` · silent for ${lasting(signal.silent)}`;
  if (!signal.judged) return `not judged: ${unjudged(signal)[0]}${silent}`;
  if (signal.above) return `${since(signal, shortly)}${sideShort(signal.outside)}, ${judgedBy(signal)}${vouched(signal)}${silent}`;
  if (signal.labelled) return judgedBy(signal) + vouched(signal) + silent;
  return (signal.over ? `indicator ${far(signal)}above its limit, no episode so far` : signal.rising ? 'below its limit, and rising' : `as in calibration${unseen(signal)}`) + vouched(signal) + silent;
}

export function sentence(signal) {
  if (!signal.judged) { const [why, what] = unjudged(signal); return `${why}; ${what}.`; }
  if (signal.above) return `visits states that it never visited while healthy ${since(signal)}, and is above its limit (${judgedBy(signal)}); its new states lie ${side(signal.outside) || 'in range'}${vouched(signal)}.`;
  if (signal.labelled) return `${judgedBy(signal)}, so it is not counted as above its limit${vouched(signal)}.`;
  if (signal.over) return `its indicator is ${far(signal)}above its limit, but no episode opened so far${vouched(signal)}.`;
  return signal.rising ? `below its limit, and rising${vouched(signal)}.` : `behaves as in calibration${unseen(signal)}${vouched(signal)}.`;
}
