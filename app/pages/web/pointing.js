// Between the picture and the part: where a point appears, what a pixel shows, what is hidden.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  isopatch.makePointing = function (scene, parts, camera, canvas, state) {
    const bodies = new Map();  // by name, at the present deformation

    function body(name, make) {
      if (!bodies.has(name)) bodies.set(name, make());
      return bodies.get(name);
    }

    const faces = (name) => body(name, () => isopatch.meshBody(scene, parts[name].mesh, state.scale));

    // A translucent surface is looked through.
    function pickable() {
      const result = [];
      const {section} = parts.section;
      if (state.surface === "solid") result.push({body: faces("surface"), isCut: parts.isCut});
      if (state.interfaces) result.push({body: faces("interfaces"), isCut: parts.isCut});
      if (section && section.count > 0)
        result.push({body: body("section", () => isopatch.sectionBody(scene, section, state.scale)), isCut: () => false});
      return result;
    }

    const hitTowards = (point) => isopatch.pick(scene, {
      origin: camera.position.toArray(), direction: point.clone().sub(camera.position).normalize().toArray()}, pickable());

    // Pixels of the canvas, or null outside of the picture.
    function project(point) {
      const v = new THREE.Vector3(...point).project(camera);
      if (Math.abs(v.x) > 1 || Math.abs(v.y) > 1 || Math.abs(v.z) > 1) return null;
      return [((v.x + 1) / 2) * canvas.clientWidth, ((1 - v.y) / 2) * canvas.clientHeight];
    }

    // What a pixel shows, or null.
    function pickAt(x, y) {
      const to = new THREE.Vector3((2 * x) / canvas.clientWidth - 1, 1 - (2 * y) / canvas.clientHeight, 0.5);
      return hitTowards(to.unproject(camera));
    }

    // Whether the part covers a displaced point.
    function isHidden(place) {
      const point = new THREE.Vector3(...place);
      const hit = hitTowards(point);
      return hit !== null && hit.distance < camera.position.distanceTo(point) - 0.004 * scene.size;
    }

    // After the deformation (all) or the section has changed.
    const forget = (name) => (name ? bodies.delete(name) : bodies.clear());

    return {project, pickAt, isHidden, forget, surfacePoints: () => faces("surface").moved};
  };
})(globalThis.isopatch);
