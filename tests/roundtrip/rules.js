// What an output may have that its input has not, by what the program was asked for. All else is a fault.
'use strict';

const fs = require('fs');
const path = require('path');
const { readGltf, contentOf, differences, numbersOf } = require('./gltf_file.js');

/// Names of the targets of a mesh, where the file has them.
function namesOf(mesh) {
  const holder = [mesh, ...mesh.primitives].find((one) => one.extras && Array.isArray(one.extras.targetNames));
  const count = Math.max(0, ...mesh.primitives.map((p) => (p.targets || []).length));
  return holder ? holder.extras.targetNames : Array.from({ length: count }, (_, i) => `target${i}`);
}

const near = (a, b) => typeof a === 'number' && Math.abs(a - b) < 1e-6;

/// What a pose may change: weights of the controls that it set, to their values, and turns of the nodes of its joints.
/// Each of them must have changed something, and be read back by the program.
function posedRule(was, { values, atRest, unread }) {
  const joints = new Set(Object.keys(atRest ? {} : values).filter((name) => /\.r[xyz]$/.test(name)).map((name) => name.slice(0, -3)));
  const weights = Object.keys(values).filter((name) => !/\.r[xyz]$/.test(name));
  const found = new Set();
  const turned = new Set();
  const weight = (mesh, column, is, old) => {
    const name = namesOf(was.meshes[mesh])[column];
    const control = weights.find((one) => one === name || one.endsWith(`.${name}`));
    if (control !== undefined && near(is, values[control])) return !!found.add(control);
    if (name.includes('~')) return weights.includes(name.slice(0, name.indexOf('~'))); // what a control needs more than one target for
    return is === 0 && old === undefined && control === undefined;
  };
  return {
    allows: ({ path: at, was: old, now }) => {
      const [, list, index, member, column] = at.split('/');
      if (list === 'meshes' && member === 'weights' && column !== undefined) return weight(index, column, now, old);
      if (list === 'meshes' && member === 'weights') return now.every((w, i) => weight(index, i, w));
      if (list !== 'nodes') return false;
      if (member === 'weights' && column !== undefined) return weight(was.nodes[index].mesh, column, now, old);
      if (member === 'weights') return now.every((w, i) => weight(was.nodes[index].mesh, i, w));
      const turns = ['rotation', 'matrix'].includes(member) ||
        (['translation', 'scale'].includes(member) && was.nodes[index].matrix !== undefined);
      return turns && joints.size > 0 && !!turned.add(index);
    },
    lacks: () => [...weights.filter((name) => !found.has(name)), ...unread,
                  ...(turned.size === joints.size ? [] : [`${joints.size} joints are to turn and ${turned.size} nodes do`])],
  };
}

/// What a control on the mesh may change: targets behind those of the file, their names and weights, and columns of keys.
function drawnRule(before, after, control) {
  const { json: was } = before;
  const { json: now } = after;
  const grew = new Set();
  return {
    allows: ({ path: at, was: old, now: is }) => {
      const parts = at.split('/').slice(1);
      const appended = old === undefined && is !== undefined;
      if (/^\/(accessors|bufferViews)\/\d+$/.test(at)) return appended;
      const mesh = parts[0] === 'meshes' ? was.meshes[parts[1]] : null;
      if (mesh && /^\/meshes\/\d+\/primitives\/\d+\/targets(\/\d+)?$/.test(at)) return appended && !!grew.add(parts[1]);
      if (mesh && /\/targetNames(\/\d+)?$/.test(at)) return appended && (Array.isArray(is) ? is.slice(namesOf(mesh).length) : [is]).every((n) => n.startsWith(control));
      if (mesh && /^\/meshes\/\d+\/extras$/.test(at)) return appended && Object.keys(is).every((key) => key === 'targetNames');
      if (/^\/(meshes|nodes)\/\d+\/weights(\/\d+)?$/.test(at)) return appended && [is].flat().every((w) => w === 0);
      const sampler = at.match(/^\/animations\/(\d+)\/samplers\/(\d+)\/output$/);
      return sampler !== null && widened(before, after, old, is);
    },
    lacks: () => {
      const lacking = [];
      if (grew.size === 0) lacking.push('no mesh got a target');
      for (const mesh of grew) {
        now.meshes[mesh].primitives.forEach((primitive, p) => {
          const old = (was.meshes[mesh].primitives[p].targets || []).length;
          for (const target of primitive.targets.slice(old)) {
            for (const name of ['NORMAL', 'TANGENT']) {
              if (primitive.attributes[name] !== undefined && (primitive.mode ?? 4) >= 4 && target[name] === undefined) lacking.push(`a target has no ${name}`);
            }
          }
        });
        if (!namesOf(now.meshes[mesh]).includes(control)) lacking.push(`no target is called "${control}"`);
        const reach = now.meshes[mesh].primitives.some((primitive) => {
          const target = primitive.targets[namesOf(now.meshes[mesh]).indexOf(control)];
          return target && target.POSITION !== undefined && numbersOf(after, target.POSITION).some((x) => x !== 0);
        });
        if (!reach) lacking.push('the control moves nothing');
      }
      return lacking;
    },
  };
}

