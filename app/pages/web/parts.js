// All that is drawn: outer surface, interfaces, section, supports and loads; how they follow the viewer's state.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const noPlane = [0, 0, 0, 1];

  function makeObjects(scene, shared) {
    const surface = isopatch.makeSurface(scene, isopatch.makeFaceMesh(scene, "boundary"), shared);
    const interfaceField = (scene.fields.find((field) => field.on === "interfaces") || {}).key;
    const interfaceMesh = isopatch.makeFaceMesh(scene, "interface", interfaceField);
    const interfaces = isopatch.makeSurface(scene, interfaceMesh, shared);
    const section = isopatch.makeSectionSurface(scene, shared);
    const supports = isopatch.makeSupports(scene, surface.mesh, shared);
    const loads = isopatch.makeLoads(scene, surface.mesh, shared);
    surface.faces.renderOrder = 1;  // translucent after what is inside
    return {surface, interfaces, section, supports, loads};
  }

  function worldOf({surface, interfaces, section, supports, loads}) {
    const world = new THREE.Scene();
    world.add(interfaces.faces, interfaces.patchEdges, interfaces.elementEdges, section.faces, section.outlines, supports,
              loads, surface.faces, surface.patchEdges, surface.elementEdges);
    return world;
  }

  function showSurface(surface, state) {
    const isShown = state.surface !== "hidden";
    const isTranslucent = state.surface === "translucent";
    surface.faces.visible = isShown;
    isopatch.setOpacity(surface.material, isTranslucent ? 0.22 : 1);
    for (const [lines, isWanted] of [[surface.patchEdges, state.patchEdges], [surface.elementEdges, state.elementEdges]]) {
      lines.material.uniforms.isPlain.value = isTranslucent ? 1 : 0;
      lines.visible = isShown && isWanted;
    }
  }

  function showInterfaces(interfaces, state) {
    interfaces.faces.visible = state.interfaces;
    interfaces.patchEdges.visible = state.interfaces && state.patchEdges;
    interfaces.elementEdges.visible = state.interfaces && state.elementEdges;
  }

  isopatch.makeParts = function (scene, shared) {
    const objects = makeObjects(scene, shared);
    const {surface, interfaces, section, supports, loads} = objects;
    let cells = null;  // made for the first section
    let quantity = null;

    // Colours everything by the quantity.
    function colour(chosen) {
      quantity = chosen;
      for (const part of [surface, interfaces, section]) part.show(quantity);
      shared.categories.value = quantity.isCategorical ? isopatch.categories.length : 0;
      shared.colours.value = quantity.isCategorical ? shared.maps.categorical : shared.maps.continuous;
    }

    // Cuts everything across state.axis (0, 1, 2; none if negative), at state.at from 0 to 1 of the box.
    function cut(state) {
      if (state.axis < 0) {
        shared.plane.value.set(...noPlane);
        section.cut(null, null);
        return;
      }
      const {min, max} = scene.box;
      const at = min[state.axis] + state.at * (max[state.axis] - min[state.axis]);
      const plane = [0, 0, 0, state.isFlipped ? -at : at];
      plane[state.axis] = state.isFlipped ? -1 : 1;
      shared.plane.value.set(...plane);
      if (!cells) cells = {all: isopatch.makeCells(scene), ranges: isopatch.patchRanges(scene)};
      section.cut(isopatch.cutCells(scene, cells.all, state.axis, at), isopatch.cutFaces(scene, cells.ranges, state.axis, at));
      section.show(quantity);
    }

    // Whether a place of the undeformed part is cut off.
    function isCut(place) {
      const {x, y, z, w} = shared.plane.value;
      return x * place[0] + y * place[1] + z * place[2] > w;
    }

    function setVisibility(state) {
      showSurface(surface, state);
      showInterfaces(interfaces, state);
      section.outlines.visible = state.patchEdges && section.hasOutlines();
      supports.visible = state.supports;
      loads.visible = state.loads;
    }

    return {...objects, world: worldOf(objects), colour, cut, isCut, setVisibility};
  };
})(globalThis.isopatch);
