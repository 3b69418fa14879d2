// The states in three dimensions, by three.js.
import {AmbientLight, BoxGeometry, Color, DirectionalLight, EdgesGeometry, Group, InstancedMesh, LineBasicMaterial, LineSegments, Matrix4, MeshLambertMaterial, PerspectiveCamera, Scene, Vector3, WebGLRenderer} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {heat, isDark, rgb} from './colour.js';
import {reading} from './words.js';
import {css, el} from './dom.js';

let held = null;
/** Let go of the picture that was there: browsers allow only a few. */
export function clearBoxes() { if (held) { held.controls.dispose(); held.renderer.dispose(); held.renderer.forceContextLoss(); held = null; } }

const MODES = [['both', 0.9, true, true], ['healthy faint', 0.13, true, true], ['new only', 0, false, true], ['healthy only', 0.9, true, false]];

export function drawBoxes(place, healthy, fresh, signal, ago, isStill) {
  clearBoxes();
  const test = document.createElement('canvas');
  let renderer = null;
  if (test.getContext('webgl2')) try { renderer = new WebGLRenderer({antialias: true, alpha: true, preserveDrawingBuffer: true}); } catch { renderer = null; }
  if (!renderer) { place.classList.add('without'); place.append(el('p', {class: 'note'}, 'This browser cannot draw in three dimensions (WebGL is off): the flat pictures show the same states.')); return; }
  const wide = place.clientWidth, high = place.clientHeight, codes = signal.bins + 3, mid = codes / 2;
  renderer.setPixelRatio(Math.min(2, devicePixelRatio)); renderer.setSize(wide, high);
  renderer.domElement.setAttribute('aria-hidden', 'true');
  place.append(renderer.domElement);
  const scene = new Scene(), camera = new PerspectiveCamera(30, wide / high, 0.1, 100), group = new Group();
  const sun = new DirectionalLight(0xffffff, 2);
  sun.position.set(2, 4, 3);
  scene.add(group, new AmbientLight(0xffffff, 1.6), sun);
  const boxes = (found, colour, top, options = {}) => {
    const count = found.visits.length, mesh = new InstancedMesh(new BoxGeometry(0.84, 0.84, 0.84), new MeshLambertMaterial(options), count), where = new Matrix4();
    for (let n = 0; n < count; n++) { const size = 0.45 + 0.55 * Math.log1p(found.visits[n]) / top; where.makeScale(size, size, size).setPosition(found.axes[0][n] - mid + 0.5, found.axes[2][n] - mid + 0.5, -(found.axes[1][n] - mid + 0.5)); mesh.setMatrixAt(n, where); mesh.setColorAt(n, colour(found.visits[n])); }
    group.add(mesh);
    return mesh;
  };
  const most = found => Math.log1p(found.visits.reduce((a, b) => Math.max(a, b), 1));
  const top = [most(healthy), most(fresh)], pale = new Color(isDark() ? '#41525c' : '#b4c3cc'), deep = new Color(css('--healthy'));
  const calm = boxes(healthy, n => pale.clone().lerp(deep, Math.log1p(n) / top[0]), top[0], {transparent: true, opacity: 0.9});
  const left = boxes(fresh, n => new Color(rgb(heat(0.25 + 0.75 * Math.log1p(n) / top[1]))), top[1]);
  const frame = new LineSegments(new EdgesGeometry(new BoxGeometry(signal.bins, signal.bins, signal.bins)), new LineBasicMaterial({color: css('--soft'), transparent: true, opacity: 0.6}));
  frame.position.set(2 + signal.bins / 2 - mid, 2 + signal.bins / 2 - mid, -(2 + signal.bins / 2 - mid));
  group.add(frame);
  group.scale.setScalar(2 / codes);
  camera.position.set(2.7, 1.75, 4.3).multiplyScalar(wide < 500 ? 1.25 : 1.05); camera.lookAt(0, 0, 0);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.enablePan = false; controls.enableZoom = false; controls.enableDamping = false;
  const edge = signal.bins / codes;
  const labels = [[[0, -edge - 0.1, edge + 0.1], signal.low == null ? 'now' : `now: ${reading(signal.low)} … ${reading(signal.high)}`], [[edge + 0.14, -edge - 0.1, 0], ago(1)], [[-edge - 0.12, 0, edge + 0.1], ago(2)]]
    .map(([at, text]) => { const label = el('div', {class: 'label'}, text); place.append(label); return [new Vector3(...at), label]; });
  const draw = () => {
    renderer.render(scene, camera);
    for (const [at, label] of labels) {
      const seen = at.clone().project(camera), half = label.offsetWidth / 2 + 4;
      label.style.left = `${Math.min(wide - half, Math.max(half, (seen.x + 1) / 2 * wide))}px`;
      label.style.top = `${Math.min(high - 12, Math.max(48, (1 - seen.y) / 2 * high))}px`;
    }
  };
  controls.addEventListener('change', draw);
  const bar = el('div', {class: 'modes', role: 'group', 'aria-label': 'Show'}, MODES.map(([name, opacity, showsCalm, showsLeft], i) => el('button', {'aria-pressed': String(i === 0), onclick: event => {
    calm.material.opacity = opacity; calm.material.depthWrite = opacity > 0.5; calm.visible = showsCalm; left.visible = showsLeft;
    for (const button of bar.children) button.setAttribute('aria-pressed', String(button === event.currentTarget));
    draw();
  }}, name)));
  place.append(bar);
  held = {renderer, controls};
  draw();
  place.dataset.drawn = '1';
}
