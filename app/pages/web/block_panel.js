// The controls beside the picture of blocks, and what is known of the block that was chosen.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const group = (title, ...children) => element(
    "details", {open: true, class: "group"}, element("summary", {}, title), children);

  function stageChoice(viewer, scene, prefix) {
    if (scene.stages.length < 2) return null;
    const count = (stage) => `${stage.name} (${stage.pieces.length})`;
    return scene.stages.map((stage, i) => {
      const choice = element("input", {type: "radio", name: prefix + "stage", id: prefix + "stage-" + i, onchange: () => viewer.change({stage: i})});
      const follow = (state) => (choice.checked = state.stage === i);
      viewer.on(follow);
      follow(viewer.state);
      return element("label", {class: "check choice"}, choice, " " + count(stage));
    });
  }

  function check(viewer, prefix, text, key, swatch) {
    const box = element("input", {type: "checkbox", id: prefix + "show-" + key, onchange: () => viewer.change({[key]: box.checked})});
    viewer.on((state) => (box.checked = state[key]));
    box.checked = viewer.state[key];
    return element("label", {class: "check choice"}, box, " ", swatch ? element("span", {class: "swatch", style: "background: " + swatch}) : null, text);
  }

  function apartSlider(viewer, prefix) {
    const slider = element("input", {type: "range", id: prefix + "apart", min: 0, max: 1.5, step: 0.01, "aria-label": "How far pieces are apart",
                                     oninput: () => viewer.change({apart: Number(slider.value)})});
    const follow = (state) => (slider.value = state.apart);
    viewer.on(follow);
    follow(viewer.state);
    return element("label", {class: "row"}, element("span", {}, "apart"), slider);
  }

  // Follows the choice; faces: those of the solid that the block has parts of.
  function chosenBlock(viewer, scene, prefix) {
    const host = element("div", {class: "chosen", id: prefix + "picked"});
    function follow(state) {
      const stage = scene.stages[state.stage];
      const piece = state.chosen === null ? null : stage.pieces[state.chosen];
      host.replaceChildren(...(piece ? [
        element("h3", {}, piece.name), element("dl", {}, [
          ["body", piece.body], ["volume", piece.volume ? isopatch.withUnit(piece.volume, "m^3") : ""], ["file", piece.file],
          ["", piece.remark || ""],
          ["faces of the body", piece.volume && piece.body ? piece.faces.join(", ") || "none, it lies inside" : ""]].filter(([, value]) => value).map(([name, value]) => (
            element("div", {}, element("dt", {}, name), element("dd", {}, value)))))]
        : [element("p", {class: "how"}, "Click a piece to see it alone with what is known of it; click it again to go back.")]));
    }
    viewer.on(follow);
    follow(viewer.state);
    return host;
  }

  // prefix: of the identifiers, where a page has other controls besides.
  isopatch.blockPanel = function (viewer, scene, prefix) {
    const lines = scene.stages.some((stage) => stage.lines.length > 0);
    return element("div", {class: "panel"},
      scene.stages.some((stage) => stage.pieces.length > 1) ? group("Explode", apartSlider(viewer, prefix)) : null,
      scene.stages.length > 1 ? group("Show", stageChoice(viewer, scene, prefix)) : null,
      group("Lines", check(viewer, prefix, "edges", "edges"), lines ? check(viewer, prefix, scene.lines_name, "lines", viewer.lineColour) : null),
      group("Piece", chosenBlock(viewer, scene, prefix)));
  };
})(globalThis.isopatch);
