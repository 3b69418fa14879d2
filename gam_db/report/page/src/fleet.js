// The page of the fleet: a sentence, counts that filter, the heat map, and the list.
import {D, FRAME, STATES, counts, machines, signals} from './data.js';
import {brief, percent, plural, share, shortly, ticks, unjudged, when, whole} from './words.js';
import {CALIBRATION, PAUSE, column, drawStrip, heat, rgb, stripInto, theme, byteOf, AT_LIMIT} from './colour.js';
import {el, linkOf, named, showTip} from './dom.js';
import {list as alarmList, markStrip} from './alarms.js';

/** The filters of the list; they stay while the user looks at signals. */
export const chosen = {state: null, text: '', byWorst: false, open: new Set(), scroll: 0};

const lately = D.counter ? 'in the last windows' : 'in the last day, or three windows';

const headOf = (text, more) => el('div', {class: 'head'}, el('h2', {}, text), el('span', {class: 'note'}, more));

/** The line above both pages. */
export function heading() {
  return el('header', {class: 'top'}, el('div', {class: 'title'}, named(D.title)),
    el('div', {class: 'meta'}, `${plural(machines.length, 'machine')} · ${D.watched == null ? '' : `${whole.format(D.watched)} of `}${plural(signals.length, 'signal')}${D.watched == null ? '' : ' watched'} · data until ${when(FRAME.last)}${D.counter ? '' : ` ${D.zone}`}`));
}

export function foot() {
  const made = new Date(D.made / 1000).toISOString().slice(0, 16).replace('T', ' ');
  return el('footer', {class: 'note'}, `gam-db ${D.version}, monitor `, named(D.monitor), `, page made ${made} UTC.`,
    D.validity ? ` ${percent(D.validity.invalid / D.validity.held)} of the ${plural(D.validity.held, 'reading')} of the newest run do not meet valid_when and count as missing samples.` : '',
    D.noRaw ? ` Raw readings are not in this file: ${D.noRaw}.` : '');
}

function sentence() {
  const hot = machines.filter(machine => machine.above).length;
  if (!hot) return el('h1', {}, counts.unjudged === signals.length ? 'No signal can be judged yet.' : D.watched === 0 ? 'No signal is watched now: see the data problems.' : 'Every signal that can be judged behaves as in calibration.');
  return el('h1', {}, el('em', {}, `${whole.format(hot)} of ${plural(machines.length, 'machine')}`), ` ${hot === 1 ? 'is in states that it' : 'are in states that they'} never visited while healthy`,
    counts.fresh ? `; ${plural(counts.fresh, 'signal')} went above ${counts.fresh === 1 ? 'its' : 'their'} limit ${lately}.` : `; no signal went above its limit ${lately}.`);
}

const TILES = [
  ['fresh', `new ${lately}`], ['above', 'above their limit'], ['rising', 'rising, or no episode yet'],
  ['calm', 'as in calibration'], ['unjudged', 'cannot be judged'], ['silent', 'silent'],
];

/** Most data problems of a list; gam status --all has the rest. */
const LISTED = 20;

/** The section of data problems, apart from the states of machines. */
function lacking() {
  const {sentence, advice, kind} = D.problems, many = sentence.length;
  if (!many) return [];
  return [el('section', {class: 'problems', 'aria-label': 'Data problems'}, headOf('Data problems', `${plural(many, 'problem')} with the data, not with a machine${many > LISTED ? `; the first ${LISTED} are shown` : ''}`),
    el('ul', {}, sentence.slice(0, LISTED).map((text, place) => el('li', {'data-kind': kind[place]}, el('b', {}, el('bdi', {}, text), '.'), ` ${advice[place]}`))))];
}

/** Why signals cannot be judged, each reason once. */
function reasons() {
  const found = new Map();
  for (const signal of signals) if (!signal.judged) { const said = unjudged(signal)[0]; found.set(said, (found.get(said) || 0) + 1); }
  return [...found].sort((a, b) => b[1] - a[1]).map(([said, n]) => `${whole.format(n)}: ${said}`).join('; ');
}

