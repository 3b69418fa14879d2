// The page of a signal: its states, their times, and whether the healthy data is sufficient.
import {D, FRAME, signals, unpack, unpackTimes} from './data.js';
import {percent, plural, reading, sentence, share, when, whole} from './words.js';
import {heat, rgb, stripInto, theme} from './colour.js';
import {across, chart, gaps, hover, numberAxis, stretch, timeAxis, uPlot, upright} from './charts.js';
import {css, el, linkOf, named} from './dom.js';
import {drawStates} from './states.js';
import {foot, heading} from './fleet.js';
import {advice, list as alarmList, markChart, markStrip} from './alarms.js';

const titled = (text, more) => el('div', {class: 'head'}, el('h2', {}, text), el('span', {class: 'note'}, more));
const calm = matchMedia('(prefers-reduced-motion:reduce)');

export async function drawSignal(app, signal, isStill) {
  const known = D.details[signal.place], name = `${signal.machine.name} · ${signal.name}`;
  document.title = `${name} – ${D.title}`;
  const step = (place, text) => signals[place] ? el('a', {href: linkOf(signals[place])}, text) : el('span', {class: 'note'}, text);
  const main = el('main', {id: 'main', tabindex: '-1'},
    el('nav', {class: 'crumb', 'aria-label': 'Signals'}, el('a', {href: '#/'}, '← all machines'), el('span', {}, step(signal.place - 1, '← more urgent'), ' ', step(signal.place + 1, 'less urgent →'))),
    el('h1', {}, named(signal.machine.name), ' · ', named(signal.name)),
    el('p', {class: 'state'}, el('span', {class: `chip ${signal.above ? 'hot' : signal.judged ? '' : 'hatch'}`, 'data-hi': String(signal.hi), 'data-limit': String(signal.limit)}, signal.above ? 'above its limit' : signal.judged ? 'not above its limit' : 'cannot be judged'), ' ', el('span', {}, sentence(signal))),
    advice(signal), facts(signal));
  app.replaceChildren(heading(), main, foot());
  if (!known) {
    const canvas = el('canvas', {class: 'alone', role: 'img', 'aria-label': 'The course of the indicator'});
    stripInto(canvas, [signal], false, 24);
    markStrip(canvas, [signal]);
    main.append(titled('Its course', 'the indicator; grey: below its limit; colour: above'), el('div', {class: 'strip tall'}, canvas), ...alarmList(signal, titled),
      el('p', {class: 'lead'}, 'This page shows only the most urgent signals in detail, and not this one. To see it: ', el('code', {}, `gam report --signal ${shell(`${signal.machine.name}/${signal.name}`)}`)));
    return;
  }
  const time = await unpackTimes(known.time), begins = await unpackTimes(known.first), hi = await unpack(known.hi, Float64Array);
  if (!isStill()) return;
  const seen = {calibration: known.learntFrom == null ? null : [Number(known.learntFrom), Number(known.learntTo)], pauses: pausesOf(begins, time)};
  indicator(main, signal, time, hi, seen, await unpack(known.novel, Uint32Array), await unpack(known.outside, Uint32Array));
  main.append(...alarmList(signal, titled));
  if (known.envelope) {
    await readings(main, signal, known, seen);
    await pieces(main, signal, known);
  } else main.append(el('p', {class: 'lead'}, `Raw readings are not in this file: ${D.noRaw}.`));
  if (!isStill()) return;
  await drawStates(main, titled, signal, known, calm.matches);
  await certificate(main, signal, known, seen);
}

const shell = text => `'${text.replaceAll("'", "'\\''")}'`;

/** Pauses: buckets that take much longer than usual, and long stretches between two. Each: from, to, bucket after it. */
function pausesOf(begins, ends) {
  const lengths = Array.from(ends, (end, i) => end - begins[i]).sort((a, b) => a - b), least = Math.max(3 * (lengths[lengths.length >> 1] || 1), FRAME.span / 500), found = [];
  for (let i = 0; i < ends.length; i++) {
    if (i && begins[i] - ends[i - 1] > least) found.push([ends[i - 1], begins[i], i]);
    if (ends[i] - begins[i] > least) found.push([begins[i], ends[i], i]);
  }
  return found;
}

