// Sections that several kinds of pages have: warnings, plots, the study file, times.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);

  // Lists the warnings; those with a place lead to it in the picture.
  isopatch.warningsSection = function (texts, viewer) {
    if (texts.length === 0) return null;
    const places = viewer ? viewer.places.filter((place) => place.kind === "warning") : [];
    const show = (i) => {
      const place = places.find((candidate) => candidate.warning === i);
      if (!place) return null;
      const go = () => {
        viewer.choose(place);
        viewer.canvas.scrollIntoView({block: "center"});
        viewer.canvas.focus({preventScroll: true});
      };
      return element("button", {type: "button", class: "small", onclick: go}, "show");
    };
    return element("section", {class: "card warnings"}, element("h2", {}, texts.length === 1 ? "Warning" : `${texts.length} warnings`),
                   element("ol", {}, texts.map((text, i) => element("li", {}, text, " ", show(i)))));
  };

  // Those of the scene know places; others of the summary are added.
  isopatch.warningTexts = function (data, scene) {
    const texts = scene ? scene.warnings.map((warning) => warning.text) : [];
    for (const text of (data.summary && data.summary.warnings) || []) if (!texts.includes(text)) texts.push(text);
    return texts;
  };

  isopatch.plotFigures = (plots) => (plots || []).map((plot) => {
    const picture = element("div", {class: "plot"});
    picture.innerHTML = plot.svg;
    // A plot that has its title inside comes without one.
    return element("figure", {}, plot.title ? element("figcaption", {}, plot.title) : null, picture);
  });

  isopatch.bars = function (title, pairs, text) {
    const largest = Math.max(...pairs.map(([, value]) => value), 1e-30);
    return element("figure", {}, element("figcaption", {}, title),
      element("table", {class: "bars"}, element("tbody", {}, pairs.map(([name, value]) => element("tr", {},
        element("th", {scope: "row"}, name), element("td", {class: "bar-cell"},
          element("span", {class: "bar", style: `width: ${(100 * value) / largest}%`})),
        element("td", {}, text(value)))))));
  };

  isopatch.timeBars = function (title, timings) {
    const pairs = Object.entries(timings || {}).filter(([name]) => name !== "total");
    if (pairs.length === 0) return null;
    const total = timings.total;
    const whole = total === undefined ? title : `${title}: ${isopatch.secondsText(total)} in all`;
    return isopatch.bars(whole, pairs, isopatch.secondsText);
  };

  function copy(pre, button) {
    const selection = window.getSelection();
    selection.selectAllChildren(pre);
    button.textContent = document.execCommand("copy") ? "copied" : "selected: press Ctrl+C";
  }

  isopatch.studySection = function (data) {
    if (!data.study) return null;
    const pre = element("pre", {tabindex: "0", id: "study"}, data.study);
    const button = element("button", {type: "button", class: "small", onclick: () => copy(pre, button)}, "copy");
    return element("section", {class: "card"}, element("div", {class: "heading"}, element("h2", {}, "Study file"), button), pre);
  };

  // How closely the picture follows the part.
  isopatch.toleranceText = function (scene) {
    if (!scene || !scene.tolerance) return null;
    const {chord, field, is_coarse} = scene.tolerance;
    const percent = (x) => isopatch.general(100 * x, 2) + " %";
    const words = `The picture follows the part's shape to ${percent(chord)} of its size and the fields to ${percent(field)} of their range; between its points values are interpolated.`;
    return element("p", {class: is_coarse ? "notice" : "how"}, words, is_coarse
      ? " The part was too large for that, so this picture is coarser. The figures are not affected." : "");
  };
})(globalThis.isopatch);