export function drawFleet(app, again) {
  document.title = D.title || 'Fleet health';
  const tile = ([name, text]) => el('button', {class: `tile ${name} ${counts[name] ? '' : 'none'}`, 'data-count': name, 'aria-pressed': String(chosen.state === name),
    onclick: () => { chosen.state = chosen.state === name ? null : name; chosen.scroll = 0; press(); build(); }}, el('b', {}, whole.format(counts[name])), el('span', {}, text));
  const tiles = el('div', {class: 'tiles', role: 'group', 'aria-label': 'Show only'}, TILES.map(tile));
  const press = () => tiles.querySelectorAll('button').forEach(button => button.setAttribute('aria-pressed', String(button.dataset.count === chosen.state)));
  const lead = el('p', {class: 'lead'}, 'A new state is not necessarily damage: a new program or a warm-up also brings new states.',
    counts.unjudged ? ` ${plural(counts.unjudged, 'signal')} cannot be judged and never alarm${counts.unjudged === 1 ? 's' : ''} (${reasons()}).` : '');
  const [section, build, jump] = list();
  const map = heatMap(machine => { chosen.open.add(machine.number); chosen.state = null; chosen.text = ''; press(); build(); jump(machine); }, again);
  app.replaceChildren(heading(), el('main', {id: 'main', tabindex: '-1'}, sentence(), lead, tiles, lacking(), map, section, alarmList(null, headOf)), foot());
  build();
}

function heatMap(pick, again) {
  const many = machines.length, high = Math.max(many > 200 ? 1 : 2, Math.min(24, Math.floor(460 / many)));
  const canvas = el('canvas', {class: 'heat', role: 'img', 'aria-label': 'Heat map: a row for each machine, time from left to right. The list below has the same content in words.', style: {height: `${many * high}px`}});
  canvas.width = D.columns; canvas.height = many * high;
  const context = canvas.getContext('2d'), image = context.createImageData(D.columns, many * high), [r, g, b] = theme().ground;
  for (let i = 0; i < image.data.length; i += 4) { image.data[i] = r; image.data[i + 1] = g; image.data[i + 2] = b; image.data[i + 3] = 255; }
  machines.forEach((machine, row) => drawStrip(image, machine.signals, chosen.byWorst, row * high, high > 6 ? high - 2 : high));
  context.putImageData(image, 0, 0);
  const names = el('div', {class: 'names', 'aria-hidden': 'true', style: {height: `${many * high}px`}});
  if (high >= 14) machines.forEach((machine, row) => names.append(el('div', {style: {top: `${row * high}px`, height: `${high - 2}px`, lineHeight: `${high - 2}px`}, title: machine.name}, named(machine.name))));
  else names.append(el('div', {class: 'many'}, `${whole.format(many)} machines, the most urgent first`));
  const at = event => {
    const box = canvas.getBoundingClientRect();
    return [machines[Math.min(many - 1, Math.max(0, Math.floor((event.clientY - box.top) / high)))], Math.min(D.columns - 1, Math.max(0, Math.floor((event.clientX - box.left) / box.width * D.columns)))];
  };
  canvas.addEventListener('mousemove', event => { const [machine, x] = at(event); showTip(event, told(machine, x)); });
  canvas.addEventListener('mouseleave', () => showTip(null));
  canvas.addEventListener('click', event => pick(at(event)[0]));
  const choice = (text, byWorst) => el('button', {'aria-pressed': String(chosen.byWorst === byWorst), onclick: () => { chosen.byWorst = byWorst; again(); }}, text);
  return el('section', {'aria-label': 'The fleet over time'},
    el('div', {class: 'head'}, el('h2', {}, 'The fleet over time'), el('span', {class: 'note'}, 'a row is a machine, the most urgent first; click a row to see its signals'),
      el('span', {class: 'seg', role: 'group', 'aria-label': 'Colour'}, choice('how many signals are above', false), choice('how far the worst is above', true))),
    el('div', {class: 'glance'}, names, canvas, el('div'), axis()), legend());
}

function told(machine, x) {
  const found = column(machine.signals, x);
  const time = when(FRAME.first + (x + 0.5) * FRAME.span / D.columns);
  let said = found.other === CALIBRATION ? 'calibration: the healthy states were learnt here' : found.other === PAUSE ? 'a pause: no readings' : 'no data';
  if (found.judged) {
    const worst = machine.signals.filter(signal => signal.limit != null && byteOf(signal, x) === found.worst)[0];
    said = `${found.above} of ${found.judged} judged signals above their limit` + (found.above && worst ? `\nfurthest: ${worst.name}` : '');
  } else if (found.unjudged) said = 'data, but no signal can be judged';
  return `${machine.name}\n${time}\n${said}`;
}

