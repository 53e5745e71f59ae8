// Samples and what the program makes of them: posed, with a control drawn on the mesh, and animated.
'use strict';

const { execFileSync } = require('child_process');
const fs = require('fs');
const path = require('path');
const { face, faceBeside, quantized } = require('./samples/face.js');
const { avatar0, avatar1, motion } = require('./samples/avatars.js');

/// A program that writes to `folder`. Returns what it printed; fails with the line that it gave.
function run(program, ...args) {
  try {
    return execFileSync(program, args, { stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 28 }).toString();
  } catch (error) {
    throw new Error(`${args.join(' ')}: ${(error.stderr || '').toString().trim() || error.message}`);
  }
}

/// Places of the vertices of an .obj, as [x, y, z].
function verticesOf(file) {
  return fs.readFileSync(file, 'utf8').split('\n').filter((line) => line.startsWith('v ')).map((line) => line.slice(2).split(' ').slice(0, 3).map(Number));
}

/// The samples in `folder`: [{name, file, set, draw}]. `set`: controls to pose; `draw`: middle, size and direction of what a
/// control is drawn on.
function makeSamples(folder) {
  const write = (name, bytes) => {
    const file = path.join(folder, name);
    fs.mkdirSync(path.dirname(file), { recursive: true });
    fs.writeFileSync(file, bytes);
    return file;
  };
  for (const [name, bytes] of Object.entries(faceBeside())) write(name, bytes);
  write('motion.vrma', motion().glb());
  const onFace = { middle: [0, 0, 0.2], size: 2, looks: 1 };
  const onHead = (looks) => ({ middle: [0, 1.6, 0.1 * looks], size: 0.24, looks });
  const spoken = { jawOpen: 0.6, mouthSmileLeft: 0.35 };
  return [
    { name: 'face', file: write('face.glb', face().glb()), set: spoken, draw: onFace },
    { name: 'beside', file: path.join(folder, 'beside.gltf'), set: spoken, draw: onFace, text: true },
    { name: 'quantized', file: write('quantized.glb', quantized().glb()), set: { jawOpen: 0.5 }, draw: { ...onFace, middle: [0, 0, 0.1], size: 1 } },
    { name: 'avatar0', file: write('avatar0.glb', avatar0().glb()), set: { ...spoken, '骨 leftUpperArm.rz': 0.4 }, draw: onHead(-1), avatar: true },
    { name: 'avatar1', file: write('avatar1.glb', avatar1().glb()), set: { ...spoken, '骨 leftUpperArm.rz': -0.4 }, draw: onHead(1), avatar: true },
  ];
}

/// Models that are there already: the .glb files of a folder, or the real ones of the shared data: [{name, file}]. An "out.glb" beside
/// one of them was written by the program, and so were real ones with two endings.
function foundModels(root) {
  const found = [];
  const add = (folder, prefix) => {
    for (const name of fs.readdirSync(folder).sort()) {
      if (/^[^.]+\.(glb|gltf)$/.test(name) && name !== 'out.glb') found.push({ name: prefix + path.parse(name).name, file: path.join(folder, name) });
    }
  };
  const meshes = path.join(root, 'meshes');
  add(fs.existsSync(meshes) ? meshes : root, '');
  const rigs = path.join(root, 'cases', 'rigs');
  for (const rig of fs.existsSync(rigs) ? fs.readdirSync(rigs).sort() : []) {
    if (fs.statSync(path.join(rigs, rig)).isDirectory()) add(path.join(rigs, rig), `${rig}.`);
  }
  return found;
}