function facts(signal) {
  const fact = (value, text) => el('div', {}, el('b', {}, value), el('span', {}, text));
  return el('div', {class: 'facts'},
    fact(share(signal.hi), `indicator now: share of new states in the last ${whole.format(signal.window)} scored`),
    fact(share(signal.limit), signal.limit == null ? 'no limit: the signal cannot be judged' : `limit of the indicator: the highest value to expect of healthy data${signal.by === 'episode' ? '; this signal is judged by its episodes' : ''}`),
    fact(share(signal.floor), 'floor: what a healthy machine would show'),
    ...signal.machineFloor == null ? [] : [fact(share(signal.machineFloor), `floor by leaving one machine out; taught by ${signal.teachers}`)],
    fact(signal.sees == null ? '–' : `${signal.sees} %`, 'the smallest shift, in percent of its usual range, that the indicator would show while the machine works as in calibration'),
    fact(percent(signal.outside), 'of the new states lie outside the calibrated range'),
    fact(signal.low == null ? '–' : `${reading(signal.low)} … ${reading(signal.high)}`, 'calibrated range'),
    fact(whole.format(signal.cells), `healthy states, learnt from ${plural(signal.vectors, 'vector')}; calibration ${signal.version}`));
}

function marks(seen) {
  return made => {
    if (seen.calibration) stretch(made, ...seen.calibration, rgb(theme().calibration), 'calibration');
    for (const [from, to] of seen.pauses) stretch(made, from, to, css('--pause'), 'pause');
  };
}

function host(words) { return el('div', {class: 'chart', role: 'img', 'aria-label': words}); }

function indicator(main, signal, time, hi, seen, novel, outside) {
  const place = host(`Indicator over time, now ${share(signal.hi)}, limit ${share(signal.limit)}`);
  main.append(titled('Health indicator', '0: all states occurred in calibration; 1: none did'), place);
  const highest = hi.reduce((a, b) => b > a ? b : a, 0);
  if (!time.length || hi.every(Number.isNaN)) { place.replaceWith(el('p', {class: 'lead'}, `No indicator yet: it needs ${whole.format(signal.window)} scored readings.`)); return; }
  const top = Math.min(1, Math.max(2.2 * (signal.limit ?? 0.05), 1.12 * highest)), limit = signal.limit ?? top;
  const fill = made => {
    const {ctx} = made, bottom = made.valToPos(0, 'y', true), roof = made.valToPos(top, 'y', true);
    const gradient = ctx.createLinearGradient(0, bottom, 0, roof), at = value => Math.min(1, Math.max(0, value / top));
    gradient.addColorStop(0, rgb(theme().below)); gradient.addColorStop(at(limit), rgb(theme().near));
    if (signal.limit != null) for (const part of [0, 0.33, 0.66, 1]) gradient.addColorStop(at(limit + part * Math.max(0, 1 - limit)), rgb(heat(part)));
    return gradient;
  };
  // a pause breaks the line
  const xs = [], ys = [], broken = new Set(seen.pauses.map(pause => pause[2]));
  time.forEach((t, i) => { if (i && broken.has(i)) { xs.push((time[i - 1] + t) / 2); ys.push(null); } xs.push(t); ys.push(Number.isNaN(hi[i]) ? null : hi[i]); });
  const place_of = new Map(Array.from(time, (t, i) => [t, i]));
  const made = chart(place, {height: 220, cursor: {y: false, sync: {key: 'time'}}, scales: {x: {time: false, range: () => [FRAME.first, FRAME.last]}, y: {range: [0, top * 1.02]}},
    series: [{}, {stroke: css('--ink'), width: 1.3, fill, points: {show: time.length < 3}}], axes: [timeAxis(), numberAxis()],
    hooks: {drawAxes: [marks(seen)], draw: [it => {
      markChart(it, signal);
      across(it, signal.limit, css('--ink'), [6, 4], `limit ${share(signal.limit)}`);
      if (signal.floor != null && (signal.limit ?? 1) - signal.floor > 0.09 * top) across(it, signal.floor, css('--soft'), [2, 3], `floor ${share(signal.floor)}`, true);
      upright(it, signal.since, css('--hot'), 'onset');
    }]}}, [xs, ys]);
  place.dataset.since = String(signal.since);
  hover(place, made, at => { const i = place_of.get(xs[at]); return i === undefined ? null : `${when(time[i])}\nindicator ${share(hi[i])}${signal.limit == null ? '' : `, limit ${share(signal.limit)}`}\nnew in this bucket: ${novel[i]} of ${signal.stride}, ${outside[i]} of them out of range`; });
}

