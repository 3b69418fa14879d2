// Episodes of alarms: as marks on what is drawn over time, and as a list in the words of gam alarms.
import {D, FRAME, alarms} from './data.js';
import {lasting, plural, shortly, when, whole} from './words.js';
import {css, el, linkOf, named} from './dom.js';

/** Most rows of a list; the tables have the rest. */
const SHOWN = 100;

/** Marks at the lower edge of a strip, from the onset of each episode to its last open judgement. */
export function markStrip(canvas, signals) {
  const context = canvas.getContext('2d'), x = time => Math.round((Math.min(FRAME.last, Math.max(FRAME.first, time)) - FRAME.first) / FRAME.span * canvas.width);
  context.fillStyle = css('--ink');
  for (const signal of signals) for (const one of signal.alarms) if (one.status !== 'withdrawn') context.fillRect(x(one.since), canvas.height - 2, Math.max(2, x(one.last) - x(one.since)), 2);
}

/** Marks at the upper edge of a chart over time. */
export function markChart(made, signal) {
  const {ctx, bbox} = made, x = time => Math.min(bbox.left + bbox.width, Math.max(bbox.left, made.valToPos(time, 'x', true)));
  ctx.save();
  ctx.fillStyle = css('--ink');
  for (const one of signal.alarms) if (one.status !== 'withdrawn') ctx.fillRect(x(one.since), bbox.top, Math.max(3, x(one.last) - x(one.since)), 4 * devicePixelRatio);
  ctx.restore();
}

function said(one) {
  const label = one.label ? one.label.replace('_', ' ') : one.proving ? 'in its first windows: needs a decision' : 'none yet';
  return one.note ? [`${label}: `, named(one.note)] : [label];
}

/** The list of episodes of all signals, or of one. */
export function list(of, titled) {
  const found = of ? of.alarms : alarms;
  if (!found.length) return [];
  const head = [...(of ? [] : ['signal']), 'alarm', 'since', 'until', 'evidence', 'feedback'];
  const row = one => el('tr', {'data-alarm': one.id}, of ? null : el('td', {}, el('a', {href: linkOf(one.signal)}, named(one.signal.machine.name), ' · ', named(one.signal.name))),
    el('td', {}, `${whole.format(one.id)}, ${one.status}`), el('td', {title: when(one.since)}, shortly(one.since)), el('td', {}, one.status === 'open' ? `goes on (${lasting(FRAME.last - one.since)})` : shortly(one.last)),
    el('td', {title: `opens at ${whole.format(one.height)}`}, one.height > 1 ? `${(one.evidence / one.height).toFixed(1)} times the threshold` : 'by its indicator'), el('td', {}, said(one)));
  const open = found.filter(one => one.status === 'open').length, more = found.length > SHOWN ? `; the first ${SHOWN} are shown` : '';
  return [titled('Alarms', `${open ? `${plural(open, 'episode')} open` : 'none open'}, ${whole.format(found.length)} in all${more}; ${of ? 'dark bars above mark them' : 'dark bars below the strips mark them'}`),
    of || !D.promise ? null : el('p', {class: 'lead promise'}, D.promise),
    el('div', {class: 'table alarms', tabindex: '0', role: 'region', 'aria-label': 'Episodes of alarms'}, el('table', {}, el('thead', {}, el('tr', {}, head.map(text => el('th', {scope: 'col'}, text)))), el('tbody', {}, found.slice(0, SHOWN).map(row))))].filter(Boolean);
}

/** The finding on the open episode of a signal, and what to do next; null where none is open. */
export function advice(signal) {
  const one = signal.alarms.find(one => one.status === 'open' && one.finding);
  return one ? el('p', {class: 'state advice', 'data-advice': one.id}, el('b', {}, el('bdi', {}, one.finding)), ' ', el('bdi', {}, one.advice)) : null;
}