/// A case that asks for a pose by the vertices that each of its controls moves most: `alone` has where they are with each
/// control by itself, `posed` with all of them. Null: none moves anything.
function caseOf(rest, alone, posed, free) {
  const references = [];
  for (const positions of alone) {
    const reach = rest.map((p, v) => Math.hypot(...p.map((x, axis) => positions[v][axis] - x)));
    const most = Math.max(...reach);
    if (!(most > 0)) continue;
    const seen = new Set();
    const vertices = [...reach.keys()].filter((v) => reach[v] > 0.3 * most).sort((a, b) => reach[b] - reach[a] || a - b)
      .filter((v) => !seen.has(String(rest[v])) && seen.add(String(rest[v]))).slice(0, 40)
      .sort((a, b) => rest[a][0] - rest[b][0] || rest[a][1] - rest[b][1]);
    if (vertices.length >= 2) references.push({ vertices, target: vertices.map((v) => posed[v]) });
  }
  return references.length > 0 ? { cases: [{ name: 'asked', free, references }] } : null;
}

/// A control that lifts the middle of what is drawn on, seen from its front: two lassos, and a line with where it goes.
function sketchOf({ middle, size, looks }) {
  const px = (x, y) => [500 + 500 * x, 500 - 500 * y]; // in sizes: the view is two of them wide
  const circle = (rx, ry, cy) => Array.from({ length: 48 }, (_, i) => px(rx * Math.cos(i * Math.PI / 24), cy + ry * Math.sin(i * Math.PI / 24)));
  const line = (y) => Array.from({ length: 33 }, (_, i) => px(0.18 * (i / 16 - 1), y - 0.03 * (i / 16 - 1) ** 2));
  const eye = [middle[0], middle[1], middle[2] + looks * size / Math.tan(Math.PI / 18)];
  return { model: '', viewport: [1000, 1000],
           deformers: [{ name: 'lifted', camera: { eye, look_at: middle, up: [0, 1, 0], vertical_fov_degrees: 20 },
                         general: circle(0.3, 0.22, 0), specific: circle(0.2, 0.06, 0), reference: line(0), target: line(0.08) }] };
}

/// Where a control may be drawn on a model that nobody knows: the middle of its largest part, or the head of a figure. Null: it has
/// too few vertices to draw on.
function drawOf(info, rest) {
  const part = info.parts.reduce((a, b) => (b.vertices > a.vertices ? b : a));
  const points = rest.slice(part.first_vertex, part.first_vertex + part.vertices);
  if (points.length < 60) return null;
  const looks = Math.abs(info.front_yaw_degrees) > 90 ? -1 : 1;
  const bound = (pick, axis, of = points) => of.reduce((a, p) => pick(a, p[axis]), of[0][axis]);
  const [low, high] = [Math.min, Math.max].map((pick) => [0, 1].map((axis) => bound(pick, axis)));
  const tall = high[1] - low[1];
  const figure = info.joints > 15 || tall > 3 * (high[0] - low[0]);
  const size = figure ? 0.16 * tall : Math.max(tall, high[0] - low[0]);
  const middle = [(low[0] + high[0]) / 2, figure ? high[1] - 0.55 * size : (low[1] + high[1]) / 2];
  const near = points.filter((p) => Math.hypot(p[0] - middle[0], p[1] - middle[1]) < 0.3 * size);
  return { middle: [...middle, looks * bound(Math.max, 0, near.map((p) => [looks * p[2]]))], size, looks };
}

/// A track of Live Link Face: three frames in which the controls go up, and down a part.
function trackOf(names) {
  const rows = [[0, 0], [1, 0.5], [2, 0.125]].map(([second, value]) =>
    [`00:00:0${second}:00.000`, names.length, ...names.map((_, i) => (value / (i + 1)).toFixed(4))].join(','));
  return `Timecode,BlendShapeCount,${names.join(',')}\n${rows.join('\n')}\n`;
}

const isTurn = (control) => /\.r[xyz]$/.test(control);

