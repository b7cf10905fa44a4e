// Reads the page's data and builds the page.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const builders = {report: "buildReport", model: "buildReport", compare: "buildCompare", verification: "buildVerification",
                    faults: "buildFaults", blocks: "buildBlocks", stages: "buildStages"};
  const titles = {report: "Report", model: "Model", compare: "Comparison of the couplings", verification: "Checked", faults: "Bad input",
                  blocks: "Solids cut into blocks", stages: "From the file to patches"};

  // Light, dark, or as the system has it.
  function themeButton(changed) {
    const isDark = () => {
      const chosen = document.documentElement.dataset.theme;
      return chosen ? chosen === "dark" : window.matchMedia("(prefers-color-scheme: dark)").matches;
    };
    const button = isopatch.element("button", {type: "button", id: "theme", class: "small", onclick: () => {
      document.documentElement.dataset.theme = isDark() ? "light" : "dark";
      follow();
    }});
    const follow = () => {
      button.textContent = isDark() ? "light" : "dark";
      button.setAttribute("aria-label", "Change to " + button.textContent + " colours");
      changed();
    };
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", follow);
    button.follow = follow;
    return button;
  }

  // Of a study with load cases: the pages of all of them.
  function caseLinks(data) {
    const links = data.cases || [];
    if (links.length === 0) return data.summary && data.summary.case ? isopatch.element("p", {}, "load case " + data.summary.case) : null;
    return isopatch.element("nav", {class: "cases", "aria-label": "Load cases"}, "load case", links.map((link) => isopatch.element(
      "a", {href: link.address, "aria-current": link.current ? "page" : null}, link.name)));
  }

  function firstLook(data, scene) {
    const traction = scene.quantities.find((quantity) => quantity.on === "interfaces");
    if (data.kind === "compare" && traction) return {quantity: traction.id, interfaces: true, surface: "translucent"};
    if (data.kind === "report" && "von_mises" in scene.blocks) return {quantity: "von_mises"};
    return {};
  }

  isopatch.start = function () {
    const data = JSON.parse(document.getElementById("isopatch-data").textContent);
    const main = document.getElementById("page-main");
    const scene = data.scene ? isopatch.readScene(data.scene) : null;
    isopatch.viewer = null;
    isopatch.stageViewer = null;
    const theme = themeButton(() => [isopatch.viewer, isopatch.stageViewer].forEach((one) => one && one.setBackground()));
    document.getElementById("page-header").append(
      isopatch.element("div", {}, isopatch.element("h1", {}, data.title || data.program), isopatch.element(
        "p", {}, `${titles[data.kind] || ""} by ${data.program}`), caseLinks(data)), theme);
    if (scene) {
      const stage = isopatch.makeViewerSection(scene, firstLook(data, scene));
      main.append(stage.root);
      isopatch.viewer = stage.viewer;
      const tolerance = isopatch.toleranceText(scene);
      if (tolerance && stage.viewer) stage.root.querySelector(".stage-main").append(tolerance);
    }
    isopatch[builders[data.kind]](main, data, scene, isopatch.viewer);
    theme.follow();
    document.body.dataset.ready = "";
  };

  if (typeof document !== "undefined") document.addEventListener("DOMContentLoaded", isopatch.start);
})(globalThis.isopatch);
