// The part in three dimensions. Everything that can be changed is in `state`; `change({...})` applies new values and asks
// for one picture. Nothing is drawn while nothing changes.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const fieldOfView = 24;  // degrees: little distortion

  // The renderer of a canvas, or null if the browser has no WebGL.
  isopatch.makeRenderer = function (canvas) {
    const settings = {antialias: true, alpha: false, preserveDrawingBuffer: true};
    const context = canvas.getContext("webgl2", settings) || canvas.getContext("webgl", settings);
    if (!context) return null;
    const renderer = new THREE.WebGLRenderer({canvas, context, ...settings});
    renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    return renderer;
  };

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
    const renderer = isopatch.makeRenderer(canvas);
    if (!renderer) return null;
    const layer = element("div", {class: "marker-layer", "aria-hidden": "true"});
    const bar = element("div", {class: "colour-bar"});
    const caption = element("div", {class: "caption"});
    host.append(canvas, layer, bar, caption);

    const shared = isopatch.makeUniforms();
    const parts = isopatch.makeParts(scene, shared);
    const camera = new THREE.PerspectiveCamera(fieldOfView, 1, 1, 10);
    const state = firstState(scene, options);
    const pointing = isopatch.makePointing(scene, parts, camera, canvas, state);
    const axes = isopatch.makeAxes(host);
    const places = isopatch.placesOf(scene);
    const markers = isopatch.makeMarkers(layer, places);
    const listeners = {changed: [], picked: []};
    const tell = (event, value) => listeners[event].forEach((f) => f(value));
    const statistics = new Map();
    let asked = false;
    let [isStale, isColourStale, isCutStale] = [true, true, true];
    let resting = null;

    function statisticsOf(quantity) {
      if (!statistics.has(quantity.id)) statistics.set(quantity.id, isopatch.statistics(quantity.values()));
      return statistics.get(quantity.id);
    }

    function apply() {
      if (isColourStale) parts.colour(state.quantity);
      if (isCutStale) {
        parts.cut(state);
        pointing.forget("section");
      }
      isColourStale = isCutStale = isStale = false;
      shared.scale.value = state.scale;
      shared.bands.value = state.bands;
      shared.range.value.set(...state.range);
      parts.setVisibility(state);
      layer.hidden = !state.markers;
      markers.name((place) => isopatch.valueOfPlace(place, state.quantity));
      isopatch.drawColourBar(bar, scene, state.quantity, state.range, state.bands, statisticsOf(state.quantity));
      caption.textContent = scene.isSolved ? "deformation \u00d7 " + isopatch.general(state.scale, 3) : "";
    }

    function draw() {
      asked = false;
      if (isStale) apply();
      renderer.render(parts.world, camera);
      axes.update(camera);
      markers.update(state.scale, pointing.project, parts.isCut, canvas.clientWidth);
      viewer.pictures += 1;
      clearTimeout(resting);
      resting = setTimeout(() => markers.markHidden(pointing.isHidden), 150);
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
      if (state.scale !== old.scale) pointing.forget();
      if (["axis", "isFlipped", "at"].some((key) => state[key] !== old[key])) isCutStale = true;
      isStale = true;
      ask();
      tell("changed", state);
    }

    function pickAt(x, y) {
      const marker = state.markers ? markers.at(x, y) : null;
      if (marker) return choose(marker);
      const picked = pointing.pickAt(x, y);
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
      const isAcross = bar.offsetWidth > 0.8 * host.clientWidth;
      return isAcross ? [0, bar.offsetHeight / host.clientHeight] : [bar.offsetWidth / host.clientWidth, 0];
    }

    const orbit = isopatch.makeOrbit(canvas, camera, scene, {
      changed: ask, clicked: pickAt, insets, points: pointing.surfacePoints});

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

    // On paper the part stands on white.
    function printed() {
      renderer.setClearColor(new THREE.Color("white"), 1);
      draw();
    }

    const viewer = {
      scene, state, places, canvas, change, choose, pickAt, orbit, statisticsOf, project: pointing.project, pictures: 0,
      setBackground, draw, look: orbit.look, fit: orbit.fit,
      on: (event, f) => listeners[event].push(f)};
    state.range = isopatch.defaultRange(state.quantity, statisticsOf(state.quantity));
    canvas.addEventListener("webglcontextrestored", ask);
    window.addEventListener("beforeprint", printed);
    window.addEventListener("afterprint", setBackground);
    new ResizeObserver(resize).observe(host);
    setBackground();
    return viewer;
  };
})(globalThis.isopatch);
