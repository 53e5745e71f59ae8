// Makes glTF files without any code of the program: accessors, pictures, and the container.
'use strict';

const zlib = require('zlib');

/// A JPEG of 16 x 16 px, a slope from green to red.
const k_jpeg = Buffer.from(
  '/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAA0JCgsKCA0LCgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZGNywtQFdBRkxOUlNSMj5aYVpQYEpRUk//' +
  '2wBDAQ4ODhMREyYVFSZPNS01T09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT0//wAARCAAQABADASIAAhEBAxEB/8QA' +
  'FgABAQEAAAAAAAAAAAAAAAAABQIG/8QAGBAAAgMAAAAAAAAAAAAAAAAAAAMEITH/xAAVAQEBAAAAAAAAAAAAAAAAAAACBP/EABgRAAIDAAAAAAAAAAAA' +
  'AAAAAAAEAwUx/9oADAMBAAIRAxEAPwCkS8sSRLyzIIl5YkiXlksqw69TD//Z', 'base64');

function crc(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return (sum ^ 0xffffffff) >>> 0;
}

/// A PNG of `side` x `side` px; `colour(u, v)` gives [r, g, b, a], 0 to 255, of the middle of a px.
function png(side, colour) {
  const rows = Buffer.alloc(side * (1 + 4 * side));
  for (let y = 0; y < side; ++y) {
    for (let x = 0; x < side; ++x) rows.set(colour((x + 0.5) / side, (y + 0.5) / side).map(Math.round), y * (1 + 4 * side) + 1 + 4 * x);
  }
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type), data]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc(body), 4);
    return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(side, 0);
  head.writeUInt32BE(side, 4);
  head.set([8, 6], 8);
  return Buffer.concat([Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]), chunk('IHDR', head),
                        chunk('IDAT', zlib.deflateSync(rows)), chunk('IEND', Buffer.alloc(0))]);
}

const k_types = { 5121: [Uint8Array, 1], 5122: [Int16Array, 2], 5123: [Uint16Array, 2], 5126: [Float32Array, 4] };
const k_widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

/// A document in the making. `json` is the glTF; what `add...` returns are numbers in its lists.
class Builder {
  constructor() {
    this.json = { asset: { version: '2.0', generator: 'ACME exporter', extras: { licence: 'ours' } }, scene: 0, scenes: [], nodes: [] };
    this.binary = Buffer.alloc(0);
  }
  add(list, object) {
    this.json[list] = this.json[list] || [];
    return this.json[list].push(object) - 1;
  }
  addView(bytes, more = {}) {
    const start = this.binary.length;
    const padded = Buffer.alloc(4 * Math.ceil(bytes.length / 4));
    padded.set(bytes);
    this.binary = Buffer.concat([this.binary, padded]);
    return this.add('bufferViews', { buffer: 0, byteOffset: start, byteLength: bytes.length, ...more });
  }
  /// `numbers`: flat; vertex attributes whose entries are no whole words are padded to them.
  addAccessor(numbers, type, { component = 5126, target, bounds = false, ...more } = {}) {
    const [Numbers, size] = k_types[component];
    const width = k_widths[type];
    const count = numbers.length / width;
    const stride = target === 34962 && (width * size) % 4 !== 0 ? 4 * Math.ceil((width * size) / 4) : width * size;
    const bytes = Buffer.alloc(count * stride);
    for (let i = 0; i < count; ++i) {
      bytes.set(new Uint8Array(Numbers.from(numbers.slice(i * width, (i + 1) * width)).buffer), i * stride);
    }
    const view = this.addView(bytes, { ...(target ? { target } : {}), ...(stride !== width * size ? { byteStride: stride } : {}) });
    const accessor = { bufferView: view, componentType: component, count, type, ...more };
    if (bounds) {
      const rounded = Array.from(Numbers.from(numbers));
      const column = (axis) => rounded.filter((_, i) => i % width === axis);
      const axes = [...Array(width).keys()];
      accessor.min = axes.map((axis) => column(axis).reduce((a, b) => Math.min(a, b)));
      accessor.max = axes.map((axis) => column(axis).reduce((a, b) => Math.max(a, b)));
    }
    return this.add('accessors', accessor);
  }
  addPicture(bytes, mimeType, more = {}) {
    return this.add('images', { mimeType, bufferView: this.addView(bytes), ...more });
  }
  /// The document as a .glb file.
  glb() {
    const json = { ...this.json, buffers: [{ byteLength: this.binary.length, ...(this.json.buffers || [{}])[0] }] };
    let text = JSON.stringify(json);
    while (Buffer.byteLength(text) % 4 !== 0) text += ' ';
    const head = Buffer.alloc(20);
    head.write('glTF', 0, 'latin1');
    head.writeUInt32LE(2, 4);
    head.writeUInt32LE(28 + Buffer.byteLength(text) + this.binary.length, 8);
    head.writeUInt32LE(Buffer.byteLength(text), 12);
    head.write('JSON', 16, 'latin1');
    const second = Buffer.alloc(8);
    second.writeUInt32LE(this.binary.length, 0);
    second.write('BIN\0', 4, 'latin1');
    return Buffer.concat([head, Buffer.from(text), second, this.binary]);
  }
}

module.exports = { Builder, png, k_jpeg };