/// Whether keys have the old columns, and zeros in the new ones.
function widened(before, after, old, is) {
  const count = (json, index) => json.accessors[index].count;
  const times = before.json.animations.flatMap((a) => a.samplers).find((s) => s.output === old).input;
  const keys = count(before.json, times);
  const [narrow, wide] = [count(before.json, old) / keys, count(after.json, is) / keys];
  const a = numbersOf(before, old);
  const b = numbersOf(after, is);
  return wide > narrow && b.every((x, i) => (i % wide < narrow ? x === a[Math.floor(i / wide) * narrow + (i % wide)] : x === 0));
}

/// What an animation more may change. The file stands at its first frame, where all that is driven is at nothing.
function movedRule(before, after, names) {
  const fresh = [];
  return {
    allows: ({ path: at, was: old, now: is }) => {
      const weight = at.match(/^\/(meshes|nodes)\/(\d+)\/weights\/(\d+)$/);
      if (weight) {
        const mesh = weight[1] === 'meshes' ? weight[2] : before.json.nodes[weight[2]].mesh;
        const name = namesOf(before.json.meshes[mesh])[weight[3]];
        return is === 0 && names.some((n) => n === name || n.endsWith(`.${name}`) || name.startsWith(`${n}~`));
      }
      if (old !== undefined) return false;
      if (at === '/animations') fresh.push(...is);
      if (/^\/animations\/\d+$/.test(at)) fresh.push(is);
      return /^\/(accessors|bufferViews|animations)(\/\d+)?$/.test(at);
    },
    lacks: () => {
      const driven = new Set(fresh.flatMap((a) => a.channels).filter((c) => c.target.path === 'weights').flatMap((channel) => {
        const animation = fresh.find((a) => a.channels.includes(channel));
        const columns = namesOf(after.json.meshes[after.json.nodes[channel.target.node].mesh]);
        const keys = numbersOf(after, animation.samplers[channel.sampler].output);
        return columns.filter((_, c) => keys.some((x, i) => i % columns.length === c && x !== 0));
      }));
      return [...(fresh.length === 1 ? [] : [`${fresh.length} animations more`]),
              ...names.filter((n) => ![...driven].some((d) => n === d || n.endsWith(`.${d}`)))];
    },
  };
}

/// Checks one output. Returns lines of what is wrong.
function faultsOf(model, output) {
  const before = readGltf(output.from || model.file);
  const after = readGltf(output.file);
  const rules = { posed: () => posedRule(before.json, output), drawn: () => drawnRule(before, after, output.control),
                  moved: () => movedRule(before, after, output.names) };
  const rule = rules[output.kind]();
  const content = [contentOf(before), contentOf(after)];
  const outer = new Set((before.json.images || []).map((image, i) => (image.uri === undefined ? null : content[0].images[i].bytes)));
  const packed = ({ path: at, was, now }) => was === undefined && /^\/bufferViews\/\d+$/.test(at) && outer.has(now.bytes);
  const faults = differences(...content).filter((one) => !packed(one) && !rule.allows(one))
    .map(({ path: at, was, now }) => `${at}: ${(JSON.stringify(was) || 'nothing').slice(0, 90)} became ${(JSON.stringify(now) || 'nothing').slice(0, 90)}`);
  faults.push(...rule.lacks().map((what) => `what was asked for is not there: ${what}`));
  const embedded = before.json.buffers && before.json.buffers.length === 1 && before.json.buffers[0].uri === undefined;
  if (embedded && !after.buffers[0].subarray(0, before.buffers[0].length).equals(before.buffers[0])) faults.push('/buffers/0: its bytes are not those of the input');
  const whole = /\.(glb|vrm)$/.test(output.file);
  const apart = (after.json.buffers || []).slice(1).filter((b) => !(b.extensions && Object.values(b.extensions).some((e) => e.fallback)));
  if (whole && apart.length > 0) faults.push('/buffers: a .glb file that is not whole');
  if (whole && (after.json.images || []).some((image) => image.uri !== undefined && !image.uri.startsWith('data:'))) faults.push('/images: a .glb file that is not whole');
  if (output.file.endsWith('.gltf')) faults.push(...besideFaults(before, path.dirname(output.file)));
  return faults;
}

/// Files beside a .gltf are there again, as they were.
function besideFaults(before, folder_) {
  const uris = [...before.json.buffers, ...(before.json.images || [])].map((one) => one.uri).filter((uri) => uri && !uri.startsWith('data:'));
  return uris.map((uri) => decodeURIComponent(uri)).filter((name) => {
    const there = path.join(folder_, name);
    return !fs.existsSync(there) || !fs.readFileSync(there).equals(fs.readFileSync(path.join(before.folder, name)));
  }).map((name) => `${name} is not beside it as it was`);
}

module.exports = { faultsOf };
