// What lies under a point of the picture: the first triangle that a ray meets, and the values there.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const cross = (a, b) => isopatch.cross(a, b);
  const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

  // Distance along the ray and weights of the triangle's corners, or null.
  // Source: T. Moeller, B. Trumbore, Fast, minimum storage ray/triangle intersection, 1997.
  isopatch.meetTriangle = function (origin, direction, p, q, r) {
    const [e1, e2] = [minus(q, p), minus(r, p)];
    const h = cross(direction, e2);
    const determinant = dot(e1, h);
    if (determinant === 0) return null;
    const s = minus(origin, p);
    const u = dot(s, h) / determinant;
    if (!(u >= 0 && u <= 1)) return null;
    const k = cross(s, e1);
    const v = dot(direction, k) / determinant;
    if (!(v >= 0 && u + v <= 1)) return null;
    const distance = dot(e2, k) / determinant;
    return distance > 0 ? {distance, weights: [1 - u - v, u, v]} : null;
  };

  function meetsBox(origin, direction, low, high) {
    let [near, far] = [0, Infinity];
    for (let c = 0; c < 3; ++c) {
      const [a, b] = [(low[c] - origin[c]) / direction[c], (high[c] - origin[c]) / direction[c]];
      if (Number.isNaN(a) || Number.isNaN(b)) continue;
      near = Math.max(near, Math.min(a, b));
      far = Math.min(far, Math.max(a, b));
    }
    return near <= far;
  }

  // Triangles at their displaced places in groups with a box each.
  function displaced(points, displacement, scale) {
    const result = new Float32Array(points.length);
    for (let i = 0; i < points.length; ++i) result[i] = points[i] + scale * displacement[i];
    return result;
  }

  function boxOf(positions, first, count) {
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (let v = first; v < first + count; ++v)
      for (let c = 0; c < 3; ++c) {
        low[c] = Math.min(low[c], positions[3 * v + c]);
        high[c] = Math.max(high[c], positions[3 * v + c]);
      }
    return {low, high};
  }

  const corner = (positions, v) => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];

  // Nearest hit {distance, weights, vertices} over the groups; `isCut(place)` tells undeformed places that are cut off.
  function nearest(ray, body, isCut) {
    let best = null;
    for (const group of body.groups) {
      if (!meetsBox(ray.origin, ray.direction, group.low, group.high)) continue;
      for (let t = group.firstTriangle; t < group.firstTriangle + group.triangleCount; ++t) {
        const vertices = [0, 1, 2].map((k) => body.corner(3 * t + k));
        const hit = isopatch.meetTriangle(ray.origin, ray.direction, ...vertices.map((v) => corner(body.moved, v)));
        if (!hit || (best && hit.distance >= best.distance)) continue;
        const place = [0, 1, 2].map((c) => vertices.reduce((x, v, k) => x + hit.weights[k] * body.places[3 * v + c], 0));
        if (!isCut(place)) best = {...hit, vertices, place, group, triangle: t};
      }
    }
    return best;
  }

  // A face mesh to pick from at one scale of the deformation.
  isopatch.meshBody = function (scene, mesh, scale) {
    const places = isopatch.gather(scene.points, mesh.source, 3);
    const moved = displaced(places, isopatch.gather(scene.displacement, mesh.source, 3), scale);
    const groups = mesh.faces.map((face) => ({...face, ...boxOf(moved, face.first, face.count)}));
    // Corners are mixed from vertices of one patch: [vertex, weight] pairs.
    return {places, moved, groups, corner: (k) => mesh.triangles[k], patchOf: (hit) => hit.group.patch,
            mix: (v) => [[mesh.source[v], 1]]};
  };

  isopatch.sectionBody = function (scene, section, scale) {
    const places = isopatch.onSection(scene.points, section, 3);
    const moved = displaced(places, isopatch.onSection(scene.displacement, section, 3), scale);
    const groups = [{firstTriangle: 0, triangleCount: section.count / 3, ...boxOf(moved, 0, section.count)}];
    return {places, moved, groups, corner: (k) => k, patchOf: (hit) => section.patch[hit.triangle],
            mix: (v) => [[section.a[v], 1 - section.weight[v]], [section.b[v], section.weight[v]]]};
  };

  // Values at a hit, interpolated between the vertices.
  function valuesAt(scene, body, hit) {
    const patch = scene.patches[body.patchOf(hit)];
    const terms = hit.vertices.flatMap((v, k) => body.mix(v).map(([vertex, w]) => [vertex, w * hit.weights[k]]));
    const sum = (value) => terms.reduce((x, [vertex, weight]) => x + (weight === 0 ? 0 : weight * value(vertex)), 0);
    const fields = {};
    for (const field of scene.fields) {
      const block = scene.blocks[field.key];
      fields[field.key] = Array.from({length: field.components}, (_, c) => sum((v) => block[field.components * v + c]));
    }
    return {place: hit.place, patch, fields, distance: hit.distance, face: hit.group.face || null,
            parameter: [0, 1, 2].map((d) => sum((v) => isopatch.parameterOf(patch, v)[d]))};
  }

  // The nearest of several bodies: [{body, isCut}].
  isopatch.pick = function (scene, ray, bodies) {
    let best = null;
    for (const {body, isCut} of bodies) {
      const hit = nearest(ray, body, isCut);
      if (hit && (!best || hit.distance < best.hit.distance)) best = {body, hit};
    }
    return best ? valuesAt(scene, best.body, best.hit) : null;
  };
})(globalThis.isopatch);
