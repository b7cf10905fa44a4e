// The page of solids that could not be made patches: the message, the picture, what is wrong by name, the solids.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);

  function stage(data, scene) {
    const host = element("div", {class: "viewer"});
    const viewer = isopatch.makeFaultViewer(host, scene);
    isopatch.viewer = viewer;
    if (!viewer) {
      const text = "This browser cannot draw the solids: WebGL is not available or switched off. The rest of the page is complete.";
      return element("section", {class: "card"}, element("p", {class: "notice", id: "no-webgl"}, text));
    }
    const views = element("div", {class: "toolbar", role: "group", "aria-label": "View"},
      Object.keys(isopatch.namedViews).map((name, i) => element(
        "button", {type: "button", id: "view-" + name, title: "key " + (i + 1), onclick: () => viewer.look(name)}, name)),
      element("button", {type: "button", id: "view-fit", title: "key 0", onclick: () => viewer.fit()}, "fit"));
    return element("div", {class: "stage-main"}, host, views, element("p", {class: "how"},
      "Red is what the message is about. Drag to turn, shift and drag to move, wheel or two fingers to zoom."));
  }

  function entities(scene) {
    const {viewer} = isopatch;
    const rows = isopatch.faultPlaces(scene).map((place) => {
      const show = () => {
        viewer.choose(place);
        viewer.canvas.scrollIntoView({block: "center"});
      };
      return [place.name, isopatch.placeWithUnit(place.point, scene.size),
              viewer ? element("button", {type: "button", class: "small", onclick: show, "aria-label": "show " + place.name}, "show") : ""];
    });
    for (const face of scene.faces)
      if (face.is_faulty && face.points.length === 0) rows.push([face.name, face.remark || "drawn by its edges only", ""]);
    return rows.length ? isopatch.section("What is wrong", isopatch.table(["face, edge or vertex", "at", ""], rows)) : null;
  }

  function solids(summary) {
    const rows = (summary.solids || []).map((solid) => (
      [solid.name, solid.file, String(solid.faces), String(solid.edges), String(solid.vertices), solid.state]));
    return isopatch.section("Solids", isopatch.table(["block", "file", "faces", "edges", "vertices", "boundary"], rows));
  }

  isopatch.buildFaults = function (main, data) {
    const scene = isopatch.readFaults(data.faults);
    main.append(element("section", {class: "card warnings"}, element("h2", {}, "The solids could not be made patches"),
                        element("p", {id: "message"}, data.summary.message)));
    if (scene.points.length > 0) main.append(stage(data, scene));
    main.append(...[entities(scene), solids(data.summary), isopatch.studySection(data)].filter(Boolean));
  };
})(globalThis.isopatch);
