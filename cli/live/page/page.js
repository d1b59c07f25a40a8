// SPDX-License-Identifier: Apache-2.0
// Asks for the state and the picture four times a second, and shows the picture by a table of the display's
// bytes for each float, so that exposure and tone cost one look-up a channel.
'use strict';
const $ = id => document.getElementById(id);
const interval = 250;  // milliseconds
const least = -8, largest = 8;  // stops of false colour
const token = new URLSearchParams(location.search).get('token');

let state = null;  // as /state says it
let picture = null;  // {layer, channels, width, height, values, version}, and its image as shown
const view = {zoom: 1, x: 0, y: 0, fits: true};  // device pixels a pixel; where the picture's corner lies
let pointer = null;  // in device pixels of the canvas
let isGone = false;

// The program

function address(path, values = {}) {
  const query = new URLSearchParams(values);
  if (token) query.set('token', token);
  return query.size || token ? `${path}?${query}` : path;
}

async function ask(path, values, options = {}) {
  const response = await fetch(address(path, values), options);
  if (!response.ok) throw Object.assign(new Error(await response.text()), {isAnswer: true});
  return response;
}

async function takePicture() {
  const layer = state.layers.find(one => one.name === $('layer').value) ?? state.layers[0];
  const since = picture?.layer === layer.name ? picture.version : 0;
  const response = await ask('/picture', {layer: layer.name, since});
  if (response.status !== 200) return;
  const tiles = await response.arrayBuffer();
  if (layer.name !== $('layer').value) return;  // another one was chosen in the meantime
  const number = name => Number(response.headers.get(name));
  if (!since) picture = emptyPicture(layer, number('Picture-Width'), number('Picture-Height'));
  picture.version = number('Picture-Version');
  const changed = takeTiles(tiles);
  showPicture(since ? changed : whole());
}

function emptyPicture({name, channels}, width, height) {
  return {layer: name, channels, width, height, values: new Float32Array(width * height * channels.length),
          image: new ImageData(width, height)};
}

/// Takes the tiles over: of each its place, its size and its values. The rectangle in which they lie.
function takeTiles(buffer) {
  const channels = picture.channels.length;
  let [left, top, right, bottom] = [picture.width, picture.height, 0, 0];
  for (let at = 0; at < buffer.byteLength;) {
    const [x, y, width, height] = new Uint32Array(buffer, at, 4), size = width * channels;
    at += 16;
    for (let row = 0; row < height; ++row, at += 4 * size)
      picture.values.set(new Float32Array(buffer, at, size), ((y + row) * picture.width + x) * channels);
    [left, top] = [Math.min(left, x), Math.min(top, y)];
    [right, bottom] = [Math.max(right, x + width), Math.max(bottom, y + height)];
  }
  return {x: left, y: top, width: right - left, height: bottom - top};
}

function isComplete() {
  const layer = state?.layers.find(one => one.name === $('layer').value);
  return state?.phase === 'ended' && (!layer?.version || picture?.version === layer.version);
}

async function follow() {
  for (let failures = 0; !isComplete() && failures < 4;) {
    try {
      state = await (await ask('/state')).json();
      showLayers();
      await takePicture();
      failures = 0;
    } catch (error) {
      if (error.isAnswer) return say(error.message);
      ++failures;
    }
    showState();
    if (!isComplete()) await new Promise(done => setTimeout(done, interval));
  }
  isGone = true;
  showState();
}

async function stop() {
  $('stop').disabled = true;
  try {
    await ask('/stop', {}, {method: 'POST'});
  } catch (error) {
    say(error.message);
  }
}

// The statistics

const duration = seconds => {
  const whole = Math.round(seconds), two = n => String(n).padStart(2, '0');
  const minutes = `${Math.floor(whole / 60) % 60}`;
  return whole < 3600 ? `${minutes}:${two(whole % 60)}`
                      : `${Math.floor(whole / 3600)}:${two(minutes)}:${two(whole % 60)}`;
};

const count = n => n >= 1e9 ? `${(n / 1e9).toFixed(2)} G` : n >= 1e6 ? `${(n / 1e6).toFixed(2)} M`
                 : n >= 1e3 ? `${(n / 1e3).toFixed(1)} k` : n.toFixed(0);

function samples() {
  const {done, total} = state.samples;
  const text = done >= 100 || Number.isInteger(done) ? done.toFixed(0) : done.toFixed(1);
  return total ? `${text} of ${total}` : text;
}

