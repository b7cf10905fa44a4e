// The directions of the coordinate axes, in a corner of the picture.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const length = 26;  // pixels of an axis across the view
  const half = 40;    // of the drawing
  const svg = (name, attributes) => {
    const result = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
    return result;
  };

  // {update(camera)}: adds a drawing to `host`. Axes that point towards the viewer lie over the others.
  isopatch.makeAxes = function (host) {
    const picture = svg("svg", {class: "axes", viewBox: `${-half} ${-half} ${2 * half} ${2 * half}`, "aria-hidden": "true"});
    const axes = ["x", "y", "z"].map((name, i) => {
      const line = svg("line", {x1: 0, y1: 0});
      const label = svg("text", {"text-anchor": "middle", "dominant-baseline": "central"});
      label.textContent = name;
      const group = svg("g", {class: "axis-" + name});
      group.append(line, label);
      picture.append(group);
      return {group, line, label, direction: new THREE.Vector3(...[0, 1, 2].map((c) => Number(c === i)))};
    });
    host.append(picture);
    return {
      update(camera) {
        camera.updateMatrixWorld();
        for (const axis of axes) {
          axis.view = axis.direction.clone().transformDirection(camera.matrixWorldInverse);
          const [x, y] = [axis.view.x, -axis.view.y];
          for (const [key, value] of [["x2", x], ["y2", y]]) axis.line.setAttribute(key, (length * value).toFixed(1));
          for (const [key, value] of [["x", x], ["y", y]]) axis.label.setAttribute(key, (1.35 * length * value).toFixed(1));
        }
        picture.append(...[...axes].sort((a, b) => a.view.z - b.view.z).map((axis) => axis.group));
      }};
  };
})(globalThis.isopatch);