async function readings(main, signal, known, seen) {
  const place = host('The readings over time');
  main.append(titled('The signal itself', 'lowest and highest reading; dashed: the calibrated range'), place);
  const {first, length} = known.envelope, low = await unpack(known.envelope.low, Float32Array), high = await unpack(known.envelope.high, Float32Array);
  const time = Array.from(low, (_, i) => Number(first) + (i + 0.5) * length);
  const made = chart(place, {height: 160, cursor: {y: false, sync: {key: 'time'}}, scales: {x: {time: false, range: () => [FRAME.first, FRAME.last]}},
    series: [{}, {stroke: css('--signal'), width: 1, points: {show: false}}, {stroke: css('--signal'), width: 1, points: {show: false}}],
    bands: [{series: [2, 1], fill: css('--signal') + '77'}], axes: [timeAxis(), numberAxis()],
    hooks: {drawAxes: [marks(seen)], draw: [it => { across(it, signal.low, css('--ink'), [5, 4]); across(it, signal.high, css('--ink'), [5, 4]); upright(it, signal.since, css('--hot')); }]}}, [time, gaps(low), gaps(high)]);
  hover(place, made, i => Number.isNaN(low[i]) ? null : `${when(time[i])}\n${reading(low[i])} … ${reading(high[i])}`);
}

async function pieces(main, signal, known) {
  const found = [];
  for (const piece of [known.calm, known.onset]) found.push([await unpackTimes(piece.time), await unpack(piece.value, Float64Array), await unpack(piece.new, Uint8Array)]);
  let least = Infinity, most = -Infinity;
  for (const [, values] of found) for (const value of values) if (!Number.isNaN(value)) { least = Math.min(least, value); most = Math.max(most, value); }
  if (least > most) return;
  const room = (most - least) * 0.07 || 1, both = el('div', {class: 'two'});
  main.append(both);
  const titles = [['Healthy', `the last ${whole.format(found[0][0].length)} readings of calibration`], [signal.above ? 'At the onset' : 'At its highest', 'marked: readings that end in a state that calibration never visited']];
  found.forEach(([time, values, isNew], which) => {
    const place = host(titles[which].join(', '));
    both.append(el('div', {}, titled(...titles[which]), place));
    if (!time.length) { place.replaceWith(el('p', {class: 'lead'}, 'No readings.')); return; }
    place.dataset.novel = String(isNew.reduce((a, b) => a + b, 0));
    const steps = Array.from(time.subarray(1), (t, i) => t - time[i]).sort((a, b) => a - b), usual = steps[steps.length >> 1] || 1, xs = [], ys = [], dots = [];
    time.forEach((t, i) => { if (i && t - time[i - 1] > 10 * usual) { xs.push((t + time[i - 1]) / 2); ys.push(null); dots.push(null); } xs.push(t); ys.push(Number.isNaN(values[i]) ? null : values[i]); dots.push(isNew[i] ? values[i] : null); });
    chart(place, {height: 180, cursor: {show: false}, scales: {x: {time: false}, y: {range: [least - room, most + room]}},
      series: [{}, {stroke: css('--signal'), width: 1.2, points: {show: false}}, {stroke: 'transparent', points: {show: true, size: 4.5, width: 0, fill: css('--novel')}}], axes: [timeAxis(5), numberAxis()],
      hooks: {draw: [it => { across(it, signal.low, css('--ink'), [5, 4]); across(it, signal.high, css('--ink'), [5, 4]); }]}},
    [xs, ys, dots]);
  });
}

