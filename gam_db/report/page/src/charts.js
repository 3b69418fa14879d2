// Charts over time and numbers, by uPlot: its axes, and the marks that they share.
import uPlot from 'uplot';
import {css, showTip} from './dom.js';
import {reading, ticks, when} from './words.js';

export const gaps = values => Array.from(values, value => Number.isNaN(value) ? null : value);
const dots = () => devicePixelRatio;
const font = () => `12px ${css('--font')}`;
const alive = new Set();
export function clearCharts() { for (const [chart, watch] of alive) { watch.disconnect(); chart.destroy(); } alive.clear(); }

// Paper is narrower than a window, and nothing is told of the new widths while it is printed. A4 less its margins:
const PAPER = 688;
const resize = width => { for (const [made] of alive) made.setSize({width: width(made.root.parentNode.clientWidth), height: made.height}); };
addEventListener('beforeprint', () => { const app = document.getElementById('app').clientWidth; resize(wide => Math.min(wide, Math.floor(PAPER * wide / app))); });
addEventListener('afterprint', () => resize(wide => wide));

/** A chart that is as wide as its place. */
export function chart(place, options, data) {
  const axis = {stroke: css('--soft'), font: font(), grid: {stroke: css('--line'), width: 0.6}, ticks: {show: false}, size: 44};
  const made = new uPlot({width: Math.max(200, place.clientWidth), legend: {show: false}, ...options, axes: options.axes.map((one, i) => ({...axis, ...(i ? {} : {size: 26}), ...one}))}, data, place);
  const watch = new ResizeObserver(() => { if (place.clientWidth > 50 && Math.abs(place.clientWidth - made.width) > 2) made.setSize({width: place.clientWidth, height: options.height}); });
  watch.observe(place);
  alive.add([made, watch]);
  return made;
}

/** An axis of time in the plant's time zone. */
export const timeAxis = many => ({
  splits: (made, _, from, to) => ticks(from, to, Math.max(2, Math.min(many || 8, Math.floor(made.width / 110)))),
  values: (made, marks) => marks.map(time => when(time, made.scales.x.max - made.scales.x.min)),
});
export const numberAxis = () => ({values: (_, marks) => marks.map(mark => reading(mark)), size: 52});

/** A line across at a height, with words at its right end. */
export function across(made, height, colour, dash, text, below) {
  if (height == null) return;
  const {ctx, bbox} = made, y = made.valToPos(height, 'y', true);
  if (y < bbox.top - 1 || y > bbox.top + bbox.height + 1) return;
  ctx.save();
  ctx.strokeStyle = colour; ctx.lineWidth = 1.2 * dots(); ctx.setLineDash(dash.map(n => n * dots()));
  ctx.beginPath(); ctx.moveTo(bbox.left, y); ctx.lineTo(bbox.left + bbox.width, y); ctx.stroke();
  if (text) {
    ctx.font = `${12 * dots()}px ${css('--font')}`; ctx.textAlign = 'right'; ctx.textBaseline = below ? 'top' : 'bottom';
    const wide = ctx.measureText(text).width, left = bbox.left + bbox.width - 6 * dots();
    ctx.globalAlpha = 0.8; ctx.fillStyle = css('--bg');
    ctx.fillRect(left - wide - 3 * dots(), below ? y + 2 * dots() : y - 17 * dots(), wide + 6 * dots(), 15 * dots());
    ctx.globalAlpha = 1; ctx.fillStyle = colour;
    ctx.fillText(text, left, below ? y + 4 * dots() : y - 3 * dots());
  }
  ctx.restore();
}

/** A stretch of time in a colour, with a word in it if there is room. */
export function stretch(made, from, to, colour, text) {
  if (from == null || to == null) return;
  const {ctx, bbox} = made, clip = x => Math.min(bbox.left + bbox.width, Math.max(bbox.left, x));
  const left = clip(made.valToPos(from, 'x', true)), right = clip(made.valToPos(to, 'x', true));
  ctx.save();
  ctx.fillStyle = colour; ctx.fillRect(left, bbox.top, right - left, bbox.height);
  if (text) {
    ctx.font = `${12 * dots()}px ${css('--font')}`;
    if (ctx.measureText(text).width + 12 * dots() < right - left) { ctx.fillStyle = css('--soft'); ctx.textBaseline = 'top'; ctx.textAlign = 'left'; ctx.fillText(text, left + 6 * dots(), bbox.top + 5 * dots()); }
  }
  ctx.restore();
}

/** A line upwards at an instant. */
export function upright(made, at, colour, text) {
  if (at == null) return;
  const {ctx, bbox} = made, x = made.valToPos(at, 'x', true);
  if (x < bbox.left || x > bbox.left + bbox.width) return;
  ctx.save();
  ctx.strokeStyle = colour; ctx.lineWidth = 1.5 * dots();
  ctx.beginPath(); ctx.moveTo(x, bbox.top); ctx.lineTo(x, bbox.top + bbox.height); ctx.stroke();
  if (text) {
    ctx.font = `${12 * dots()}px ${css('--font')}`; ctx.textBaseline = 'top'; ctx.fillStyle = colour;
    const right = x + ctx.measureText(text).width + 10 * dots() > bbox.left + bbox.width;
    ctx.textAlign = right ? 'right' : 'left';
    ctx.fillText(text, x + (right ? -5 : 5) * dots(), bbox.top + 5 * dots());
  }
  ctx.restore();
}

export function hover(place, made, words) {
  place.addEventListener('mousemove', event => { const at = made.cursor.idx; showTip(event, at == null ? null : words(at)); });
  place.addEventListener('mouseleave', () => showTip(null));
}
export {uPlot};
