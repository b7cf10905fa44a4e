// What is drawn of a face mesh or of a section: triangles and edges that share one set of displaced vertices.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const attribute = (array, size) => new THREE.BufferAttribute(array, size);

  // NaN does not survive a graphics card for certain; a huge number does, and the shader draws it grey.
  isopatch.forShader = function (values) {
    return values.map((x) => (Number.isFinite(x) ? x : 3e38));
  };

  function unculled(object) {
    object.frustumCulled = false;
    return object;
  }

  // Lines come after all faces, also after translucent ones.
  function lastDrawn(lines) {
    lines.renderOrder = 2;
    return unculled(lines);
  }

  function indexed(attributes, index) {
    const geometry = new THREE.BufferGeometry();
    for (const [name, value] of Object.entries(attributes)) geometry.setAttribute(name, value);
    geometry.setIndex(attribute(index, 1));
    return geometry;
  }

  // Surface with the edges of patches and of elements; `show(quantity)` colours it.
  isopatch.makeSurface = function (scene, mesh, shared) {
    const {gather} = isopatch;
    const place = {position: attribute(gather(scene.points, mesh.source, 3), 3),
                   displacement: attribute(gather(scene.displacement, mesh.source, 3), 3)};
    const value = attribute(new Float32Array(mesh.count), 1);
    const normals = Object.fromEntries(mesh.normals.map((n, i) => ["normal" + i, attribute(n, 3)]));
    const material = isopatch.surfaceMaterial(shared);
    const lines = (index, opacity) => lastDrawn(new THREE.LineSegments(
      indexed({...place, value}, index), isopatch.lineMaterial(shared, opacity)));
    const surface = {
      mesh, material, faces: unculled(new THREE.Mesh(indexed({...place, value, ...normals}, mesh.triangles), material)),
      patchEdges: lines(mesh.patchEdges, 1), elementEdges: lines(mesh.elementEdges, 0.35)};
    surface.show = function (quantity) {
      value.array.set(isopatch.forShader(gather(quantity.values(), mesh.source, 1)));
      value.needsUpdate = true;
    };
    return surface;
  };

  // The geometry of points that lie on edges between vertices, as sections give them.
  function cutGeometry(scene, section) {
    const geometry = new THREE.BufferGeometry();
    const set = (name, array, size) => geometry.setAttribute(name, attribute(array, size));
    set("position", isopatch.onSection(scene.points, section, 3), 3);
    set("displacement", isopatch.onSection(scene.displacement, section, 3), 3);
    const flat = new Float32Array(3 * section.count);
    for (const name of ["normal0", "normal1", "normal2"]) set(name, flat, 3);
    return geometry;
  }

  // The filled section with the patches' outlines; `cut(section, outlines)` draws another one, or none (null),
  // `show(quantity)` colours it.
  isopatch.makeSectionSurface = function (scene, shared) {
    const uncut = {...shared, plane: {value: new THREE.Vector4(0, 0, 0, 1)}};
    const nothing = new THREE.BufferGeometry();
    const faces = unculled(new THREE.Mesh(nothing, isopatch.surfaceMaterial(uncut)));
    const outlines = lastDrawn(new THREE.LineSegments(nothing, isopatch.lineMaterial(uncut, 1)));
    const result = {faces, outlines, section: null};
    const drawn = [];
    result.cut = function (section, lines) {
      result.section = section;
      drawn.length = 0;
      for (const [object, points] of [[faces, section], [outlines, lines]]) {
        object.geometry.dispose();
        object.visible = Boolean(points && points.count > 0);
        if (!object.visible) continue;
        object.geometry = cutGeometry(scene, points);
        drawn.push([object, points]);
      }
    };
    result.show = function (quantity) {
      for (const [object, points] of drawn) {
        const values = isopatch.forShader(isopatch.onSection(quantity.values(), points, 1));
        object.geometry.setAttribute("value", attribute(values, 1));
      }
    };
    result.hasOutlines = () => drawn.some(([object]) => object === outlines);
    result.cut(null, null);
    return result;
  };
})(globalThis.isopatch);
