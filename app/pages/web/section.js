// The cut of a plane through the patches' grids: every cell is six tetrahedra, their fields are linear.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  // Corners of a cell are numbered by bits (1: first direction, 2: second, 4: third); the six tetrahedra share the
  // diagonal from 0 to 7 and fit those of the neighbouring cells.
  const tetrahedra = [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]];

  // All cells: the first vertex, the steps to the others, and the range along each axis.
  isopatch.makeCells = function (scene) {
    let count = 0;
    for (const patch of scene.patches) count += patch.sizes.reduce((product, n) => product * (n - 1), 1);
    const cells = {count, vertex: new Uint32Array(count), patch: new Uint16Array(count),
                   low: [0, 1, 2].map(() => new Float32Array(count)), high: [0, 1, 2].map(() => new Float32Array(count))};
    let cell = 0;
    scene.patches.forEach((patch, p) => {
      const [n0, n1, n2] = patch.sizes;
      for (let k = 0; k + 1 < n2; ++k)
        for (let j = 0; j + 1 < n1; ++j)
          for (let i = 0; i + 1 < n0; ++i, ++cell) {
            cells.vertex[cell] = isopatch.vertexIndex(patch, i, j, k);
            cells.patch[cell] = p;
          }
    });
    findRanges(scene, cells);
    return cells;
  };

  function cornerSteps(patch) {
    const [n0, n1] = patch.sizes;
    return [0, 1, n0, n0 + 1, n0 * n1, n0 * n1 + 1, n0 * n1 + n0, n0 * n1 + n0 + 1];
  }

  function findRanges(scene, cells) {
    const steps = scene.patches.map(cornerSteps);
    for (let cell = 0; cell < cells.count; ++cell)
      for (let axis = 0; axis < 3; ++axis) {
        let [low, high] = [Infinity, -Infinity];
        for (const step of steps[cells.patch[cell]]) {
          const x = scene.points[3 * (cells.vertex[cell] + step) + axis];
          if (x < low) low = x;
          if (x > high) high = x;
        }
        cells.low[axis][cell] = low;
        cells.high[axis][cell] = high;
      }
  }

  // Points where edges of one tetrahedron meet the plane, in order around the cut (three or four), as [a, b, weight of b].
  function cutTetrahedron(points, axis, at, corners, emit) {
    const above = [];
    const below = [];
    for (const corner of corners) (points[3 * corner + axis] > at ? above : below).push(corner);
    if (above.length === 0 || below.length === 0) return;
    const cut = (a, b) => {
      const [xa, xb] = [points[3 * a + axis], points[3 * b + axis]];
      return [a, b, (at - xa) / (xb - xa)];
    };
    const [p, q] = above.length === 1 || below.length === 1 ? [null, null] : [above, below];
    if (p) {
      const [ac, ad, bd, bc] = [cut(p[0], q[0]), cut(p[0], q[1]), cut(p[1], q[1]), cut(p[1], q[0])];
      emit(ac, ad, bd);
      emit(ac, bd, bc);
      return;
    }
    const [lone, others] = above.length === 1 ? [above[0], below] : [below[0], above];
    emit(...others.map((other) => cut(lone, other)));
  }

  // The section at coordinate `at` of an axis (0, 1, 2): three points a triangle, each on the edge from vertex `a` to
  // vertex `b` with `weight` of b.
  isopatch.cutCells = function (scene, cells, axis, at) {
    const [a, b, weight, patch] = [[], [], [], []];
    const [low, high] = [cells.low[axis], cells.high[axis]];
    const steps = scene.patches.map(cornerSteps);
    const corners = [0, 0, 0, 0];
    let current = 0;
    const emit = (...ends) => {
      for (const end of ends) {
        a.push(end[0]);
        b.push(end[1]);
        weight.push(end[2]);
      }
      patch.push(current);
    };
    for (let cell = 0; cell < cells.count; ++cell) {
      if (low[cell] > at || high[cell] <= at) continue;
      current = cells.patch[cell];
      for (const tetrahedron of tetrahedra) {
        for (let i = 0; i < 4; ++i) corners[i] = cells.vertex[cell] + steps[current][tetrahedron[i]];
        cutTetrahedron(scene.points, axis, at, corners, emit);
      }
    }
    return {count: a.length, a: Uint32Array.from(a), b: Uint32Array.from(b), weight: Float32Array.from(weight),
            patch: Uint16Array.from(patch)};
  };

  // Values of all vertices carried over to the section's points.
  isopatch.onSection = function (values, section, components) {
    const result = new Float32Array(section.count * components);
    for (let i = 0; i < section.count; ++i)
      for (let c = 0; c < components; ++c) {
        const [x, y] = [values[components * section.a[i] + c], values[components * section.b[i] + c]];
        result[components * i + c] = x + section.weight[i] * (y - x);
      }
    return result;
  };
})(globalThis.isopatch);
