// Cones at supports and arrows of loads, standing on points of the faces they act on.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const most = {supports: 40, loads: 16};  // symbols of each support or load
  isopatch.supportColour = "#1fa8a0";
  isopatch.loadColour = "#d6336c";

  // Points of the faces of support or load number `index`: vertex and outward normal, spread over the faces.
  function anchors(mesh, key, index) {
    const faces = mesh.faces.filter((item) => (item.face[key] || []).includes(index));
    const across = Math.max(1, Math.min(3, Math.floor(Math.sqrt(most[key] / Math.max(1, faces.length)))));
    const every = Math.max(1, Math.ceil((faces.length * across * across) / most[key]));
    const result = [];
    faces.forEach((item, f) => {
      if (f % every !== 0) return;
      for (let a = 0; a < across; ++a)
        for (let b = 0; b < across; ++b) {
          const i = Math.round(((a + 0.5) / across) * (item.grid.nu - 1));
          const j = Math.round(((b + 0.5) / across) * (item.grid.nv - 1));
          const vertex = item.first + i + item.grid.nu * j;
          const normal = [0, 1, 2].map((c) => mesh.normals[0][3 * vertex + c]);
          result.push({vertex: mesh.source[vertex], normal: new THREE.Vector3(...normal)});
        }
    });
    return result;
  }

  // Triangles along the axis `direction` from the anchor: a cone or, with `shaft`, an arrow; all in one list.
  function addCone(list, anchor, tip, base, radius, sides) {
    const axis = tip.clone().sub(base).normalize();
    const side = (Math.abs(axis.z) < 0.9 ? new THREE.Vector3(0, 0, 1) : new THREE.Vector3(1, 0, 0)).cross(axis).normalize();
    const other = axis.clone().cross(side);
    const ring = (k) => {
      const angle = (2 * Math.PI * k) / sides;
      return side.clone().multiplyScalar(Math.cos(angle)).addScaledVector(other, Math.sin(angle));
    };
    for (let k = 0; k < sides; ++k) {
      const [r0, r1] = [ring(k), ring(k + 1)];
      const [p0, p1] = [r0, r1].map((r) => base.clone().addScaledVector(r, radius));
      const slope = r0.clone().add(r1).normalize();
      for (const corner of [p0, p1, tip]) list.push({anchor, offset: corner, outward: slope});
      for (const corner of [p1, p0, base]) list.push({anchor, offset: corner, outward: axis.clone().negate()});
    }
  }

  function addArrow(list, anchor, direction, length, tipAtAnchor) {
    const start = direction.clone().multiplyScalar(tipAtAnchor ? -length : 0);
    const at = (t) => start.clone().addScaledVector(direction, t * length);
    addCone(list, anchor, at(1), at(0.62), 0.13 * length, 12);
    // A slender cone serves as the shaft: it tapers away from the head.
    addCone(list, anchor, at(0), at(0.64), 0.045 * length, 8);
  }

  function geometryOf(scene, list) {
    const geometry = new THREE.BufferGeometry();
    const flat = (vector) => new THREE.BufferAttribute(Float32Array.from(list.flatMap(vector)), 3);
    geometry.setAttribute("position", flat(({anchor}) => anchor.place || isopatch.pointOf(scene, anchor.vertex)));
    geometry.setAttribute("displacement", flat(({anchor}) => (
      anchor.place ? [0, 0, 0] : [0, 1, 2].map((c) => scene.displacement[3 * anchor.vertex + c]))));
    geometry.setAttribute("offset", flat(({offset}) => offset.toArray()));
    geometry.setAttribute("outward", flat(({outward}) => outward.toArray()));
    return geometry;
  }

  function meshOf(scene, list, shared, colour) {
    const mesh = new THREE.Mesh(geometryOf(scene, list), isopatch.symbolMaterial(shared, colour));
    mesh.frustumCulled = false;
    return mesh;
  }

  // A support that fixes points is a cone, one that lets them slide (symmetry, roller) a flat disc on the face.
  function supportList(scene, mesh) {
    const length = 0.022 * scene.size;
    const list = [];
    scene.supports.forEach((support, s) => anchors(mesh, "supports", s).forEach((anchor) => {
      const base = anchor.normal.clone().multiplyScalar(length);
      const origin = new THREE.Vector3(0, 0, 0);
      if (support.kind === "displacement") addCone(list, anchor, origin, base, 0.45 * length, 10);
      else addCone(list, anchor, anchor.normal.clone().multiplyScalar(0.35 * length), origin, 0.4 * length, 12);
    }));
    return list;
  }

  // Away from the part's middle, where a force on the whole volume (weight) has its arrow.
  const wholeBody = (scene) => ({place: [scene.centre[0], scene.centre[1], scene.box.max[2]]});

  // Whether a pressure is negative, by its total; a total that vanishes in a closed bore cannot tell.
  function pullsOutwards(along, total) {
    const mean = new THREE.Vector3();
    for (const {normal} of along) mean.addScaledVector(normal, 1 / along.length);
    return mean.length() > 0.1 && mean.dot(total) > 0;
  }

  function loadList(scene, mesh) {
    const length = 0.075 * scene.size;
    const list = [];
    scene.loads.forEach((load, l) => {
      const total = new THREE.Vector3(...(load.total || [0, 0, 0]));
      const along = anchors(mesh, "loads", l);
      const direction = total.clone().normalize();
      if (along.length === 0 && total.length() > 0)
        addArrow(list, wholeBody(scene), direction, 1.6 * length, direction.z < 0);
      const sucks = pullsOutwards(along, total);
      for (const anchor of along) {
        const own = load.kind === "pressure" || total.length() === 0;
        const inward = own ? anchor.normal.clone().multiplyScalar(sucks ? 1 : -1) : direction;
        addArrow(list, anchor, inward, length, inward.dot(anchor.normal) <= 0);
      }
    });
    return list;
  }

  isopatch.makeSupports = (scene, mesh, shared) => meshOf(scene, supportList(scene, mesh), shared, isopatch.supportColour);
  isopatch.makeLoads = (scene, mesh, shared) => meshOf(scene, loadList(scene, mesh), shared, isopatch.loadColour);
})(globalThis.isopatch);
