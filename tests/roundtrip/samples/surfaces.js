// Surfaces of samples: grids of vertices with what a renderer wants, and the matrices of nodes.
'use strict';

/// A grid of rows x columns vertices. `at(u, v)`, both 0 to 1, gives [x, y, z]; normals and tangents follow from it (front:
/// the side from which u runs to the right and v down). Returns flat lists.
function grid(rows, columns, at) {
  const surface = { rows, columns, positions: [], normals: [], tangents: [], uv: [], corners: [] };
  const step = 1e-4;
  for (let r = 0; r < rows; ++r) {
    for (let c = 0; c < columns; ++c) {
      const u = c / (columns - 1);
      const v = r / (rows - 1);
      const along = unit(minus(at(u + step, v), at(u - step, v)));
      const normal = unit(cross(minus(at(u, v + step), at(u, v - step)), along));
      surface.positions.push(...at(u, v));
      surface.normals.push(...normal);
      surface.tangents.push(...unit(minus(along, times(normal, dot(along, normal)))), 1);
      surface.uv.push(u, v);
      if (r + 1 === rows || c + 1 === columns) continue;
      const a = r * columns + c;
      surface.corners.push([a, a + columns, a + columns + 1], [a, a + columns + 1, a + 1]);
    }
  }
  return surface;
}

/// What a target adds: `by(x, y, z)` moves a point; normals and tangents follow from the surface that results.
function target(surface, at, by) {
  const moved = grid(surface.rows, surface.columns, (u, v) => {
    const p = at(u, v);
    const d = by(...p);
    return p.map((x, axis) => x + d[axis]);
  });
  const delta = (name) => moved[name].map((x, i) => x - surface[name][i]);
  return { positions: delta('positions'), normals: delta('normals'), tangents: delta('tangents').filter((_, i) => i % 4 !== 3) };
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => a.map((x, i) => x - b[i]);
const times = (a, s) => a.map((x) => x * s);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(a, 1 / Math.sqrt(dot(a, a)));

/// The product of two rotations [x, y, z, w].
function turned([ax, ay, az, aw], [bx, by, bz, bw]) {
  return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
          aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz];
}
/// A point turned by a rotation.
function rotated(q, p) {
  const [x, y, z] = turned(turned(q, [...p, 0]), [-q[0], -q[1], -q[2], q[3]]);
  return [x, y, z];
}
/// The matrix, by columns, that undoes a rotation and then a shift.
function undoing(rotation, place) {
  const back = [-rotation[0], -rotation[1], -rotation[2], rotation[3]];
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => [...rotated(back, axis), 0]);
  return [...axes.flat(), ...rotated(back, times(place, -1)), 1];
}

module.exports = { grid, target, turned, rotated, undoing, minus };
