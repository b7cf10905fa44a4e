// How solids became patches: certificate and quality of each, deviation of each face.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const general = (x) => isopatch.general(x, 4);

  function patchRows(patches) {
    return patches.map((patch) => [
      patch.name,
      patch.certified ? "certified" : element("strong", {}, "not certified"),
      `${general(patch.determinant_bound / patch.volume)}`,
      general(patch.min_scaled_jacobian), general(patch.mean_scaled_jacobian), isopatch.withSeparators(patch.control_points),
      patch.optimized ? "optimized" : "as fitted"]);
  }

  function faceRows({faces, tolerance, size}) {
    return [...faces].sort((a, b) => b.deviation - a.deviation).map((face) => {
      const text = isopatch.withUnit(isopatch.withoutRoundOff(face.deviation, size), "m");
      return [face.name, face.sides.join(" = "), face.deviation > tolerance ? element("strong", {}, text) : text,
              face.sides.length > 1 ? isopatch.withUnit(face.gap, "m") : ""];
    });
  }

  // Counts of the tenths of [0, 1] over all patches, as bars.
  function histogram(patches) {
    const sums = patches[0].histogram.map((_, i) => patches.reduce((sum, patch) => sum + patch.histogram[i], 0));
    const first = sums.findIndex((count) => count > 0);
    const all = sums.reduce((a, b) => a + b, 0);
    const bins = sums.map((count, i) => [`${general(i / 10)} to ${general((i + 1) / 10)}`, count]).slice(first);
    return isopatch.bars("Scaled Jacobian at the Gauss points", bins, (count) => `${isopatch.general((100 * count) / all, 3)} %`);
  }

  isopatch.parameterizationSection = function (summary) {
    const found = summary && summary.parameterization;
    if (!found) return null;
    const text = `The largest deviation is ${isopatch.withUnit(isopatch.withoutRoundOff(found.largest_deviation, found.size), "m")}, at ${found.largest_deviation_at}; `
      + `${isopatch.withUnit(found.tolerance, "m")} is allowed. ${found.certified
        ? "Of every patch det J is certified to be positive everywhere."
        : "Not every patch could be certified."} The bound of det J is that of the certificate, over its mean in the patch.`;
    return isopatch.section("From solids to patches", element("p", {}, text),
      isopatch.table(["block", "det J", "its bound", "smallest scaled J", "mean", "control points", ""], patchRows(found.patches)),
      element("div", {class: "figures"}, histogram(found.patches)),
      element("details", {}, element("summary", {}, `Deviation of the ${found.faces.length} faces`),
        isopatch.table(["face", "sides of patches", "deviation", "gap between the solids"], faceRows(found))));
  };
})(globalThis.isopatch);
