// The part in three dimensions. Everything that can be changed is in `state`; `change({...})` applies new values and asks
// for one picture. Nothing is drawn while nothing changes.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const fieldOfView = 24;  // degrees: little distortion
  const noPlane = [0, 0, 0, 1];

  function makeRenderer(canvas) {
    const settings = {antialias: true, alpha: false, preserveDrawingBuffer: true};
    const context = canvas.getContext("webgl2", settings) || canvas.getContext("webgl", settings);
    if (!context) return null;
    const renderer = new THREE.WebGLRenderer({canvas, context, ...settings});
    renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    return renderer;
  }

  function niceScale(value) {
    const power = 10 ** Math.floor(Math.log10(value));
    return [5, 2, 1].find((n) => n * power <= value * (1 + 1e-9)) * power;
  }

  // The scale at which the largest displacement is about a tenth of the part's size, and the one shown first.
  isopatch.scalesOf = function (scene) {
    if (!(scene.maxDisplacement > 0)) return {largest: 1, first: 0};
    // Half of a tenth, and the true one where that is not much more.
    const half = (0.05 * scene.size) / scene.maxDisplacement;
    const first = half < 1 && half > 0.1 ? 1 : niceScale(half);
    return {largest: Math.max(1, 2 * first), first};
  };

  function makeParts(scene, shared) {
    const surface = isopatch.makeSurface(scene, isopatch.makeFaceMesh(scene, "boundary"), shared);
    const interfaceField = (scene.fields.find((field) => field.on === "interfaces") || {}).key;
    const interfaceMesh = isopatch.makeFaceMesh(scene, "interface", interfaceField);
    const interfaces = isopatch.makeSurface(scene, interfaceMesh, shared);
    const section = isopatch.makeSectionSurface(scene, shared);
    const supports = isopatch.makeSupports(scene, surface.mesh, shared);
    const loads = isopatch.makeLoads(scene, surface.mesh, shared);
    const world = new THREE.Scene();
    surface.faces.renderOrder = 1;  // translucent after what is inside
    world.add(interfaces.faces, interfaces.patchEdges, interfaces.elementEdges, section.faces, section.outlines, supports, loads,
              surface.faces, surface.patchEdges, surface.elementEdges);
    return {surface, interfaces, section, supports, loads, world};
  }

  function firstState(scene, options) {
    const wanted = options.quantity || (scene.isSolved ? "displacement" : "scaled_jacobian");
    const quantity = scene.quantities.find((q) => q.id === wanted) || scene.quantities[0];
    return {scale: isopatch.scalesOf(scene).first, quantity, range: null, bands: 0, patchEdges: true, elementEdges: false,
            supports: true, loads: true, markers: true, surface: options.surface || "solid",
            interfaces: Boolean(options.interfaces), axis: -1, isFlipped: false, at: 0.5};
  }

  // The viewer, or null if the browser has no WebGL. `host` gets a canvas and the layers over it.
  isopatch.makeViewer = function (host, scene, options) {
    const element = isopatch.element;
    const canvas = element("canvas", {tabindex: "0", role: "img", "aria-label":
      "The part in three dimensions. Arrow keys turn it, shift and arrows move it, plus and minus zoom, 1 to 7 choose a view, 0 fits it in."});
    const renderer = makeRenderer(canvas);
    if (!renderer) return null;
    const layer = element("div", {class: "marker-layer", "aria-hidden": "true"});
    const bar = element("div", {class: "colour-bar"});
    const caption = element("div", {class: "caption"});
    host.append(canvas, layer, bar, caption);

    const shared = isopatch.makeUniforms();
    const parts = makeParts(scene, shared);
    const camera = new THREE.PerspectiveCamera(fieldOfView, 1, 1, 10);
    const state = firstState(scene, options);
    const places = isopatch.placesOf(scene);
    const markers = isopatch.makeMarkers(layer, places);
    const listeners = {changed: [], picked: []};
    const tell = (event, value) => listeners[event].forEach((f) => f(value));
    const statistics = new Map();
    const bodies = new Map();
    let cells = null;  // made for the first section
    let asked = false;
    let isCutStale = false;
    let isColourStale = false;

    function statisticsOf(quantity) {
      if (!statistics.has(quantity.id)) statistics.set(quantity.id, isopatch.statistics(quantity.values()));
      return statistics.get(quantity.id);
    }

    const coordinate = () => scene.box.min[state.axis] + state.at * (scene.box.max[state.axis] - scene.box.min[state.axis]);

    function cut() {
      isCutStale = false;
      bodies.delete("section");
      if (state.axis < 0) {
        shared.plane.value.set(...noPlane);
        parts.section.cut(null, null);
        return;
      }
      const plane = [0, 0, 0, state.isFlipped ? -coordinate() : coordinate()];
      plane[state.axis] = state.isFlipped ? -1 : 1;
      shared.plane.value.set(...plane);
      if (!cells) cells = {all: isopatch.makeCells(scene), ranges: isopatch.patchRanges(scene)};
      const at = [state.axis, coordinate()];
      parts.section.cut(isopatch.cutCells(scene, cells.all, ...at), isopatch.cutFaces(scene, cells.ranges, ...at));
      parts.section.show(state.quantity);
    }

    function colour() {
      isColourStale = false;
      for (const part of [parts.surface, parts.interfaces, parts.section]) part.show(state.quantity);
      const {isCategorical} = state.quantity;
      shared.categories.value = isCategorical ? isopatch.categories.length : 0;
      shared.colours.value = isCategorical ? shared.maps.categorical : shared.maps.continuous;
    }

    function applyVisibility() {
      const isShown = state.surface !== "hidden";
      const {surface, interfaces} = parts;
      surface.faces.visible = isShown;
      const isTranslucent = state.surface === "translucent";
      isopatch.setOpacity(surface.material, isTranslucent ? 0.22 : 1);
      for (const lines of [surface.patchEdges, surface.elementEdges])
        lines.material.uniforms.isPlain.value = isTranslucent ? 1 : 0;
      surface.patchEdges.visible = isShown && state.patchEdges;
      surface.elementEdges.visible = isShown && state.elementEdges;
      const {outlines, section} = parts.section;
      outlines.visible = state.patchEdges && section !== null && outlines.geometry.attributes.position !== undefined;
      interfaces.faces.visible = state.interfaces;
      interfaces.patchEdges.visible = state.interfaces && state.patchEdges;
      interfaces.elementEdges.visible = state.interfaces && state.elementEdges;
      parts.supports.visible = state.supports;
      parts.loads.visible = state.loads;
      layer.hidden = !state.markers;
    }

    function apply() {
      if (isColourStale) colour();
      if (isCutStale) cut();
      shared.scale.value = state.scale;
      shared.bands.value = state.bands;
      shared.range.value.set(...state.range);
      applyVisibility();
      isopatch.drawColourBar(bar, scene, state.quantity, state.range, state.bands, statisticsOf(state.quantity));
      caption.textContent = scene.isSolved ? "deformation \u00d7 " + isopatch.general(state.scale, 3) : "";
    }

    function project(point) {
      const v = new THREE.Vector3(...point).project(camera);
      if (Math.abs(v.x) > 1 || Math.abs(v.y) > 1 || Math.abs(v.z) > 1) return null;
      return [((v.x + 1) / 2) * canvas.clientWidth, ((1 - v.y) / 2) * canvas.clientHeight];
    }

    // Whether the part covers a displaced point.
    function isHidden(point) {
      const ray = rayTo(new THREE.Vector3(...point));
      const hit = isopatch.pick(scene, ray, pickable());
      return hit !== null && hit.distance < camera.position.distanceTo(new THREE.Vector3(...point)) - 0.004 * scene.size;
    }

    let isStale = true;
    let resting = null;
    function draw() {
      asked = false;
      if (isStale) apply();
      isStale = false;
      renderer.render(parts.world, camera);
      markers.update(state.scale, project, isCut, canvas.clientWidth);
      viewer.pictures += 1;
      clearTimeout(resting);
      resting = setTimeout(() => markers.markHidden(isHidden), 150);
    }

    function ask() {
      if (asked) return;
      asked = true;
      requestAnimationFrame(draw);
    }

    function change(values) {
      const old = {...state};
      Object.assign(state, values);
      if (state.quantity !== old.quantity) {
        isColourStale = true;
        if (!values.range) state.range = isopatch.defaultRange(state.quantity, statisticsOf(state.quantity));
        if (state.quantity.on === "interfaces") {
          state.interfaces = true;
          if (state.surface === "solid") state.surface = "translucent";
        }
      }
      if (state.scale !== old.scale) bodies.clear();
      if (["axis", "isFlipped", "at"].some((key) => state[key] !== old[key])) isCutStale = true;
      isStale = true;
      ask();
      tell("changed", state);
    }

    function body(name, make) {
      if (!bodies.has(name)) bodies.set(name, make());
      return bodies.get(name);
    }

    const isCut = (place) => {
      const {x, y, z, w} = shared.plane.value;
      return x * place[0] + y * place[1] + z * place[2] > w;
    };

    function pickable() {
      const result = [];
      const {section} = parts.section;
      if (state.surface === "solid")
        result.push({body: body("surface", () => isopatch.meshBody(scene, parts.surface.mesh, state.scale)), isCut});
      if (state.interfaces)
        result.push({body: body("interfaces", () => isopatch.meshBody(scene, parts.interfaces.mesh, state.scale)), isCut});
      if (section && section.count > 0)
        result.push({body: body("section", () => isopatch.sectionBody(scene, section, state.scale)), isCut: () => false});
      return result;
    }

    const rayTo = (point) => ({origin: camera.position.toArray(),
                               direction: point.clone().sub(camera.position).normalize().toArray()});

    function pickAt(x, y) {
      const marker = state.markers ? markers.at(x, y) : null;
      if (marker) return choose(marker);
      const to = new THREE.Vector3((2 * x) / canvas.clientWidth - 1, 1 - (2 * y) / canvas.clientHeight, 0.5);
      const picked = isopatch.pick(scene, rayTo(to.unproject(camera)), pickable());
      markers.setPicked(picked && {point: picked.place, displacement: picked.fields.displacement || null});
      ask();
      tell("picked", picked && isopatch.valuesOfPick(scene, picked));
      return picked;
    }

    // A marker or warning by its name's button.
    function choose(place) {
      markers.setPicked(place);
      ask();
      tell("picked", isopatch.valuesOfPlace(scene, place));
      return place;
    }

    // What the colour bar takes from the picture: on its left or, across narrow ones, at its top.
    function insets() {
      if (isStale) apply();
      isStale = false;
      const isAcross = bar.offsetWidth > 0.8 * host.clientWidth;
      return isAcross ? [0, bar.offsetHeight / host.clientHeight] : [bar.offsetWidth / host.clientWidth, 0];
    }

    const orbit = isopatch.makeOrbit(canvas, camera, scene, {
      changed: ask, clicked: pickAt, insets,
      points: () => body("surface", () => isopatch.meshBody(scene, parts.surface.mesh, state.scale)).moved});

    function resize() {
      const [width, height] = [host.clientWidth, host.clientHeight];
      if (width === 0 || height === 0) return;
      const isFirst = renderer.domElement.dataset.sized === undefined;
      renderer.domElement.dataset.sized = "";
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      if (isFirst) orbit.fit();
      else orbit.place();
    }

    function setBackground() {
      const {backgroundColor, color} = getComputedStyle(host);
      renderer.setClearColor(new THREE.Color(backgroundColor), 1);
      shared.ink.value.set(color);
      ask();
    }

    const viewer = {
      scene, state, places, canvas, change, choose, pickAt, orbit, statisticsOf, project, pictures: 0, setBackground, draw,
      look: orbit.look, fit: orbit.fit,
      on: (event, f) => listeners[event].push(f)};
    state.range = isopatch.defaultRange(state.quantity, statisticsOf(state.quantity));
    isColourStale = isCutStale = true;
    new ResizeObserver(resize).observe(host);
    setBackground();
    return viewer;
  };
})(globalThis.isopatch);
