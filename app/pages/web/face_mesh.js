// Triangles and edges of some of the patches' faces, with vertices of their own so that each face has its normals.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  // The grid of one face: side 0 to 5 = west, east, south, north, front, back; u x v points out of the patch on the
  // high sides.
  isopatch.faceGrid = function (patch, side) {
    const direction = side >> 1;
    const isHigh = side % 2 === 1;
    const [u, v] = [(direction + 1) % 3, (direction + 2) % 3];
    const at = (i, j) => {
      const grid = [0, 0, 0];
      grid[direction] = isHigh ? patch.sizes[direction] - 1 : 0;
      grid[u] = i;
      grid[v] = j;
      return isopatch.vertexIndex(patch, ...grid);
    };
    return {u, v, isHigh, nu: patch.sizes[u], nv: patch.sizes[v], at};
  };

  function triangles(grid, first, out) {
    for (let j = 0; j + 1 < grid.nv; ++j)
      for (let i = 0; i + 1 < grid.nu; ++i) {
        const a = first + i + grid.nu * j;
        const [b, c, d] = [a + 1, a + 1 + grid.nu, a + grid.nu];
        if (grid.isHigh) out.push(a, b, c, a, c, d);
        else out.push(a, c, b, a, d, c);
      }
  }

  function lineAlongU(grid, first, j, out) {
    for (let i = 0; i + 1 < grid.nu; ++i) out.push(first + i + grid.nu * j, first + i + 1 + grid.nu * j);
  }

  function lineAlongV(grid, first, i, out) {
    for (let j = 0; j + 1 < grid.nv; ++j) out.push(first + i + grid.nu * j, first + i + grid.nu * (j + 1));
  }

  function edges(patch, grid, first, patchEdges, elementEdges) {
    const isEnd = (index, count) => index === 0 || index === count - 1;
    for (const i of patch.element_ends[grid.u])
      lineAlongV(grid, first, i, isEnd(i, grid.nu) ? patchEdges : elementEdges);
    for (const j of patch.element_ends[grid.v])
      lineAlongU(grid, first, j, isEnd(j, grid.nv) ? patchEdges : elementEdges);
  }

  // Derivative along a grid line by differences of second order, also at its ends.
  function difference(values, grid, i, j, alongU, c) {
    const n = alongU ? grid.nu : grid.nv;
    const k = alongU ? i : j;
    const value = (m) => values[3 * (alongU ? grid.at(m, j) : grid.at(i, m)) + c];
    if (n === 1) return 0;
    if (n === 2) return value(1) - value(0);
    if (k === 0) return (-3 * value(0) + 4 * value(1) - value(2)) / 2;
    if (k === n - 1) return (3 * value(k) - 4 * value(k - 1) + value(k - 2)) / 2;
    return (value(k + 1) - value(k - 1)) / 2;
  }

  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  isopatch.cross = cross;

  // The normal of the part displaced by s times the displacement is n0 + s n1 + s^2 n2.
  function normals(scene, grid, first, out) {
    const sign = grid.isHigh ? 1 : -1;
    const vector = (values, i, j, alongU) => [0, 1, 2].map((c) => difference(values, grid, i, j, alongU, c));
    for (let j = 0; j < grid.nv; ++j)
      for (let i = 0; i < grid.nu; ++i) {
        const [xu, xv] = [vector(scene.points, i, j, true), vector(scene.points, i, j, false)];
        const [du, dv] = [vector(scene.displacement, i, j, true), vector(scene.displacement, i, j, false)];
        const n0 = cross(xu, xv);
        const scale = sign / (Math.hypot(...n0) || 1);
        const [mixed, other] = [cross(xu, dv), cross(du, xv)];
        const at = 3 * (first + i + grid.nu * j);
        out[0].set(n0.map((x) => x * scale), at);
        out[1].set(mixed.map((x, c) => (x + other[c]) * scale), at);
        out[2].set(cross(du, dv).map((x) => x * scale), at);
      }
  }

  function selectFaces(scene, kind) {
    const faces = [];
    let first = 0;
    scene.patches.forEach((patch, p) => patch.faces.forEach((face, side) => {
      if (face.kind !== kind) return;
      const grid = isopatch.faceGrid(patch, side);
      faces.push({patch: p, side, face, grid, first, count: grid.nu * grid.nv});
      first += grid.nu * grid.nv;
    }));
    return faces;
  }

  // Of the two sides of an interface the one with values in `field` (or the first).
  function oneSideOfEach(scene, faces, field) {
    const seen = new Map();
    const values = field ? scene.blocks[field] : null;
    for (const item of faces) {
      const middle = [0, 0, 0];
      let hasValue = false;
      for (let k = 0; k < item.count; ++k) {
        const vertex = item.grid.at(k % item.grid.nu, Math.floor(k / item.grid.nu));
        for (let c = 0; c < 3; ++c) middle[c] += scene.points[3 * vertex + c] / item.count;
        if (values && Number.isFinite(values[(values.length / scene.count) * vertex])) hasValue = true;
      }
      const key = middle.map((x) => Math.round((x / scene.size) * 1e4)).join();
      if (!seen.has(key) || (hasValue && !seen.get(key).hasValue)) seen.set(key, {item, hasValue});
    }
    let first = 0;
    return [...seen.values()].map(({item}) => {
      const placed = {...item, first};
      first += item.count;
      return placed;
    });
  }

  // kind: "boundary" or "interface"; of the latter each is drawn once, on the side that has values in `field`.
  isopatch.makeFaceMesh = function (scene, kind, field) {
    let faces = selectFaces(scene, kind);
    if (kind === "interface") faces = oneSideOfEach(scene, faces, field);
    const count = faces.reduce((sum, face) => sum + face.count, 0);
    const mesh = {faces, count, source: new Uint32Array(count), normals: [0, 1, 2].map(() => new Float32Array(3 * count))};
    const [triangleList, patchEdges, elementEdges] = [[], [], []];
    for (const item of faces) {
      const {grid, first} = item;
      for (let k = 0; k < item.count; ++k) mesh.source[first + k] = grid.at(k % grid.nu, Math.floor(k / grid.nu));
      item.firstTriangle = triangleList.length / 3;
      triangles(grid, first, triangleList);
      item.triangleCount = triangleList.length / 3 - item.firstTriangle;
      edges(scene.patches[item.patch], grid, first, patchEdges, elementEdges);
      normals(scene, grid, first, mesh.normals);
    }
    mesh.triangles = Uint32Array.from(triangleList);
    mesh.patchEdges = Uint32Array.from(patchEdges);
    mesh.elementEdges = Uint32Array.from(elementEdges);
    return mesh;
  };

  // Values of all vertices carried over to the mesh's own.
  isopatch.gather = function (values, source, components) {
    const result = new Float32Array(source.length * components);
    for (let i = 0; i < source.length; ++i)
      for (let c = 0; c < components; ++c) result[components * i + c] = values[components * source[i] + c];
    return result;
  };
})(globalThis.isopatch);
