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
    const lines = (index, opacity) => unculled(new THREE.LineSegments(
      indexed(place, index), isopatch.lineMaterial(shared, "#101010", opacity)));
    const surface = {
      mesh, material, faces: unculled(new THREE.Mesh(indexed({...place, value, ...normals}, mesh.triangles), material)),
      patchEdges: lines(mesh.patchEdges, 1), elementEdges: lines(mesh.elementEdges, 0.35)};
    surface.show = function (quantity) {
      value.array.set(isopatch.forShader(gather(quantity.values(), mesh.source, 1)));
      value.needsUpdate = true;
    };
    return surface;
  };

  // The filled section; `cut(section)` draws another one, `show(quantity)` colours it.
  isopatch.makeSectionSurface = function (scene, shared) {
    const uncut = {...shared, plane: {value: new THREE.Vector4(0, 0, 0, 1)}};
    const faces = unculled(new THREE.Mesh(new THREE.BufferGeometry(), isopatch.surfaceMaterial(uncut)));
    const result = {faces, section: null};
    result.cut = function (section) {
      faces.geometry.dispose();
      faces.geometry = new THREE.BufferGeometry();
      result.section = section;
      faces.visible = section !== null && section.count > 0;
      if (!faces.visible) return;
      const flat = new Float32Array(3 * section.count);
      const set = (name, array, size) => faces.geometry.setAttribute(name, attribute(array, size));
      set("position", isopatch.onSection(scene.points, section, 3), 3);
      set("displacement", isopatch.onSection(scene.displacement, section, 3), 3);
      set("value", new Float32Array(section.count), 1);
      for (const name of ["normal0", "normal1", "normal2"]) set(name, flat, 3);
    };
    result.show = function (quantity) {
      if (!faces.visible || result.section === null) return;
      const values = isopatch.forShader(isopatch.onSection(quantity.values(), result.section, 1));
      faces.geometry.setAttribute("value", attribute(values, 1));
    };
    result.cut(null);
    return result;
  };
})(globalThis.isopatch);