function statistics() {
  const rows = [];
  if (state.phase !== 'loading') {
    rows.push(['Samples', samples()], ['Done', `${(100 * state.share).toFixed(state.share < 0.1 ? 1 : 0)} %`],
              ['Time', duration(state.seconds)]);
    if (state.phase === 'rendering' && state.seconds_left != null)
      rows.push(['Left', duration(state.seconds_left)]);
    rows.push(['Rays', `${count(state.rays_per_second)}/s`]);
    if (state.error != null)
      rows.push(['Error', `${state.error.toPrecision(3)}, target ${state.noise_target}`]);
    rows.push(['Size', `${state.width} × ${state.height}`]);
  }
  rows.push(['Zoom', `${(100 * view.zoom / devicePixelRatio).toFixed(view.zoom < 0.1 ? 1 : 0)} %`]);
  return rows;
}

function sentence() {
  if (!state) return isGone ? 'The program does not answer.' : 'Connecting…';
  if (state.phase === 'ended')
    return state.complete ? `The render has ended. Its picture goes to ${state.picture}.`
                          : `The render was stopped. What there is goes to ${state.partial}.`;
  if (isGone) return 'The program has gone. This is the last picture that it sent.';
  if (state.stopping) return 'Stopping…';
  if (state.phase === 'loading') return 'The scene is being loaded…';
  if (!picture || picture.layer !== $('layer').value) return 'This layer comes in a moment…';
  return '';
}

const fileName = () => state.picture.replace(/.*\//, '');

function say(text) {
  if ($('message').textContent !== text) $('message').textContent = text;
}

function showState() {
  say(sentence());
  if (!state) return;
  const percent = (100 * (state.phase === 'loading' ? 0 : state.share)).toFixed(1);
  $('name').textContent = fileName();
  $('name').title = state.picture;
  document.title = state.phase === 'rendering' ? `${Math.floor(percent)} % ${fileName()}` : fileName();
  $('bar').firstElementChild.style.width = `${percent}%`;
  $('bar').setAttribute('aria-valuenow', percent);
  $('bar').className = state.phase !== 'ended' ? (isGone ? 'gone' : '') : state.complete ? 'ended' : 'stopped';
  $('stop').disabled = isGone || state.phase !== 'rendering' || !state.can_stop || state.stopping;
  $('stop').title = state.can_stop ? `as Ctrl-C does: ${state.partial} gets what there is`
                                   : 'the picture goes to no file that could keep a part of it';
  $('statistics').replaceChildren(...statistics().map(([name, value]) => {
    const row = document.createElement('div');
    for (const [kind, text] of [['dt', name], ['dd', value]])
      row.appendChild(document.createElement(kind)).textContent = text;
    return row;
  }));
}

function showLayers() {
  const names = state.layers.map(one => one.name), select = $('layer');
  if (names.join() === [...select.options].map(one => one.value).join()) return;
  select.replaceChildren(...names.map(name => new Option(name, name)));
  select.disabled = names.length < 2;
}

// The display's bytes

/// The tone that shows something of a layer.
function usualTone(layer) {
  if (layer.endsWith('normal')) return 'signed';
  const measures = ['depth', 'position', 'uv', 'ids', 'samples', 'variance', 'alpha'];
  return measures.includes(layer) ? 'range' : 'color';
}

const byte = x => Math.max(0, Math.min(255, Math.round(255 * x)));
const srgb = x => x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;

/// Even steps from black over blue, green and yellow to white.
const keys = [[0, 0, 0], [35, 20, 90], [30, 70, 170], [10, 140, 160], [50, 180, 80], [190, 200, 40],
              [250, 160, 40], [240, 80, 60], [255, 255, 255]];
function scaleColor(t) {
  const at = Math.max(0, Math.min(1, t)) * (keys.length - 1), i = Math.min(Math.floor(at), keys.length - 2);
  return keys[i].map((from, c) => Math.round(from + (keys[i + 1][c] - from) * (at - i)));
}

/// `show` of each float, by its first 17 bits: sign, exponent and eight bits of the mantissa.
function tableOf(show) {
  const bits = new Uint32Array(1), value = new Float32Array(bits.buffer), table = new Uint8Array(1 << 17);
  for (let i = 0; i < table.length; ++i) {
    bits[0] = i << 15 | 1 << 14;
    table[i] = Number.isFinite(value[0]) ? show(value[0]) : 0;
  }
  return table;
}

function limits(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values)
    if (Number.isFinite(value)) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  return low < high ? [low, high] : [low, low + 1];
}

const stops = () => Number($('exposure').value);

