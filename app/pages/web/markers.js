// Places with a name (probes, largest values, warnings) as dots with labels over the picture.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const near = 12;  // pixels

  function addDot(layer, place) {
    const label = isopatch.element("span", {class: "marker-label"}, place.name);
    const dot = isopatch.element("span", {class: "marker marker-" + place.kind});
    layer.append(dot, label);
    return {dot, label, place};
  }

  // Labels beside their dots: to the right where there is room, pushed down where they would cover each other.
  function spread(shown, width) {
    const taken = [];
    for (const item of [...shown].sort((a, b) => a.y - b.y)) {
      item.width = item.width || item.label.offsetWidth;
      const x = item.x + 10 + item.width > width ? item.x - 10 - item.width : item.x + 10;
      let y = item.y - 8;
      for (const other of taken)
        if (x < other.x + other.width && other.x < x + item.width && Math.abs(y - other.y) < 17) y = other.y + 17;
      taken.push({x, y, width: item.width});
      item.label.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
    }
  }

  // place: {name, kind, point, displacement}; project(point) gives pixels or null outside of the picture,
  // isCut(point) tells what the section has cut away.
  isopatch.makeMarkers = function (layer, places) {
    const items = places.map((place) => addDot(layer, place));
    const picked = {dot: isopatch.element("span", {class: "marker marker-picked"}), place: null};
    layer.append(picked.dot);

    function put(item, scale, project, isCut) {
      const {point, displacement} = item.place;
      item.point = point.map((x, c) => x + scale * (displacement ? displacement[c] : 0));
      const pixel = isCut(point) ? null : project(item.point);
      item.dot.hidden = pixel === null;
      if (item.label) item.label.hidden = pixel === null;
      if (pixel === null) return false;
      [item.x, item.y] = pixel;
      item.dot.style.transform = `translate(${item.x.toFixed(1)}px, ${item.y.toFixed(1)}px)`;
      return true;
    }

    return {
      // Places that the section has cut away are left out.
      update(scale, project, isCut, width) {
        for (const {dot, label} of items) for (const part of [dot, label]) part.classList.remove("marker-behind");
        spread(items.filter((item) => put(item, scale, project, isCut)), width);
        picked.dot.hidden = picked.place === null || !put(picked, scale, project, () => false);
      },
      // Those that the part covers are drawn faintly; for when the picture has come to rest.
      markHidden(isHidden) {
        for (const {dot, label, point} of items) {
          const isBehind = !dot.hidden && isHidden(point);
          for (const part of [dot, label]) part.classList.toggle("marker-behind", isBehind);
        }
      },
      // Labels are the names with what text(place) says behind them.
      name(text) {
        for (const item of items) {
          const value = text(item.place);
          const label = item.place.name + (value ? " " + value : "");
          if (label === item.label.textContent) continue;
          item.label.textContent = label;
          item.width = null;
        }
      },
      setPicked(place) { picked.place = place; },
      at(x, y) {
        const distance = (item) => (item.dot.hidden ? Infinity : Math.hypot(item.x - x, item.y - y));
        const best = items.reduce((a, b) => (a && distance(a) <= distance(b) ? a : b), null);
        return best && distance(best) <= near ? best.place : null;
      }};
  };

  const kinds = {max_displacement: "largest displacement", max_von_mises: "largest von Mises stress"};

  // Markers and warnings with a place, in one list.
  isopatch.placesOf = function (scene) {
    const markers = scene.markers.filter((marker) => marker.point).map((marker) => (
      {...marker, name: kinds[marker.kind] && !marker.name ? kinds[marker.kind] : marker.name || marker.kind}));
    const warnings = scene.warnings.map((warning, i) => {
      const patch = scene.patches[warning.patch];
      const point = warning.point || (patch ? isopatch.centreOfPatch(scene, patch) : null);
      return point && {name: "warning " + (i + 1), kind: "warning", point, text: warning.text, warning: i};
    });
    return [...markers, ...warnings.filter(Boolean)];
  };
})(globalThis.isopatch);
