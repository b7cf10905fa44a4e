// The page of solids that were cut: the picture, what was done, the blocks.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const count = (number, one, several) => `${isopatch.withSeparators(number)} ${number === 1 ? one : several}`;

  // The picture of pieces with its controls; the viewer is null where the browser cannot draw.
  isopatch.blockStage = function (scene, prefix = "") {
    const host = element("div", {class: "viewer"});
    const viewer = isopatch.makeBlockViewer(host, scene);
    if (!viewer) {
      const text = "This browser cannot draw the blocks: WebGL is not available or switched off. The rest of the page is complete.";
      return {viewer, root: element("section", {class: "card"}, element("p", {class: "notice", id: prefix + "no-webgl"}, text))};
    }
    const views = element("div", {class: "toolbar", role: "group", "aria-label": "View"},
      Object.keys(isopatch.namedViews).map((name, i) => element(
        "button", {type: "button", class: "view-" + name, title: "key " + (i + 1), onclick: () => viewer.look(name)}, name)),
      element("button", {type: "button", class: "view-fit", title: "key 0", onclick: () => viewer.fit()}, "fit"));
    return {viewer, root: element("div", {class: "stage"},
      element("div", {class: "stage-main"}, host, views, element("p", {class: "how"},
        "Drag to turn, shift and drag to move, wheel or two fingers to zoom.")),
      isopatch.blockPanel(viewer, scene, prefix))};
  };

  function stage(scene) {
    const {viewer, root} = isopatch.blockStage(scene);
    isopatch.viewer = viewer;
    return root;
  }

  function closing(body) {
    if (body.t_joints_kept) return body.t_joints > 0 ? "kept" : "";
    if (body.by_tetrahedra) return "all parts divided into tetrahedra";
    return body.t_joints > 0 || body.further_cuts > 0 ? count(body.further_cuts, "further cut", "further cuts") : "";
  }

  function partsText(body) {
    if (body.seen_as) return body.seen_as.split(" ")[0];  // swept, turned
    return body.cuts || body.by_tetrahedra ? String(body.parts) : "as it is";
  }

  // Whatever was found or done before the cuts: what splines are, rounds that were removed, what it was seen as.
  function remarks(summary) {
    const lines = summary.bodies.map((body) => [body.name, [body.blends, body.seen_as].filter(Boolean).join("; ")])
      .filter(([, text]) => text !== "");
    return lines.length === 0 ? null : element("ul", {id: "remarks"}, lines.map(([name, text]) => element("li", {}, `${name}: ${text}`)));
  }

  // The difference is that of the blocks' volumes to the body's.
  function bodyRow(body) {
    if (body.error) return [body.name, isopatch.withUnit(body.volume, "m^3"), element("strong", {}, "given up"), "", "", "", "", "", ""];
    const difference = Math.abs(body.block_volume - body.volume) / body.volume;
    return [body.name, isopatch.withUnit(body.volume, "m^3"), String(body.cuts), partsText(body),
            String(body.t_joints), closing(body), isopatch.withSeparators(body.hexahedra),
            difference < 1e-12 ? "below 1e-12" : isopatch.general(difference, 2), isopatch.secondsText(body.seconds)];
  }

  const summaryTable = (summary) => isopatch.section("What was done", isopatch.table(
    ["body", "volume", "cuts", "parts", "T-joints", "closed by", "blocks", "volume of the blocks is off by", "time"],
    summary.bodies.map(bodyRow)), remarks(summary));

  function jointList(summary) {
    if (!summary.t_joints || summary.t_joints.length === 0) return null;
    return isopatch.section("T-joints that are left", element("ol", {id: "t-joints"}, summary.t_joints.map((text) => element("li", {}, text))));
  }

  function blockTable(scene) {
    const {viewer} = isopatch;
    const last = scene.stages.length - 1;
    const stage = scene.stages[last];
    const total = stage.pieces.reduce((sum, piece) => sum + piece.volume, 0);
    const show = (piece) => () => {
      viewer.change({stage: last});
      viewer.change({chosen: piece.index});
      viewer.canvas.scrollIntoView({block: "center"});
    };
    const rows = stage.pieces.map((piece) => [
      [element("span", {class: "swatch", style: "background: " + isopatch.pieceColour(stage, piece)}), piece.name],
      piece.file, isopatch.withUnit(piece.volume, "m^3"), `${isopatch.general((100 * piece.volume) / total, 3)} %`,
      piece.faces.join(", "),
      viewer ? element("button", {type: "button", class: "small", onclick: show(piece), "aria-label": "show " + piece.name}, "show") : ""]);
    return isopatch.section(count(stage.pieces.length, "block", "blocks"),
      isopatch.table(["block", "file", "volume", "share", "faces of the body", ""], rows));
  }

  function failures(summary, scene) {
    const failed = summary.bodies.filter((body) => body.error);
    if (failed.length === 0) return null;
    return element("section", {class: "card warnings"}, element("h2", {}, `Could not be cut: ${failed.map((body) => body.name).join(", ")}`),
                   failed.map((body) => element("p", {class: "message"}, body.error)),
                   element("p", {class: "how"}, isopatch.faultyPieces(scene) ? "Red is what could not be cut." : "The lines are where the parts meet in parts of sides."));
  }

  isopatch.buildBlocks = function (main, data) {
    const scene = isopatch.readBlocks(data.blocks);
    main.append(...[failures(data.summary, scene), stage(scene), summaryTable(data.summary), jointList(data.summary), blockTable(scene),
                    isopatch.studySection(data)].filter(Boolean));
  };
})(globalThis.isopatch);
