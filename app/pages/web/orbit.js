// The camera on a sphere about a target: mouse, touch (one finger turns, two move and zoom) and keys.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const degrees = Math.PI / 180;
  // Azimuth and elevation of the camera.
  isopatch.namedViews = {
    front: [-90, 0], back: [90, 0], left: [180, 0], right: [0, 0], top: [-90, 90], bottom: [-90, -90],
    isometric: [-60, 30]};

  function frame(state) {
    const [ca, sa] = [Math.cos(state.azimuth), Math.sin(state.azimuth)];
    const [ce, se] = [Math.cos(state.elevation), Math.sin(state.elevation)];
    return {out: new THREE.Vector3(ce * ca, ce * sa, se), up: new THREE.Vector3(-se * ca, -se * sa, ce),
            right: new THREE.Vector3(-sa, ca, 0)};
  }

  // Target and distance from which all points (three numbers each) are just seen. With x to the right, z towards the
  // camera and t the tangent of half the angle, a camera at x = c, z = d sees a point if |x - c| <= t (d - z).
  function fitting(points, centre, state, tangents) {
    const {out, up, right} = frame(state);
    const [across, upwards, depth] = [right, up, out].map((axis) => axis.toArray());
    const along = (axis, i) => (axis[0] * (points[i] - centre[0]) + axis[1] * (points[i + 1] - centre[1])
                                + axis[2] * (points[i + 2] - centre[2]));
    const bounds = [[across, tangents[0]], [upwards, tangents[1]], [depth, 0]].map(([axis, t]) => {
      let [low, high] = [Infinity, -Infinity];
      for (let i = 0; i < points.length; i += 3) {
        const [x, z] = [along(axis, i), t * along(depth, i)];
        low = Math.min(low, x - z);
        high = Math.max(high, x + z);
      }
      return {middle: (low + high) / 2, half: (high - low) / 2};
    });
    const [horizontal, vertical, forwards] = bounds;
    const target = new THREE.Vector3(...centre).addScaledVector(right, horizontal.middle)
      .addScaledVector(up, vertical.middle).addScaledVector(out, forwards.middle);
    const distance = Math.max(horizontal.half / tangents[0], vertical.half / tangents[1]);
    return {target, distance: distance - forwards.middle};
  }

  // handlers: changed() after every movement, clicked(x, y) in pixels of the canvas, points() that a
  // fit must show, insets() the parts of the picture at the left and at the top that it must leave free.
  isopatch.makeOrbit = function (canvas, camera, scene, handlers) {
    const [azimuth, elevation] = isopatch.namedViews.isometric;
    const state = {azimuth: azimuth * degrees, elevation: elevation * degrees, distance: 1,
                   target: new THREE.Vector3(...scene.centre), insets: [0, 0]};

    function place() {
      const {out, up} = frame(state);
      camera.position.copy(state.target).addScaledVector(out, state.distance);
      camera.up.copy(up);
      camera.lookAt(state.target);
      camera.near = Math.max(state.distance - 1.2 * scene.size, 0.002 * scene.size);
      camera.far = state.distance + 1.2 * scene.size;
      const {aspect} = camera;
      camera.setViewOffset(aspect, 1, (-state.insets[0] / 2) * aspect, -state.insets[1] / 2, aspect, 1);
      camera.updateMatrixWorld();
      handlers.changed();
    }

    function turn(dx, dy) {
      state.azimuth -= dx;
      state.elevation = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, state.elevation + dy));
      place();
    }

    function zoom(factor) {
      state.distance = Math.max(0.01 * scene.size, Math.min(20 * scene.size, state.distance * factor));
      place();
    }

    // By parts of the canvas' height.
    function pan(dx, dy) {
      const {up, right} = frame(state);
      const height = 2 * state.distance * Math.tan((camera.fov / 2) * degrees);
      state.target.addScaledVector(right, -dx * height).addScaledVector(up, dy * height);
      place();
    }

    function fit() {
      const vertical = Math.tan((camera.fov / 2) * degrees) * 0.9;
      const [left, top] = state.insets = handlers.insets();
      const tangents = [vertical * camera.aspect * (1 - left), vertical * (1 - top)];
      const found = fitting(handlers.points(), scene.centre, state, tangents);
      state.target.copy(found.target);
      state.distance = found.distance;
      place();
    }

    function look(name) {
      [state.azimuth, state.elevation] = isopatch.namedViews[name].map((angle) => angle * degrees);
      fit();
    }

    const orbit = {state, place, turn, zoom, pan, fit, look};
    listen(canvas, orbit, handlers);
    return orbit;
  };

  function listen(canvas, orbit, handlers) {
    const pointers = new Map();
    let travelled = 0;
    const middle = () => {
      const all = [...pointers.values()];
      const sum = all.reduce((a, p) => [a[0] + p.x / all.length, a[1] + p.y / all.length], [0, 0]);
      const spread = all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0;
      return {x: sum[0], y: sum[1], spread};
    };
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      if (pointers.size === 0) travelled = 0;
      pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
      if (pointers.size > 1) travelled = Infinity;
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!pointers.has(event.pointerId)) return;
      const before = middle();
      pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
      const after = middle();
      const [dx, dy] = [after.x - before.x, after.y - before.y];
      travelled += Math.hypot(dx, dy);
      if (travelled < 4) return;
      const height = canvas.clientHeight;
      const isPan = pointers.size > 1 || event.shiftKey || (event.buttons & 6) !== 0;
      if (isPan) orbit.pan(dx / height, dy / height);
      else orbit.turn((dx / height) * 4, (dy / height) * 4);
      if (before.spread > 0 && after.spread > 0) orbit.zoom(before.spread / after.spread);
    });
    const lift = (event) => {
      const isClick = pointers.size === 1 && travelled < 4 && event.type === "pointerup" && event.button === 0;
      pointers.delete(event.pointerId);
      if (!isClick) return;
      const box = canvas.getBoundingClientRect();
      handlers.clicked(event.clientX - box.left, event.clientY - box.top);
    };
    canvas.addEventListener("pointerup", lift);
    canvas.addEventListener("pointercancel", lift);
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      orbit.zoom(Math.exp(Math.max(-200, Math.min(200, event.deltaY * lines)) * 0.0015));
    }, {passive: false});
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !pressed(orbit, event)) return;
      event.preventDefault();
    });
  }

  // Arrows turn, with shift they move; + and - zoom; 1 to 7 are the named views, 0 fits the part into the picture.
  function pressed(orbit, event) {
    const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) orbit.pan(arrow[0] * 0.05, arrow[1] * 0.05);
    else if (arrow) orbit.turn(arrow[0] * 10 * degrees, arrow[1] * 10 * degrees);
    else if (event.key === "+" || event.key === "=") orbit.zoom(0.85);
    else if (event.key === "-") orbit.zoom(1 / 0.85);
    else if (event.key === "0") orbit.fit();
    else if (/^[1-7]$/.test(event.key)) orbit.look(Object.keys(isopatch.namedViews)[Number(event.key) - 1]);
    else return false;
    return true;
  }
})(globalThis.isopatch);
