// How a file became patches: triangles with the faces that they were joined to, the solid, its hexahedra.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);

  function stageRow(stage) {
    const how = stage.kept ? `as before, from ${stage.made}` : "made in this run";
    return [stage.name, how, isopatch.secondsText(stage.seconds), stage.file];
  }

  const stageTable = (stages) => (stages.length === 0 ? null : isopatch.table(
    ["stage", "", "time to make it", "file"], stages.map(stageRow)));

  function content(data) {
    const stages = (data.summary || {}).stages || [];
    const scene = data.blocks && data.blocks.stages.length ? isopatch.readBlocks(data.blocks) : null;
    const drawn = scene ? isopatch.blockStage(scene, "stages-") : null;
    if (drawn) isopatch.stageViewer = drawn.viewer;
    return [drawn && drawn.root, stageTable(stages)].filter(Boolean);
  }

  // Of a report; nothing where the model had patches already.
  isopatch.stagesSection = function (data) {
    const parts = content(data);
    return parts.length === 0 ? null : isopatch.section("From the file to patches", ...parts);
  };

  // The page of a run that ended before the solution, or that failed on its way.
  isopatch.buildStages = function (main, data) {
    const {error} = data.summary;
    const parts = content(data);
    isopatch.viewer = isopatch.stageViewer;
    isopatch.stageViewer = null;
    main.append(...[
      error ? element("section", {class: "card warnings"}, element("h2", {}, "No solid could be made of the triangles"),
                      element("p", {class: "message"}, error),
                      element("p", {class: "how"}, "Red lies on no plane, cylinder, cone, sphere or torus; lines are edges that keep the triangles from bounding a solid.")) : null,
      ...parts, isopatch.studySection(data)].filter(Boolean));
  };
})(globalThis.isopatch);
