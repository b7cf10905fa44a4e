// The controls beside the picture of blocks, and what is known of the block that was chosen.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const group = (title, ...children) => element(
    "details", {open: true, class: "group"}, element("summary", {}, title), children);

  function stageChoice(viewer, scene) {
    if (scene.stages.length < 2) return null;
    const count = (stage) => `${stage.name} (${stage.pieces.length})`;
    return scene.stages.map((stage, i) => {
      const choice = element("input", {type: "radio", name: "stage", id: "stage-" + i, onchange: () => viewer.change({stage: i})});
      const follow = (state) => (choice.checked = state.stage === i);
      viewer.on(follow);
      follow(viewer.state);
      return element("label", {class: "check choice"}, choice, " " + count(stage));
    });
  }

  function check(viewer, text, key, swatch) {
    const box = element("input", {type: "checkbox", id: "show-" + key, onchange: () => viewer.change({[key]: box.checked})});
    viewer.on((state) => (box.checked = state[key]));
    box.checked = viewer.state[key];
    return element("label", {class: "check choice"}, box, " ", swatch ? element("span", {class: "swatch", style: "background: " + swatch}) : null, text);
  }

  function apartSlider(viewer) {
    const slider = element("input", {type: "range", id: "apart", min: 0, max: 1.5, step: 0.01, "aria-label": "How far blocks are apart",
                                     oninput: () => viewer.change({apart: Number(slider.value)})});
    const follow = (state) => (slider.value = state.apart);
    viewer.on(follow);
    follow(viewer.state);
    return element("label", {class: "row"}, element("span", {}, "apart"), slider);
  }

  // Follows the choice; faces: those of the solid that the block has parts of.
  function chosenBlock(viewer, scene) {
    const host = element("div", {class: "chosen", id: "picked"});
    function follow(state) {
      const stage = scene.stages[state.stage];
      const piece = state.chosen === null ? null : stage.pieces[state.chosen];
      host.replaceChildren(...(piece ? [
        element("h3", {}, piece.name), element("dl", {}, [
          ["body", piece.body], ["volume", isopatch.withUnit(piece.volume, "m^3")], ["file", piece.file],
          ["faces of the body", piece.faces.join(", ") || "none, it lies inside"]].filter(([, value]) => value).map(([name, value]) => (
            element("div", {}, element("dt", {}, name), element("dd", {}, value)))))]
        : [element("p", {class: "how"}, "Click a block to see it alone with its volume and faces; click it again to go back.")]));
    }
    viewer.on(follow);
    follow(viewer.state);
    return host;
  }

  isopatch.blockPanel = function (viewer, scene) {
    const lines = scene.stages.some((stage) => stage.lines.length > 0);
    return element("div", {class: "panel"},
      scene.stages.some((stage) => stage.pieces.length > 1) ? group("Explode", apartSlider(viewer)) : null,
      scene.stages.length > 1 ? group("Show", stageChoice(viewer, scene)) : null,
      group("Lines", check(viewer, "edges", "edges"), lines ? check(viewer, scene.lines_name, "lines", viewer.lineColour) : null),
      group("Block", chosenBlock(viewer, scene)));
  };
})(globalThis.isopatch);
