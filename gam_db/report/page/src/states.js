// The states: healthy and new cells as boxes, as flat pictures, and the most visited new ones in units.
import {unpack} from './data.js';
import {heat, mix, rgb, theme} from './colour.js';
import {percent, plural, reading, shortly, when, whole} from './words.js';
import {css, el} from './dom.js';
import {drawBoxes} from './boxes.js';

async function cells(packed) {
  const axes = [];
  for (const axis of packed.axes) axes.push(await unpack(axis, Uint32Array));
  return {axes, visits: await unpack(packed.visits, Uint32Array), all: packed.all};
}

/** The interval of a code, in the signal's units where they may be in the file. */
export function interval([place, code, from, to], signal) {
  if (place === 'missing') return place;
  if (from == null && to == null) return place === 'within' ? `bin ${code - 1} of ${signal.bins}` : signal.verdict === 'no_data' ? 'no range' : `${place} range`;
  return place === 'below' ? `< ${reading(to)}` : place === 'above' ? `> ${reading(from)}` : `${reading(from)} … ${reading(to)}`;
}

export async function drawStates(main, titled, signal, known, isStill) {
  const healthy = await cells(known.healthy), fresh = await cells(known.new);
  const ago = k => k === 0 ? 'now' : k * signal.tau === 1 ? 'one reading before' : `${k * signal.tau} readings before`;
  const axes = healthy.axes.length, more = signal.m > 3 ? `; the first three of ${signal.m} axes are shown` : '';
  const said = signal.m === 1 ? 'a state is one reading' : signal.m === 2 ? `a state is the reading now and the one ${ago(1)}` : `a state is the reading now and ${signal.m - 1} before, ${plural(signal.tau, 'reading')} apart`;
  main.append(titled('States', `${said}; ${whole.format(healthy.all)} healthy, ${whole.format(fresh.all)} new${more}`));
  if (!healthy.all && !fresh.all) { main.append(el('p', {class: 'lead'}, 'No states yet.')); return; }
  const flats = el('div', {class: 'flats'}), table = el('div', {class: 'table', tabindex: '0', role: 'region', 'aria-label': 'The new states it visits most'});
  const key = el('p', {class: 'note key'}, el('i', {style: {background: css('--healthy')}}), 'healthy; darker means more visits', el('i', {style: {background: rgb(heat(0.5))}}), 'new; frame: the calibrated range');
  const side = el('div', {}, flats, key, table);
  const cube = el('div', {class: 'cube', role: 'group', 'aria-label': 'Healthy and new states in three dimensions; the flat pictures and the table have the same content'});
  main.append(el('div', {class: axes > 2 ? 'space' : ''}, axes > 2 ? cube : null, side));
  for (const [i, j] of axes > 2 ? [[0, 1], [0, 2]] : axes > 1 ? [[0, 1]] : [[0, null]]) flats.append(flat(healthy, fresh, signal, i, j, ago));
  tops(table, signal, known.new, ago);
  if (axes > 2) drawBoxes(cube, healthy, fresh, signal, ago, isStill);
}

/** One flat picture: two axes of the states, or one. */
function flat(healthy, fresh, signal, i, j, ago) {
  const codes = signal.bins + 3, size = Math.max(2, Math.floor(360 / codes)), high = j === null ? Math.max(1, Math.ceil(codes / 8)) : codes;
  const across = `across: ${ago(i)}`, words = j === null ? across : `${across}; up: ${ago(j)}`;
  const canvas = el('canvas', {role: 'img', 'aria-label': `States, ${words}`});
  canvas.width = codes * size; canvas.height = high * size;
  const context = canvas.getContext('2d'), sums = new Map();
  const add = (found, which) => found.visits.forEach((visits, n) => { const key = found.axes[i][n] * codes + (j === null ? 0 : found.axes[j][n]), sum = sums.get(key) || [0, 0]; sum[which] += visits; sums.set(key, sum); });
  add(healthy, 0); add(fresh, 1);
  let most = [1, 1];
  for (const sum of sums.values()) { most[0] = Math.max(most[0], sum[0]); if (!sum[0]) most[1] = Math.max(most[1], sum[1]); }
  const pale = theme().near, deep = css('--healthy').match(/\w\w/g).map(hex => parseInt(hex, 16));
  let only = 0;
  for (const [key, sum] of sums) {
    const x = Math.floor(key / codes), y = key % codes;
    if (!sum[0]) only++;
    context.fillStyle = rgb(sum[0] ? mix(pale, deep, Math.log1p(sum[0]) / Math.log1p(most[0])) : heat(0.2 + 0.8 * Math.log1p(sum[1]) / Math.log1p(most[1])));
    const gap = size > 4 ? 1 : 0;
    j === null ? context.fillRect(x * size, 0, size - gap, canvas.height) : context.fillRect(x * size, (codes - 1 - y) * size, size - gap, size - gap);
  }
  context.strokeStyle = css('--soft'); context.lineWidth = 2;
  context.strokeRect(2 * size - 0.5, j === null ? 0.5 : size - 0.5, signal.bins * size, j === null ? canvas.height - 1 : signal.bins * size);
  canvas.dataset.fresh = String(only);
  return el('figure', {class: j === null ? 'line' : ''}, canvas, el('figcaption', {}, words));
}

function tops(table, signal, fresh, ago) {
  if (!fresh.top.length) { table.append(el('p', {class: 'note'}, 'No new state was visited since calibration.')); return; }
  const shown = Math.min(3, signal.m);
  const programs = fresh.top.some(top => top.length > 4);
  const row = ([axes, visits, away, first, program]) => el('tr', {}, programs ? el('td', {}, program ?? '–') : null, axes.map(axis => el('td', {}, interval(axis, signal))), el('td', {title: `${plural(visits, 'visit')}`}, percent(visits / fresh.total)),
    el('td', {}, away < 0 ? '–' : away === 1 ? 'next to it' : `${away} cells away`), el('td', {title: when(first)}, shortly(first)));
  table.append(el('table', {}, el('caption', {}, 'The new states it visits most'),
    el('thead', {}, el('tr', {}, programs ? el('th', {scope: 'col'}, 'program') : null, Array.from({length: shown}, (_, k) => el('th', {scope: 'col'}, k ? `${k * signal.tau} before` : 'reading now')), ['share', 'nearest healthy', 'first'].map(text => el('th', {scope: 'col'}, text)))),
    el('tbody', {}, fresh.top.map(row))));
}
