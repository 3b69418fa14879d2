// Elements are made here, and names come in as text only: nothing of the data can become markup.

/** An element with attributes, listeners (onclick), styles and children (text or elements). */
export function el(tag, given = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(given)) {
    if (value == null) continue;
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else if (name === 'style') Object.assign(made.style, value);
    else made.setAttribute(name, value);
  }
  for (const child of children.flat()) if (child != null) made.append(child);
  return made;
}

/** A name from the data, apart from the direction of the text around it. */
export const named = name => el('bdi', {}, name === '' ? '(no name)' : name);

/** The address of a signal's page within this one. */
export const linkOf = signal => `#/${encodeURIComponent(signal.machine.name)}/${encodeURIComponent(signal.name)}`;

export const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const tip = el('div', {class: 'tip', 'aria-hidden': 'true'});
document.body.append(tip);

/** Text beside the pointer; none hides it. */
export function showTip(event, text) {
  tip.style.display = text ? 'block' : 'none';
  if (!text) return;
  tip.textContent = text;
  tip.style.left = Math.max(4, Math.min(innerWidth - tip.offsetWidth - 8, event.clientX + 14)) + 'px';
  tip.style.top = (event.clientY + tip.offsetHeight + 30 > innerHeight ? event.clientY - tip.offsetHeight - 10 : event.clientY + 16) + 'px';
}
