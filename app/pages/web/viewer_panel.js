// The controls beside the picture: form elements that call viewer.change() and follow its state.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const button = (text, onclick, attributes) => element("button", {type: "button", onclick, ...attributes}, text);
  const group = (title, ...children) => element(
    "details", {open: true, class: "group"}, element("summary", {}, title), children);
  const labelled = (text, control) => element("label", {class: "row"}, element("span", {}, text), control);
  const number = (attributes) => element("input", {type: "number", step: "any", ...attributes});

  function check(viewer, text, key) {
    const box = element("input", {type: "checkbox", id: "show-" + key, onchange: () => viewer.change({[key]: box.checked})});
    viewer.on("changed", (state) => (box.checked = state[key]));
    box.checked = viewer.state[key];
    return element("label", {class: "check"}, box, " " + text);
  }

  function select(id, options, value, changed) {
    const result = element("select", {id, onchange: () => changed(result.value)},
                           options.map(([key, text]) => element("option", {value: key}, text)));
    result.value = value;
    return result;
  }

  function colourGroup(viewer) {
    const {scene, state} = viewer;
    const quantity = select("quantity", scene.quantities.map((q) => [q.id, q.label]), state.quantity.id, (id) => (
      viewer.change({quantity: scene.quantities.find((q) => q.id === id)})));
    const bands = select("bands", [[0, "smooth"], [8, "8 bands"], [12, "12 bands"], [20, "20 bands"]], 0,
                         (text) => viewer.change({bands: Number(text)}));
    const [low, high] = ["range-low", "range-high"].map((id) => number({id, onchange: typed}));
    function typed() {
      const range = [low, high].map((input) => Number(input.value) / viewer.state.quantity.factor);
      const isRight = low.value !== "" && high.value !== "" && range[0] < range[1];
      for (const input of [low, high]) input.setCustomValidity(isRight ? "" : "the minimum must be below the maximum");
      if (isRight) viewer.change({range});
      else low.reportValidity();
    }
    const set = (range) => () => {
      const found = viewer.statisticsOf(viewer.state.quantity);
      if (found && range(found)[1] > range(found)[0]) viewer.change({range: range(found)});
    };
    const rangeRows = element("div", {},
      element("div", {class: "pair"}, labelled("from", low), labelled("to", high)),
      element("div", {class: "buttons"}, button("full range", set((s) => [s.min, s.max]), {id: "range-full"}),
              button("1\u201399 %", set((s) => [s.percentile(1), s.percentile(99)]), {id: "range-percentile"})),
      labelled("steps", bands));
    function follow(now) {
      quantity.value = now.quantity.id;
      rangeRows.hidden = now.quantity.isCategorical;
      const text = (x) => isopatch.general(x * now.quantity.factor, 5);
      [low.value, high.value] = now.range.map(text);
      for (const input of [low, high]) input.setCustomValidity("");
    }
    viewer.on("changed", follow);
    follow(state);
    return group("Colour", labelled("by", quantity), rangeRows);
  }

  function playButton(viewer, largest) {
    let started = null;
    const step = (time) => {
      if (started === null) return;
      viewer.change({scale: largest * 0.5 * (1 - Math.cos((time - started) / 700))});
      requestAnimationFrame(step);
    };
    const result = button("\u25b6 play", () => {
      started = started === null ? performance.now() : null;
      result.textContent = started === null ? "\u25b6 play" : "\u25a0 stop";
      if (started !== null) requestAnimationFrame(step);
    }, {id: "play"});
    return window.matchMedia("(prefers-reduced-motion: reduce)").matches ? null : result;
  }

  function deformationGroup(viewer) {
    if (!viewer.scene.isSolved || !(viewer.scene.maxDisplacement > 0)) return null;
    const {largest, first} = isopatch.scalesOf(viewer.scene);
    const slider = element("input", {type: "range", id: "deformation", min: 0, max: largest, step: largest / 200,
                                     oninput: () => viewer.change({scale: Number(slider.value)})});
    const exact = number({id: "deformation-exact", min: 0, onchange: () => {
      if (exact.value !== "" && Number(exact.value) >= 0) viewer.change({scale: Number(exact.value)});
    }});
    const follow = (state) => {
      slider.value = state.scale;
      slider.setAttribute("aria-valuetext", isopatch.general(state.scale, 3) + " times");
      exact.value = isopatch.general(state.scale, 4);
    };
    viewer.on("changed", follow);
    follow(viewer.state);
    const to = (scale) => () => viewer.change({scale});
    return group("Deformation", labelled("scale", slider), labelled("times", exact),
                 element("div", {class: "buttons"}, button("none", to(0)), button("true (\u00d7 1)", to(1), {id: "true-scale"}),
                         button("automatic", to(first)), playButton(viewer, largest)));
  }

  function legendOf(title, list, colour) {
    if (list.length === 0) return null;
    return element("li", {}, element("span", {class: "swatch", style: "background:" + colour}),
                   title + ": " + list.map((item) => item.name).join(", "));
  }

  function showGroup(viewer) {
    const {scene, state} = viewer;
    const hasInterfaces = scene.patches.some((patch) => patch.faces.some((face) => face.kind === "interface"));
    const surface = select("surface", [["solid", "solid"], ["translucent", "translucent"], ["hidden", "hidden"]],
                           state.surface, (value) => viewer.change({surface: value}));
    viewer.on("changed", (now) => (surface.value = now.surface));
    return group("Show",
      element("div", {class: "checks"},
        check(viewer, "patch edges", "patchEdges"), check(viewer, "element edges", "elementEdges"),
        scene.supports.length ? check(viewer, "supports", "supports") : null,
        scene.loads.length ? check(viewer, "loads", "loads") : null,
        viewer.places.length ? check(viewer, "marked places", "markers") : null,
        hasInterfaces ? check(viewer, "interfaces", "interfaces") : null),
      labelled("outer surface", surface),
      element("ul", {class: "legend"}, legendOf("supports", scene.supports, isopatch.supportColour),
              legendOf("loads", scene.loads, isopatch.loadColour)));
  }

  function sectionGroup(viewer) {
    const axis = select("section-axis", [[-1, "none"], [0, "across x"], [1, "across y"], [2, "across z"]], -1,
                        (text) => viewer.change({axis: Number(text)}));
    const slider = element("input", {type: "range", id: "section-at", min: 0, max: 1, step: 0.002,
                                     oninput: () => viewer.change({at: Number(slider.value)})});
    const {length, box} = viewer.scene;
    const rows = element("div", {}, labelled("at", slider), check(viewer, "keep the other side", "isFlipped"));
    const text = element("output", {for: "section-at"});
    slider.after(text);
    const follow = (state) => {
      rows.hidden = state.axis < 0;
      axis.value = state.axis;
      slider.value = state.at;
      if (state.axis < 0) return;
      const at = box.min[state.axis] + state.at * (box.max[state.axis] - box.min[state.axis]);
      text.textContent = isopatch.general(at * length.factor, 4) + " " + length.unit;
      slider.setAttribute("aria-valuetext", text.textContent);
    };
    viewer.on("changed", follow);
    follow(viewer.state);
    return group("Section", labelled("plane", axis), rows);
  }

  function viewBar(viewer) {
    const names = Object.keys(isopatch.namedViews);
    return element("div", {class: "toolbar", role: "group", "aria-label": "View"},
      names.map((name, i) => button(name, () => viewer.look(name), {id: "view-" + name, title: "key " + (i + 1)})),
      button("fit", () => viewer.fit(), {id: "view-fit", title: "key 0"}),
      button("save picture", () => save(viewer), {id: "save"}));
  }

  function save(viewer) {
    viewer.draw();
    element("a", {href: viewer.canvas.toDataURL("image/png"), download: "isopatch.png"}).click();
  }

  function placeBar(viewer) {
    if (viewer.places.length === 0) return null;
    return element("div", {class: "toolbar", role: "group", "aria-label": "Values at marked places"}, "Values at:",
      viewer.places.map((place) => button(place.name, () => viewer.choose(place), {class: "place"})));
  }

  isopatch.makeViewerPanel = function (viewer) {
    return element("form", {class: "panel", "aria-label": "Picture", onsubmit: (event) => event.preventDefault()},
      colourGroup(viewer), deformationGroup(viewer), sectionGroup(viewer), showGroup(viewer));
  };

  // The picture with its controls and the values of the last click.
  isopatch.makeViewerSection = function (scene, options) {
    const host = element("div", {class: "viewer"});
    const values = element("div", {class: "values", "aria-live": "polite", id: "picked"},
      element("p", {class: "how"}, "Click on the part for the values there. Drag to turn, shift and drag to move, wheel or two fingers to zoom."));
    const viewer = isopatch.makeViewer(host, scene, options);
    if (!viewer) {
      const text = "This browser cannot draw the part: WebGL is not available or switched off. The rest of the page is complete.";
      return {root: element("section", {class: "card"}, element("p", {class: "notice", id: "no-webgl"}, text)), viewer: null};
    }
    viewer.on("picked", (found) => (found ? isopatch.showValues(values, found) : values.replaceChildren(
      element("p", {class: "how"}, "Nothing there: the click missed the part. Of a translucent part only interfaces and the section show values."))));
    const root = element("section", {class: "stage"}, element("div", {class: "stage-main"}, host, viewBar(viewer),
                                                                         placeBar(viewer), values),
                         isopatch.makeViewerPanel(viewer));
    return {root, viewer};
  };
})(globalThis.isopatch);