function axis() {
  const marks = ticks(FRAME.first, FRAME.last, innerWidth < 600 ? 3 : 7);
  return el('div', {class: 'axis', 'aria-hidden': 'true'}, marks.map(time => {
    const place = (time - FRAME.first) / FRAME.span;
    return place > 0.97 || place < 0.02 ? null : el('span', {style: {left: `${100 * place}%`}}, when(time, FRAME.span));
  }));
}

function legend() {
  const its = theme(), sample = (style, text, more) => el('span', {}, el('i', {style, class: more || ''}), text);
  const ramp = `linear-gradient(90deg,${[0, 0.33, 0.66, 1].map(part => rgb(heat(part))).join()})`;
  return el('div', {class: 'legend'}, sample({background: rgb(its.calibration)}, 'calibration'), sample({background: `linear-gradient(90deg,${rgb(its.below)},${rgb(its.near)})`}, 'below the limit'),
    sample({background: ramp}, chosen.byWorst ? 'from the limit to all states new' : 'one … all signals above', 'ramp'), sample({}, 'cannot be judged', 'hatch'), sample({background: rgb(its.pause)}, 'pause', 'edge'), sample({background: rgb(its.ground)}, 'no data', 'edge'));
}

const PRINTED = 500;

/** The signals of a machine that the list shows at first: all that are above, else the first that rise. */
function shownOf(members) {
  const above = members.filter(signal => signal.above);
  return above.length ? above : members.filter(signal => signal.rising).slice(0, 3);
}

