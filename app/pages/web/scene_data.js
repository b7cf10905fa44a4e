// The scene of the page's data, decoded: vertices of all patches' grids with their fields.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  // Base64 of little-endian 32 bit numbers.
  isopatch.decodeBlock = function (text) {
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
    return new Float32Array(bytes.buffer);
  };

  // The same of 16 bits in units of `step`; the least number is none.
  isopatch.decodeShortBlock = function (text, step) {
    const binary = atob(text);
    const result = new Float32Array(binary.length / 2);
    for (let i = 0; i < result.length; ++i) {
      const word = binary.charCodeAt(2 * i) | (binary.charCodeAt(2 * i + 1) << 8);
      result[i] = word === 0x8000 ? NaN : step * (word < 0x8000 ? word : word - 0x10000);
    }
    return result;
  };

  function lengths(vectors) {
    const result = new Float32Array(vectors.length / 3);
    for (let i = 0; i < result.length; ++i)
      result[i] = Math.hypot(vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]);
    return result;
  }

  // Component c of n.
  function component(block, n, c) {
    const result = new Float32Array(block.length / n);
    for (let i = 0; i < result.length; ++i) result[i] = block[n * i + c];
    return result;
  }

  function patchOfVertices(scene) {
    const result = new Float32Array(scene.count);
    scene.patches.forEach((patch, p) => result.fill(p, patch.first, patch.first + patch.count));
    return result;
  }

  // Computes on first use.
  function later(compute) {
    let value = null;
    return () => (value === null ? (value = compute()) : value);
  }

  // Of symmetric tensors, in the order of the program.
  isopatch.tensorComponents = ["xx", "yy", "zz", "xy", "yz", "zx"];

  // What the part can be coloured by: every scalar, every vector's length and components, every tensor's components, the patch.
  function quantities(scene) {
    const result = [];
    for (const field of scene.fields) {
      const block = scene.blocks[field.key];
      const n = field.components;
      const add = (suffix, name, values) => result.push({
        id: field.key + suffix, field: field.key, label: field.label + name, unit: field.unit, factor: field.factor,
        on: field.on || "all", isCategorical: false, values: later(values)});
      if (n === 1) add("", "", () => block);
      if (n === 3) add("", "", () => lengths(block));
      const names = n === 3 ? ["x", "y", "z"] : n === 6 ? isopatch.tensorComponents : [];
      names.forEach((axis, c) => add("_" + axis, " " + axis, () => component(block, n, c)));
    }
    result.push({id: "patch", field: "patch", label: "Patch", unit: "", factor: 1, on: "all", isCategorical: true,
                 values: later(() => patchOfVertices(scene))});
    return result;
  }

  // Smallest, largest and percentiles of the numbers that are finite; null if there is none.
  isopatch.statistics = function (values) {
    const sorted = values.filter(Number.isFinite).sort();
    if (sorted.length === 0) return null;
    const percentile = (p) => sorted[Math.min(sorted.length - 1, Math.floor((p / 100) * sorted.length))];
    return {min: sorted[0], max: sorted[sorted.length - 1], percentile, count: sorted.length};
  };

  isopatch.readScene = function (data) {
    const points = isopatch.decodeBlock(data.points);
    const patches = data.patches.map((patch) => ({...patch, count: patch.sizes[0] * patch.sizes[1] * patch.sizes[2]}));
    const {min, max} = data.box;
    const scene = {
      length: data.length, box: data.box, fields: data.fields, points, patches, count: points.length / 3,
      centre: min.map((x, i) => (x + max[i]) / 2), size: Math.hypot(...max.map((x, i) => x - min[i])), blocks: {},
      supports: data.supports || [], loads: data.loads || [], markers: data.markers || [],
      warnings: data.warnings || [], tolerance: data.tolerance || null};
    for (const field of data.fields)
      scene.blocks[field.key] = field.step ? isopatch.decodeShortBlock(data[field.key], field.step) : isopatch.decodeBlock(data[field.key]);
    scene.isSolved = "displacement" in scene.blocks;
    scene.displacement = scene.blocks.displacement || new Float32Array(points.length);
    scene.maxDisplacement = scene.isSolved ? (isopatch.statistics(lengths(scene.displacement)) || {max: 0}).max : 0;
    scene.quantities = quantities(scene);
    return scene;
  };

  // Index of a grid's vertex (i, j, k) among all vertices.
  isopatch.vertexIndex = (patch, i, j, k) => patch.first + i + patch.sizes[0] * (j + patch.sizes[1] * k);

  // Parameters of a vertex in the input's naming.
  isopatch.parameterOf = function (patch, vertex) {
    const local = vertex - patch.first;
    const [n0, n1] = patch.sizes;
    const grid = [local % n0, Math.floor(local / n0) % n1, Math.floor(local / (n0 * n1))];
    return grid.map((index, d) => patch.parameters[d][index]);
  };

  isopatch.pointOf = (scene, vertex) => [0, 1, 2].map((c) => scene.points[3 * vertex + c]);

  // Mean of a patch's vertices.
  isopatch.centreOfPatch = function (scene, patch) {
    const sum = [0, 0, 0];
    for (let v = patch.first; v < patch.first + patch.count; ++v)
      for (let c = 0; c < 3; ++c) sum[c] += scene.points[3 * v + c] / patch.count;
    return sum;
  };
})(globalThis.isopatch);
