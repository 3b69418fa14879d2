// The data of the page: columns become rows here, and packed columns become arrays of numbers.
export const D = JSON.parse(document.getElementById('data').textContent);

/** Bytes of a packed column, as an array of a type. */
export async function unpack(text, Type) {
  const bytes = Uint8Array.from(atob(text), sign => sign.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Type(await new Response(stream).arrayBuffer());
}

/** Times of a packed column: steps add up, exactly below 2^53. */
export async function unpackTimes(text) {
  const times = await unpack(text, Float64Array);
  for (let i = 1; i < times.length; i++) times[i] += times[i - 1];
  return times;
}

const first = Number(D.first), last = Number(D.last);
export const FRAME = {first, last, span: last - first};

/** A machine, most urgent first: name, signals (rows), watched, judged, above, notJudged, notWatched, since, first, strongest, strength, together, at. */
export const machines = D.machines.asset.map((name, number) => ({
  number, name, signals: [], judged: D.machines.judged[number], above: D.machines.above[number],
  notJudged: D.machines.notJudged[number], since: D.machines.since[number], together: D.machines.together[number],
  watched: D.machines.watched[number], notWatched: D.machines.notWatched[number], first: D.machines.first[number],
  strongest: D.machines.strongest[number], strength: D.machines.strength[number],
}));

/** A signal, most urgent first. */
export const signals = D.machine.map((number, place) => {
  const signal = {place, machine: machines[number], alarms: []};
  for (const [name, column] of Object.entries(D.signals)) signal[name] = column[place];
  signal.judged = signal.isAbove != null;
  signal.above = signal.isAbove === 1;
  signal.labelled = signal.status === 'labelled';   // its episode is a false alarm or a new program
  signal.over = signal.isAbove === 0 && signal.hi > signal.limit && !signal.labelled;   // no episode is open so far
  machines[number].signals.push(signal);
  return signal;
});
for (const machine of machines) {
  machine.fresh = machine.signals.filter(signal => signal.fresh).length;
  machine.silent = machine.signals.filter(signal => signal.silent != null).length;
}

/** An episode, open ones first, then the newest: id, status, label, note, proving, since, last, evidence, height. */
export const alarms = D.alarms.id.map((_, number) => {
  const one = {};
  for (const [name, column] of Object.entries(D.alarms)) one[name] = column[number];
  one.since = Number(one.since); one.last = Number(one.last); one.signal = signals[one.signal];
  one.signal.alarms.push(one);
  return one;
});

/** What a count stands for, and which signals it holds. */
export const STATES = {
  fresh: signal => signal.fresh === 1,
  above: signal => signal.above,
  rising: signal => signal.rising === 1 || signal.over,
  calm: signal => signal.isAbove === 0 && signal.rising === 0 && !signal.over,
  unjudged: signal => !signal.judged,
  silent: signal => signal.silent != null,
};
export const counts = Object.fromEntries(Object.entries(STATES).map(([name, holds]) => [name, signals.filter(holds).length]));