/// Runs the program on a model. Returns [{kind, file, from, values or control or names, places}, ...]: what was written, from
/// which file if not the model's, what was asked, and an .obj of where the program has its vertices.
function makeOutputs(penpose, model, folder) {
  const at = (name) => path.join(folder, `${model.name}.${name}`);
  const info = JSON.parse(run(penpose, 'info', model.file, '--json'));
  const outputs = [];
  const ends = model.text ? ['glb', 'gltf'] : [model.avatar ? 'vrm' : 'glb'];
  const place = (kind, end) => { // a .gltf has files beside it
    const into = end === 'gltf' ? path.join(folder, `${model.name}.${kind}`) : folder;
    fs.mkdirSync(into, { recursive: true });
    return path.join(into, `${model.name}.${kind}.${end}`);
  };
  const atRest = model.avatar === true; // its nodes stay in T-pose, so that other programs take it for the same avatar
  const placesOf = (file) => { // of its vertices, as the program has them with the joints as they are in the file
    const turns = Object.keys(model.set || {}).filter((name) => atRest && isTurn(name));
    run(penpose, 'convert', file, ...turns.flatMap((name) => ['--set', `${name}=0`]), `${file}.obj`);
    return `${file}.obj`;
  };
  const posedIn = (file, values) => { // what the program itself reads of a pose that it wrote
    const { parameters } = JSON.parse(run(penpose, 'info', file, '--json'));
    return Object.entries(values).filter(([name, value]) => Math.abs(parameters.find((p) => p.name === name).value - value) > 1e-6).map(([name]) => name);
  };
  run(penpose, 'convert', model.file, at('rest.obj'));
  const set = model.set || setOf(info);
  const posed = (name, values) => {
    run(penpose, 'convert', model.file, ...Object.entries(values).flatMap(([control, value]) => ['--set', `${control}=${value}`]), at(name));
    return verticesOf(at(name));
  };
  const controls = Object.keys(set);
  const asked = controls.length === 0 ? null
    : caseOf(verticesOf(at('rest.obj')), controls.map((name) => posed('alone.obj', { [name]: set[name] })), posed('set.obj', set), controls);
  if (asked) fs.writeFileSync(at('cases.json'), JSON.stringify(asked));
  for (const end of asked ? ends : []) {
    const file = place('posed', end);
    const told = JSON.parse(run(penpose, 'pose', model.file, '--cases', at('cases.json'), '--free', 'case', '--json', '-o', file));
    const rest = Object.fromEntries(info.parameters.map((p) => [p.name, p.value]));
    const values = Object.fromEntries(Object.entries(told.cases[0].parameters).filter(([name, value]) => value !== rest[name]));
    outputs.push({ kind: 'posed', file, values, atRest, unread: posedIn(file, values), places: placesOf(file) });
  }
  const draw = model.draw || drawOf(info, verticesOf(at('rest.obj')));
  if (draw) {
    fs.writeFileSync(at('sketch.json'), JSON.stringify(sketchOf(draw)));
    for (const end of ends) {
      const file = place('drawn', end);
      run(penpose, 'articulate', model.file, '--sketch', at('sketch.json'), '-o', file);
      outputs.push({ kind: 'drawn', file, control: 'lifted' });
      const used = place('used', end);
      run(penpose, 'convert', file, '--set', 'lifted=1', used);
      outputs.push({ kind: 'posed', file: used, from: file, values: { lifted: 1 }, unread: posedIn(used, { lifted: 1 }), places: placesOf(used) });
    }
  }
  const names = info.parameters.slice(0, info.blend_shapes).map((p) => p.name).filter((name) => !/[,"~]/.test(name)).slice(0, 2);
  if (names.length > 0) {
    fs.writeFileSync(at('take.csv'), trackOf(names));
    for (const end of ends) {
      const file = place('moved', end);
      run(penpose, 'animate', model.file, '--track', at('take.csv'), '-o', file);
      outputs.push({ kind: 'moved', file, names });
    }
  }
  return outputs;
}

/// Controls to pose on a model that nobody knows: the first shapes, and a turn of a joint.
function setOf(info) {
  const set = {};
  const weights = info.parameters.slice(0, info.blend_shapes);
  const turns = info.parameters.slice(info.blend_shapes).filter((p) => isTurn(p.name) && p.name.endsWith('z'));
  for (const p of weights.slice(0, 2)) set[p.name] = p.minimum + 0.6 * (p.maximum - p.minimum);
  if (turns.length > 0) set[turns[Math.floor(turns.length / 2)].name] = 0.3;
  return set;
}

module.exports = { run, verticesOf, makeSamples, foundModels, makeOutputs };