function list() {
  const narrow = innerWidth < 700, HIGH = {machine: narrow ? 62 : 34, signal: narrow ? 58 : 28}, SEEN = narrow ? 560 : 620, BEYOND = 150;
  const box = el('div', {class: 'scroll', id: 'list', role: 'group', 'aria-label': 'Machines and signals'}), inner = el('div', {class: 'inner'});
  box.append(inner);
  const found = el('span', {class: 'note', role: 'status'});
  const input = el('input', {type: 'search', placeholder: 'Find a machine or a signal', 'aria-label': 'Find a machine or a signal', value: chosen.text,
    oninput: event => { chosen.text = event.target.value; chosen.scroll = 0; build(); }});
  let rows = [], tops = [0], isPrinted = false;
  const alive = new Map();

  function build() {
    const wanted = chosen.text.trim().toLowerCase(), holds = chosen.state ? STATES[chosen.state] : () => true;
    let shown = 0;
    rows = [];
    for (const machine of machines) {
      const isNamed = !wanted || machine.name.toLowerCase().includes(wanted);
      const members = machine.signals.filter(signal => holds(signal) && (isNamed || signal.name.toLowerCase().includes(wanted)));
      if (!members.length) continue;
      shown += members.length;
      rows.push({machine});
      if (chosen.open.has(machine.number) || chosen.state || wanted) for (const signal of members) rows.push({machine, signal});
      else if (machines.length <= 12) for (const signal of shownOf(members)) rows.push({machine, signal});
    }
    tops = [0];
    for (const row of rows) tops.push(tops[tops.length - 1] + HIGH[row.signal ? 'signal' : 'machine']);
    const high = tops[rows.length];
    inner.style.height = `${high}px`;
    box.style.height = `${Math.min(SEEN, high + 2)}px`;
    found.textContent = rows.length ? plural(shown, 'signal') : 'nothing is called like that';
    inner.replaceChildren(); alive.clear();
    box.scrollTop = chosen.scroll;
    draw();
  }
  function first(y) {   // the row that holds a height
    let low = 0, high = rows.length;
    while (low < high) { const mid = (low + high) >> 1; tops[mid + 1] <= y ? low = mid + 1 : high = mid; }
    return low;
  }
  function draw() {
    const from = isPrinted ? 0 : first(box.scrollTop - BEYOND), to = Math.min(rows.length, isPrinted ? PRINTED : first(box.scrollTop + SEEN + BEYOND) + 1);
    for (const [place, made] of alive) if ((place < from || place >= to) && made !== document.activeElement) { made.remove(); alive.delete(place); }
    for (let place = from; place < to; place++) if (!alive.has(place)) add(place);
  }
  function add(place) {
    const made = rowOf(rows[place], place);
    made.style.top = `${tops[place]}px`; made.style.height = `${HIGH[rows[place].signal ? 'signal' : 'machine']}px`;
    const after = [...alive.keys()].filter(other => other > place).sort((a, b) => a - b)[0];
    inner.insertBefore(made, after === undefined ? null : alive.get(after));
    alive.set(place, made);
  }
  function focusOn(place) {
    if (place < 0 || place >= rows.length) return;
    if (tops[place] < box.scrollTop) box.scrollTop = tops[place];
    if (tops[place + 1] > box.scrollTop + box.clientHeight) box.scrollTop = tops[place + 1] - box.clientHeight;
    draw();
    if (!alive.has(place)) add(place);
    alive.get(place).focus({preventScroll: true});
  }
  function toggle(machine, place) {
    chosen.open.has(machine.number) ? chosen.open.delete(machine.number) : chosen.open.add(machine.number);
    chosen.scroll = box.scrollTop;
    build();
    focusOn(place);
  }
  function rowOf({machine, signal}, place) {
    const canvas = el('canvas', {'aria-hidden': 'true'});
    stripInto(canvas, signal ? [signal] : machine.signals, false, 16);
    markStrip(canvas, signal ? [signal] : machine.signals);
    const strip = el('span', {class: 'strip'}, canvas);
    if (!signal) {
      const parts = machine.signals.length;
      return el('button', {class: 'row machine', 'data-place': place, 'aria-expanded': String(rows[place + 1] !== undefined && rows[place + 1].signal !== undefined), onclick: () => toggle(machine, place)},
        el('span', {class: 'name'}, named(machine.name)), strip,
        el('span', {class: 'bar'}, el('span', {class: 'value'}, `${machine.above} of ${machine.watched}`), gauge(machine.watched ? machine.above / machine.watched : 0, null, machine.above > 0)),
        el('span', {class: 'words'}, machine.fresh ? el('span', {class: 'badge'}, `${machine.fresh} new`) : null,
          machine.above ? el('b', {}, `since ${shortly(machine.since)}: `, named(machine.first)) : machine.judged ? 'none above its limit' : 'cannot be judged yet',
          machine.above > 1 && machine.strongest !== machine.first ? ['; ', named(machine.strongest)] : '', machine.strength == null ? '' : ` ${machine.strength.toFixed(1)} × limit`,
          machine.together > 1 ? `; ${machine.together} together` : machine.notWatched && machine.judged ? `; ${machine.notWatched} not watched` : '',
          machine.silent ? `; ${machine.silent === parts ? '' : `${machine.silent} `}silent` : ''));
    }
    return el('a', {class: 'row signal', 'data-place': place, href: linkOf(signal)},
      el('span', {class: 'name'}, named(signal.name)), strip,
      el('span', {class: 'bar'}, el('span', {class: 'value'}, share(signal.hi)), signal.judged ? gauge(signal.hi, signal.limit, signal.above) : el('span', {class: 'gauge hatch'})),
      el('span', {class: 'words'}, signal.fresh ? el('span', {class: 'badge'}, 'new') : null, signal.above ? el('b', {}, brief(signal)) : brief(signal)));
  }
  box.addEventListener('scroll', () => { chosen.scroll = box.scrollTop; draw(); });
  box.addEventListener('keydown', event => {
    const step = {ArrowDown: 1, ArrowUp: -1}[event.key], place = Number(document.activeElement.dataset.place);
    if (!step || Number.isNaN(place)) return;
    event.preventDefault();
    focusOn(place + step);
  });
  // paper does not scroll: it gets all rows that are asked for, as far as paper is of use
  window.onbeforeprint = () => { isPrinted = true; draw(); };
  window.onafterprint = () => { isPrinted = false; draw(); };
  const jump = machine => {
    const place = rows.findIndex(row => row.machine === machine && !row.signal);
    box.scrollTop = tops[place]; draw();
    box.scrollIntoView({block: 'nearest'});
    focusOn(place);
  };
  const section = el('section', {'aria-label': 'Machines and signals'},
    el('div', {class: 'head'}, el('h2', {}, 'Machines and signals'), el('span', {class: 'note'}, 'the bar is the indicator now, its mark the limit')),
    el('div', {class: 'tools'}, input, found), box);
  return [section, build, jump];
}

function gauge(part, limit, hot) {
  return el('span', {class: 'gauge', 'aria-hidden': 'true'}, el('u', {class: hot ? 'hot' : '', style: {width: `${100 * part}%`}}), limit == null ? null : el('s', {style: {left: `${100 * limit}%`}}));
}
