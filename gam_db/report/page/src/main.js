// Which page is shown: the fleet, or the signal that the address names.
import {D, signals} from './data.js';
import {loadStrips, onTheme} from './colour.js';
import {drawFleet} from './fleet.js';
import {drawSignal} from './signal.js';
import {clearCharts} from './charts.js';
import {clearBoxes} from './boxes.js';
import {el, showTip} from './dom.js';

const app = document.getElementById('app');
let turn = 0, cameFrom = null;

function named(hash) {
  const parts = hash.replace(/^#\/?/, '').split('/');
  if (parts.length !== 2) return null;
  try {
    const [machine, signal] = parts.map(decodeURIComponent);
    return signals.find(one => one.machine.name === machine && one.name === signal) || null;
  } catch { return null; }
}

async function show() {
  const mine = ++turn, signal = named(location.hash);
  showTip(null); clearCharts(); clearBoxes();
  document.documentElement.dataset.ready = '';
  if (signal) {
    scrollTo(0, 0);
    cameFrom = signal;
    await drawSignal(app, signal, () => mine === turn);
  } else {
    drawFleet(app, show);
    if (cameFrom) { const row = [...document.querySelectorAll('.row.signal')].find(one => one.hash === `#/${encodeURIComponent(cameFrom.machine.name)}/${encodeURIComponent(cameFrom.name)}`); if (row) row.focus(); }
  }
  if (mine === turn) { document.documentElement.dataset.ready = signal ? 'signal' : 'fleet'; document.documentElement.dataset.drawn = String(Math.round(performance.now())); }
}

document.querySelector('.skip').addEventListener('click', event => { event.preventDefault(); document.getElementById('main').focus(); });

if (typeof DecompressionStream === 'undefined') {
  app.replaceChildren(el('main', {id: 'main'}, el('h1', {}, 'This browser is too old for this page.'), el('p', {}, 'It takes a browser of 2023 or later (Chrome or Edge 80, Firefox 113, Safari 16.4); gam status prints the same figures as text.')));
} else {
  addEventListener('hashchange', show);
  loadStrips().then(() => { onTheme(show); return show(); });
}