/// What a value becomes by the tone that is chosen: a byte, of false colour a place on the scale.
function toneCurve() {
  const scale = 2 ** stops(), tone = $('tone').value;
  if (tone === 'signed') return x => byte(0.5 + 0.5 * x);
  if (tone === 'false-color')
    return x => byte((Math.log2(Math.max(x * scale, 1e-30)) - least) / (largest - least));
  if (tone === 'color') return x => byte(srgb(x * scale));
  const [low, high] = limits(picture.values);
  return x => byte((x - low) / (high - low));
}

const shown = document.createElement('canvas');  // the picture, a pixel each

const whole = () => ({x: 0, y: 0, width: picture.width, height: picture.height});

/// Calls `give(i, j)` for each pixel of a part of the picture: where its values and its bytes begin.
function forEachPixel({x, y, width, height}, give) {
  for (let row = y; row < y + height; ++row)
    for (let place = row * picture.width + x, end = place + width; place < end; ++place)
      give(place * picture.channels.length, place * 4);
}

/// Shows what changed; the scale from the least to the largest value goes by all.
function showPicture(part = whole()) {
  const {values, image} = picture, channels = picture.channels.length;
  const to = image.data, table = tableOf(toneCurve()), bits = new Uint32Array(values.buffer);
  if ($('tone').value === 'range') part = whole();
  if ($('tone').value === 'false-color') {
    const colors = Array.from({length: 256}, (_, i) => scaleColor(i / 255)).flat();
    const luminance = new Float32Array(1), of = new Uint32Array(luminance.buffer);
    forEachPixel(part, (i, j) => {
      luminance[0] = channels < 3 ? values[i]
                                  : 0.2126 * values[i] + 0.7152 * values[i + 1] + 0.0722 * values[i + 2];
      const place = 3 * table[of[0] >>> 15];
      for (let c = 0; c < 3; ++c) to[j + c] = colors[place + c];
      to[j + 3] = 255;
    });
  } else {
    forEachPixel(part, (i, j) => {
      for (let c = 0; c < 3; ++c)
        to[j + c] = channels === 1 ? table[bits[i] >>> 15] : c < channels ? table[bits[i + c] >>> 15] : 0;
      to[j + 3] = 255;
    });
  }
  if (shown.width !== picture.width || shown.height !== picture.height)
    [shown.width, shown.height] = [picture.width, picture.height];
  shown.getContext('2d').putImageData(image, 0, 0, part.x, part.y, part.width, part.height);
  $('save').disabled = false;
  showLegend();
  draw();
}

function showLegend() {
  const legend = $('legend'), strip = legend.firstElementChild, tone = $('tone').value;
  legend.hidden = tone === 'color' || tone === 'signed';
  $('exposure').disabled = tone === 'signed' || tone === 'range';
  const context = strip.getContext('2d');
  for (let x = 0; x < strip.width; ++x) {
    const t = x / (strip.width - 1), grey = byte(t);
    context.fillStyle = `rgb(${tone === 'false-color' ? scaleColor(t) : [grey, grey, grey]})`;
    context.fillRect(x, 0, 1, 1);
  }
  const [low, high] = tone === 'range' && picture ? limits(picture.values) : [0, 1];
  const ticks = [0, 0.25, 0.5, 0.75, 1].map(t => tone === 'range' ? low + t * (high - low)
                                                : 2 ** (least + t * (largest - least) - stops()));
  legend.lastElementChild.replaceChildren(...ticks.map(tick => {
    const span = document.createElement('span');
    span.textContent = Number(tick.toPrecision(3));
    return span;
  }));
}

// The view

const canvas = $('view');

function fit() {
  if (!picture) return;
  view.zoom = Math.min(canvas.width / picture.width, canvas.height / picture.height);
  if (view.zoom > 1) view.zoom = Math.max(1, Math.min(view.zoom, 8));
  center();
  view.fits = true;
}

function center() {
  view.x = (canvas.width - picture.width * view.zoom) / 2;
  view.y = (canvas.height - picture.height * view.zoom) / 2;
}

/// Changes the zoom, and leaves what lies at a place where it is.
function zoomTo(zoom, x = canvas.width / 2, y = canvas.height / 2) {
  const next = Math.max(0.02, Math.min(256, zoom)), ratio = next / view.zoom;
  Object.assign(view, {zoom: next, x: x - (x - view.x) * ratio, y: y - (y - view.y) * ratio, fits: false});
  draw();
}

function pixelAt(place) {
  if (!place || !picture) return null;
  const x = Math.floor((place.x - view.x) / view.zoom), y = Math.floor((place.y - view.y) / view.zoom);
  return x >= 0 && y >= 0 && x < picture.width && y < picture.height ? {x, y} : null;
}