/** The floor by grid: the indicator of a healthy machine if the grid were coarser. */
function ladder(main, signal, grids) {
  const place = host('Floor by number of bins');
  main.append(titled('Would a coarser grid need less healthy data?', `the floor by bins per axis; this calibration has ${signal.bins}`), place);
  if (!grids.length) { place.replaceWith(el('p', {class: 'lead'}, signal.verdict === 'no_data' ? 'There is no calibration.' : 'This calibration has no floors by grid; calibrate again (gam calibrate) to get them.')); return; }
  place.dataset.ladder = JSON.stringify(grids);
  const floors = grids.map(one => one[1]);
  chart(place, {height: 150, cursor: {show: false}, scales: {x: {time: false, range: [-0.7, floors.length - 0.3]}, y: {range: (_, a, b) => [0, Math.max(b, signal.target) * 1.25]}},
    series: [{}, {stroke: css('--healthy'), fill: css('--healthy') + 'aa', paths: uPlot.paths.bars({size: [0.5, 60]}), points: {show: false}}],
    axes: [{splits: () => floors.map((_, i) => i), values: (_, at) => at.map(i => `${grids[i][0]} bins: ${share(floors[i])}`)}, numberAxis()],
    hooks: {draw: [it => across(it, signal.target, css('--ink'), [6, 4], `target ${share(signal.target)}`)]}}, [floors.map((_, i) => i), floors]);
}

async function certificate(main, signal, known, seen) {
  const columns = el('div', {class: 'two'});
  main.append(columns);
  const blocks = host('Blocks of calibration'), growth = host('Known states over time');
  columns.append(el('div', {}, titled('Is healthy data enough?', 'each block of calibration, judged by the others'), blocks),
    el('div', {}, titled('Does it keep finding new states?', 'states known: healthy below, new above'), growth));
  if (known.blocks.length > 1) {
    const shares = known.blocks.map(([, vectors, novel]) => novel / vectors);
    chart(blocks, {height: 190, cursor: {show: false}, scales: {x: {time: false, range: [-0.7, shares.length - 0.3]}, y: {range: (_, a, b) => [0, Math.max(b * 1.15, (signal.limit ?? 0.05) * 1.25)]}},
      series: [{}, {stroke: css('--healthy'), fill: css('--healthy') + 'aa', paths: uPlot.paths.bars({size: [0.7, 44]}), points: {show: false}}],
      axes: [{values: (_, at) => at.map(x => Number.isInteger(x) && x < shares.length ? String(known.blocks[x]?.[0] + 1) : '')}, numberAxis()],
      hooks: {draw: [it => { across(it, signal.limit, css('--ink'), [6, 4], 'limit'); across(it, signal.floor, css('--soft'), [2, 3], (signal.limit ?? 1) - (signal.floor ?? 0) > 0.01 ? 'floor' : null); }]}}, [shares.map((_, i) => i), shares]);
  } else blocks.replaceWith(el('p', {class: 'lead'}, 'Calibration has too few blocks of one window to judge a block by the others.'));
  const time = await unpackTimes(known.growth.time), healthy = await unpack(known.growth.healthy, Uint32Array), fresh = await unpack(known.growth.new, Uint32Array);
  if (time.length > 1) {
    chart(growth, {height: 190, cursor: {show: false}, scales: {x: {time: false, range: () => [FRAME.first, FRAME.last]}, y: {range: (_, a, b) => [0, b * 1.1 || 1]}},
      series: [{}, {stroke: css('--novel'), width: 1.5, fill: css('--novel') + '55', points: {show: false}}, {stroke: css('--healthy'), width: 1.5, fill: css('--healthy') + 'cc', points: {show: false}}],
      axes: [timeAxis(4), numberAxis()], hooks: {drawAxes: [marks({...seen, pauses: []})]}}, [time, Array.from(healthy, (n, i) => n + fresh[i]), healthy]);
  } else growth.replaceWith(el('p', {class: 'lead'}, 'No scores yet.'));
  main.append(el('p', {class: 'note'}, 'Wear keeps adding states; a changed program adds its states at once and then stops.'));
  ladder(main, signal, known.ladder);
}
