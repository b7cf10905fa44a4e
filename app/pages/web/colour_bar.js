// The colour bar over the picture: label, unit, round ticks, and what lies beyond its ends; a legend for patches.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const legendLength = 12;

  // Text of a number on the bar, with as many decimals as the step between ticks has.
  function tickText(value, step) {
    const power = Math.floor(Math.log10(step) + 1e-9);
    if (Math.abs(value) < step * 1e-6) return "0";
    if (power < -5 || power > 5) return isopatch.general(value, 4);
    return value.toFixed(Math.max(0, -power));
  }

  function hint(words, value, quantity) {
    const field = {key: quantity.field === "von_mises" ? "von_mises" : "", factor: quantity.factor, unit: quantity.unit};
    return isopatch.element("div", {class: "bar-hint"}, words + " " + isopatch.scalarText(field, value));
  }

  function continuous(quantity, range, bands, statistics) {
    const element = isopatch.element;
    const [low, high] = range.map((x) => x * quantity.factor);
    const ticks = isopatch.ticks(low, high, 6);
    const step = ticks.length > 1 ? ticks[1] - ticks[0] : high - low || 1;
    const marks = ticks.map((value) => element(
      "span", {class: "bar-tick", style: `--at: ${(100 * (value - low)) / (high - low || 1)}%`}, tickText(value, step)));
    const slack = 1e-6 * Math.abs(high - low);
    const above = statistics && statistics.max * quantity.factor > high + slack;
    const below = statistics && statistics.min * quantity.factor < low - slack;
    return [
      above ? hint("\u25b2 up to", statistics.max, quantity) : null,
      element("div", {class: "bar-scale"}, element("div", {class: "bar-colours", style: "background:" + isopatch.gradient(bands)}),
              marks),
      below ? hint("\u25bc down to", statistics.min, quantity) : null];
  }

  function legend(patches) {
    const element = isopatch.element;
    const entries = patches.slice(0, legendLength).map((patch, p) => element(
      "li", {}, element("span", {class: "swatch", style: "background:" + isopatch.categoryOf(p)}), patch.name));
    const more = patches.length - legendLength;
    return [element("ul", {class: "bar-legend"}, entries),
            more > 0 ? element("div", {class: "bar-hint"}, `and ${more} more; colours repeat`) : null];
  }

  isopatch.drawColourBar = function (host, scene, quantity, range, bands, statistics) {
    const title = quantity.label + (quantity.unit ? " (" + quantity.unit + ")" : "");
    host.replaceChildren(
      isopatch.element("div", {class: "bar-title"}, title),
      ...(quantity.isCategorical ? legend(scene.patches) : continuous(quantity, range, bands, statistics)).filter(Boolean));
  };

  // The range that is shown first: from 0 where nothing is negative; a peak far above the rest is left out.
  isopatch.defaultRange = function (quantity, statistics) {
    if (!statistics) return [0, 1];
    if (quantity.field === "scaled_jacobian") return [Math.min(statistics.min, 0.999), 1];
    const low = statistics.min >= 0 ? 0 : statistics.min;
    const usual = statistics.percentile(99.9);
    const high = quantity.id === "von_mises" && statistics.max > 1.3 * usual ? usual : statistics.max;
    return high > low ? [low, high] : [low - 0.5 / quantity.factor, low + 0.5 / quantity.factor];
  };
})(globalThis.isopatch);