function draw() {
  if (view.fits) fit();
  const context = canvas.getContext('2d');
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  if (picture) {
    const {zoom, x, y} = view;
    Object.assign(context, {imageSmoothingEnabled: zoom < 1, imageSmoothingQuality: 'high'});
    context.drawImage(shown, x, y, zoom * picture.width, zoom * picture.height);
    const at = pixelAt(pointer);
    if (at && zoom >= 8) {
      context.strokeStyle = '#fff';
      context.strokeRect(x + at.x * zoom + 0.5, y + at.y * zoom + 0.5, zoom - 1, zoom - 1);
    }
  }
  showPixel();
}

const shortNumber = x => Math.abs(x) >= 1e6 || (x !== 0 && Math.abs(x) < 1e-4) ? x.toExponential(3)
                       : Number(x.toPrecision(5)).toString();

function showPixel() {
  const at = pixelAt(pointer), [swatch, text] = $('pixel').children;
  if (!at) {
    text.textContent = picture ? 'Point at a pixel: wheel zooms, drag moves' : '';
    swatch.hidden = true;
    return;
  }
  const channels = picture.channels, place = at.y * picture.width + at.x;
  const value = c => picture.values[place * channels.length + c];
  const values = channels.map((name, c) => `${name} ${shortNumber(value(c))}`);
  text.textContent = [`x ${at.x}  y ${at.y}`, ...values].join('   ');
  swatch.hidden = false;
  swatch.style.background = `rgb(${picture.image.data.slice(4 * place, 4 * place + 3).join()})`;
}

const placeOf = event => {
  const box = canvas.getBoundingClientRect();
  return {x: (event.clientX - box.left) * devicePixelRatio, y: (event.clientY - box.top) * devicePixelRatio};
};

canvas.addEventListener('pointermove', event => {
  const before = pointer;
  pointer = placeOf(event);
  if (before && canvas.classList.contains('dragged'))
    Object.assign(view, {x: view.x + pointer.x - before.x, y: view.y + pointer.y - before.y, fits: false});
  draw();
});
canvas.addEventListener('pointerdown', event => {
  canvas.setPointerCapture(event.pointerId);
  canvas.classList.add('dragged');
  pointer = placeOf(event);
});
for (const end of ['pointerup', 'pointercancel'])
  canvas.addEventListener(end, () => canvas.classList.remove('dragged'));
canvas.addEventListener('pointerleave', () => {
  pointer = null;
  draw();
});
canvas.addEventListener('wheel', event => {
  event.preventDefault();
  const lines = event.deltaMode === 1 ? 30 : 1, {x, y} = placeOf(event);
  zoomTo(view.zoom * 2 ** (-event.deltaY * lines / 250), x, y);
  showState();
}, {passive: false});

const actions = {
  f() { view.fits = true; },
  1() { if (picture) { view.zoom = devicePixelRatio; center(); view.fits = false; } },
  '+'() { zoomTo(2 * view.zoom); },
  '-'() { zoomTo(view.zoom / 2); },
  '['() { expose(stops() - 0.5); },
  ']'() { expose(stops() + 0.5); },
};
function act(key) {
  actions[key]?.();
  draw();
  showState();
}
document.addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === 'SELECT') return;
  act(event.key.toLowerCase());
});
canvas.addEventListener('dblclick', () => act('f'));
$('fit').addEventListener('click', () => act('f'));
$('one').addEventListener('click', () => act('1'));

function expose(value) {
  $('exposure').value = value;
  $('stops').textContent = (stops() > 0 ? '+' : '') + stops().toFixed(1);
  if (picture) showPicture();
}
$('exposure').addEventListener('input', () => expose(stops()));
$('exposure').addEventListener('dblclick', () => expose(0));
$('tone').addEventListener('change', () => { if (picture) showPicture(); });
$('layer').addEventListener('change', () => {
  $('tone').value = usualTone($('layer').value);
  showState();
});
$('stop').addEventListener('click', stop);

/// The layer as a PFM file: rows from the bottom, one channel or three.
$('save').addEventListener('click', () => {
  const {width, height, values, channels, layer} = picture;
  const count = channels.length, planes = count === 1 ? 1 : 3;
  const rows = new Float32Array(width * height * planes);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      for (let c = 0; c < count; ++c)
        rows[((height - 1 - y) * width + x) * planes + c] = values[(y * width + x) * count + c];
  const link = document.createElement('a');
  const head = `${planes === 1 ? 'Pf' : 'PF'}\n${width} ${height}\n-1.0\n`;
  link.href = URL.createObjectURL(new Blob([head, rows]));
  link.download = `${fileName().replace(/\.[^.]*$/, '')}-${layer}.pfm`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
});

new ResizeObserver(() => {
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio));
  draw();
  showState();
}).observe(canvas);
showState();
follow();
