// Where a section cuts the patches' faces: the outline of each patch in the section.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  // Lowest and highest coordinate of each patch along each axis.
  isopatch.patchRanges = function (scene) {
    return scene.patches.map((patch) => [0, 1, 2].map((axis) => {
      let [low, high] = [Infinity, -Infinity];
      for (let v = patch.first; v < patch.first + patch.count; ++v) {
        low = Math.min(low, scene.points[3 * v + axis]);
        high = Math.max(high, scene.points[3 * v + axis]);
      }
      return [low, high];
    }));
  };

  // The two points where the plane meets the triangle's sides, as [a, b, weight of b]; none where it passes by.
  function cutTriangle(points, axis, at, corners, emit) {
    const height = (v) => points[3 * v + axis] - at;
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [corners[k], corners[(k + 1) % 3]];
      const [ha, hb] = [height(a), height(b)];
      if (ha > 0 !== hb > 0) emit(a, b, ha / (ha - hb));
    }
  }

  function cutFace(points, grid, axis, at, emit) {
    for (let j = 0; j + 1 < grid.nv; ++j)
      for (let i = 0; i + 1 < grid.nu; ++i) {
        const [a, b, c, d] = [grid.at(i, j), grid.at(i + 1, j), grid.at(i + 1, j + 1), grid.at(i, j + 1)];
        cutTriangle(points, axis, at, [a, b, c], emit);
        cutTriangle(points, axis, at, [a, c, d], emit);
      }
  }

  // The outlines at coordinate `at` of an axis, two points a line, in the form of a section's points.
  isopatch.cutFaces = function (scene, ranges, axis, at) {
    const [a, b, weight] = [[], [], []];
    const emit = (from, to, part) => {
      a.push(from);
      b.push(to);
      weight.push(part);
    };
    scene.patches.forEach((patch, p) => {
      const [low, high] = ranges[p][axis];
      if (low > at || high <= at) return;
      for (let side = 0; side < 6; ++side) cutFace(scene.points, isopatch.faceGrid(patch, side), axis, at, emit);
    });
    return {count: a.length, a: Uint32Array.from(a), b: Uint32Array.from(b), weight: Float32Array.from(weight)};
  };
})(globalThis.isopatch);
