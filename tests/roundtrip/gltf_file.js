// A reader of glTF that shares no code with the program: what stands in a file, with bytes in place of where they lie.
'use strict';

const crypto = require('crypto');
const fs = require('fs');
const path = require('path');

/// Reads a .glb or .gltf. Returns {json, buffers: [Buffer]}.
function readGltf(file) {
  const bytes = fs.readFileSync(file);
  const folder = path.dirname(file);
  let json;
  let binary = null;
  if (bytes.toString('latin1', 0, 4) === 'glTF') {
    const end = 20 + bytes.readUInt32LE(12);
    json = JSON.parse(bytes.toString('utf8', 20, end));
    if (bytes.length > end) binary = bytes.subarray(end + 8, end + 8 + bytes.readUInt32LE(end));
    if (bytes.readUInt32LE(8) !== bytes.length) throw new Error(`${file}: the length in its head is not its own`);
  } else {
    json = JSON.parse(bytes.toString('utf8'));
  }
  const buffers = (json.buffers || []).map((buffer) => {
    if (buffer.uri !== undefined) return bytesAt(buffer.uri, folder);
    return binary || Buffer.alloc(0); // of a stream that is compressed elsewhere
  });
  return { json, buffers, folder, file };
}

function bytesAt(uri, folder) {
  if (!uri.startsWith('data:')) {
    const named = path.join(folder, uri.replace(/\\/g, '/'));
    return fs.readFileSync(fs.existsSync(named) ? named : path.join(folder, decodeURIComponent(uri).replace(/\\/g, '/')));
  }
  const [head, data] = [uri.slice(0, uri.indexOf(',')), uri.slice(uri.indexOf(',') + 1)];
  return head.endsWith(';base64') ? Buffer.from(data, 'base64') : Buffer.from(decodeURIComponent(data), 'latin1');
}

const hashOf = (bytes) => `${bytes.length} bytes ${crypto.createHash('sha256').update(bytes).digest('hex')}`;

function bytesOfView(gltf, view) {
  const buffer = gltf.buffers[view.buffer];
  const start = view.byteOffset || 0;
  if (start + view.byteLength > buffer.length) throw new Error(`${gltf.file}: a buffer view goes beyond its buffer`);
  return buffer.subarray(start, start + view.byteLength);
}

/// The document with hashes of bytes in place of buffers, offsets and addresses, so that it is the same wherever bytes lie. Own
/// extras of the program are left out.
function contentOf(gltf) {
  const json = structuredClone(gltf.json);
  const placed = (view) => {
    const { buffer, byteOffset, byteLength, ...rest } = view;
    return { bytes: hashOf(bytesOfView(gltf, view)), ...rest };
  };
  json.bufferViews = (json.bufferViews || []).map((view) => {
    const packed = Object.entries(view.extensions || {}).filter(([, extension]) => extension.buffer !== undefined);
    if (packed.length === 0) return placed(view);
    const extensions = { ...view.extensions, ...Object.fromEntries(packed.map(([name, extension]) => [name, placed(extension)])) };
    const { buffer, byteOffset, ...rest } = view; // its own bytes are where the stream is unpacked to
    return { ...rest, extensions };
  });
  json.images = (json.images || []).map((image) => {
    const { uri, bufferView, mimeType, ...rest } = image;
    if (uri === undefined && bufferView === undefined) return image;
    return { bytes: hashOf(uri === undefined ? bytesOfView(gltf, gltf.json.bufferViews[bufferView]) : bytesAt(uri, gltf.folder)), ...rest };
  });
  delete json.buffers;
  for (const holder of [json, ...(json.nodes || []), ...(json.animations || [])]) {
    if (!holder.extras || holder.extras.penpose === undefined) continue;
    delete holder.extras.penpose;
    if (Object.keys(holder.extras).length === 0) delete holder.extras;
  }
  return json;
}

/// What differs: [{path, was, now}]; was or now is undefined where there is nothing. Lists that go on are one entry each.
function differences(was, now, at = '') {
  const lists = Array.isArray(was) && Array.isArray(now);
  const objects = was !== null && now !== null && typeof was === 'object' && typeof now === 'object' && Array.isArray(was) === Array.isArray(now);
  if (!lists && !objects) return Object.is(was, now) ? [] : [{ path: at, was, now }];
  const keys = [...new Set([...Object.keys(was), ...Object.keys(now)])];
  return keys.flatMap((key) => differences(was[key], now[key], `${at}/${key}`));
}

const k_readers = { 5120: ['readInt8', 1, 127], 5121: ['readUInt8', 1, 255], 5122: ['readInt16LE', 2, 32767], 5123: ['readUInt16LE', 2, 65535],
                    5125: ['readUInt32LE', 4, 1], 5126: ['readFloatLE', 4, 1] };
const k_widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

/// The numbers of an accessor that is not compressed, flat.
function numbersOf(gltf, index) {
  const accessor = gltf.json.accessors[index];
  const width = k_widths[accessor.type];
  const read = (view, offset, type, count, columns, scaled) => {
    const [name, size, most] = k_readers[type];
    const bytes = bytesOfView(gltf, gltf.json.bufferViews[view]);
    const stride = gltf.json.bufferViews[view].byteStride || size * columns;
    return Array.from({ length: count * columns }, (_, i) => {
      const x = bytes[name]((offset || 0) + Math.floor(i / columns) * stride + (i % columns) * size);
      return scaled ? Math.max(x / most, -1) : x;
    });
  };
  const numbers = accessor.bufferView === undefined ? new Array(accessor.count * width).fill(0)
    : read(accessor.bufferView, accessor.byteOffset, accessor.componentType, accessor.count, width, accessor.normalized);
  if (!accessor.sparse) return numbers;
  const { count, indices, values } = accessor.sparse;
  const at = read(indices.bufferView, indices.byteOffset, indices.componentType, count, 1, false);
  const with_ = read(values.bufferView, values.byteOffset, accessor.componentType, count, width, accessor.normalized);
  at.forEach((v, i) => numbers.splice(v * width, width, ...with_.slice(i * width, (i + 1) * width)));
  return numbers;
}

module.exports = { readGltf, contentOf, differences, numbersOf };
