// The canvas that a viewer of solids draws on: its camera, named places over it, its size, its colours on screen and paper.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const fieldOfView = 24;  // degrees

  isopatch.faultyColour = "#d3222a";

  isopatch.geometryOf = function (points, index) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
    if (index) geometry.setIndex(index);
    return geometry;
  };

  // `drawn`: {what, world, ink, places, points, clicked}. `ink` is the material of lines, drawn in the colour of the text;
  // points() gives what has to fit into the picture; clicked(x, y) is told pixels. Null if the browser has no WebGL.
  isopatch.makeSolidCanvas = function (host, scene, drawn) {
    const canvas = isopatch.element("canvas", {tabindex: "0", role: "img", "aria-label": drawn.what +
      " in three dimensions. Arrow keys turn them, shift and arrows move them, plus and minus zoom, 1 to 7 choose a view, 0 fits them in."});
    const renderer = isopatch.makeRenderer(canvas);
    if (!renderer) return null;
    const layer = isopatch.element("div", {class: "marker-layer", "aria-hidden": "true"});
    host.append(canvas, layer);
    const camera = new THREE.PerspectiveCamera(fieldOfView, 1, 1, 10);
    const axes = isopatch.makeAxes(host);
    const markers = isopatch.makeMarkers(layer, drawn.places);
    let asked = false;

    function project(point) {
      const v = new THREE.Vector3(...point).project(camera);
      if (Math.abs(v.x) > 1 || Math.abs(v.y) > 1 || Math.abs(v.z) > 1) return null;
      return [((v.x + 1) / 2) * canvas.clientWidth, ((1 - v.y) / 2) * canvas.clientHeight];
    }
    function draw() {
      asked = false;
      renderer.render(drawn.world, camera);
      axes.update(camera);
      markers.update(0, project, () => false, canvas.clientWidth);
    }
    function ask() {
      if (asked) return;
      asked = true;
      requestAnimationFrame(draw);
    }
    const orbit = isopatch.makeOrbit(canvas, camera, scene, {
      changed: ask, insets: () => [0, 0], points: drawn.points, clicked: drawn.clicked});

    function resize() {
      const [width, height] = [host.clientWidth, host.clientHeight];
      if (width === 0 || height === 0) return;
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      orbit.fit();
    }
    function setBackground() {
      const {backgroundColor, color} = getComputedStyle(host);
      renderer.setClearColor(new THREE.Color(backgroundColor), 1);
      drawn.ink.color.set(color);
      ask();
    }
    function printed() {
      renderer.setClearColor(new THREE.Color("white"), 1);
      drawn.ink.color.set("black");
      draw();
    }
    canvas.addEventListener("webglcontextrestored", ask);
    window.addEventListener("beforeprint", printed);
    window.addEventListener("afterprint", setBackground);
    new ResizeObserver(resize).observe(host);
    setBackground();
    return {canvas, camera, markers, orbit, ask, draw, setBackground, project, look: orbit.look, fit: orbit.fit};
  };
})(globalThis.isopatch);
