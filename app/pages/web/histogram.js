// Histograms as SVG, and the quality of the elements from the samples of the scaled Jacobian.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  // Counts of `bins` equal intervals from low to high; the last one includes its end.
  isopatch.countInBins = function (values, low, high, bins) {
    const counts = new Array(bins).fill(0);
    for (const x of values) {
      if (!Number.isFinite(x)) continue;
      const bin = Math.floor(((x - low) / (high - low)) * bins);
      counts[Math.max(0, Math.min(bins - 1, bin))] += 1;
    }
    return counts;
  };

  // Smallest sample of each element: [{patch, value}].
  isopatch.elementMinima = function (scene, values) {
    const result = [];
    scene.patches.forEach((patch, p) => {
      const [e0, e1, e2] = patch.element_ends;
      for (let c = 0; c + 1 < e2.length; ++c)
        for (let b = 0; b + 1 < e1.length; ++b)
          for (let a = 0; a + 1 < e0.length; ++a)
            result.push({patch: p, value: smallest(patch, values, [[e0[a], e0[a + 1]], [e1[b], e1[b + 1]], [e2[c], e2[c + 1]]])});
    });
    return result;
  };

  function smallest(patch, values, [first, second, third]) {
    let least = Infinity;
    for (let k = third[0]; k <= third[1]; ++k)
      for (let j = second[0]; j <= second[1]; ++j)
        for (let i = first[0]; i <= first[1]; ++i) least = Math.min(least, values[isopatch.vertexIndex(patch, i, j, k)]);
    return least;
  }

  const svg = (name, attributes, ...children) => {
    const result = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
    result.append(...children);
    return result;
  };
  const text = (x, y, anchor, words) => svg("text", {x, y, "text-anchor": anchor, class: "plot-text"}, words);

  // Bars of the counts over low..high with their figures for who points at them.
  isopatch.histogram = function (title, values, what) {
    const found = isopatch.statistics(Float32Array.from(values));
    if (!found) return null;
    const low = found.min < 0 ? Math.floor(found.min * 10) / 10 : 0;
    const [high, bins] = [Math.max(1, found.max), 20];
    const counts = isopatch.countInBins(values, low, high, bins);
    const most = Math.max(...counts);
    const [width, height, left, bottom, top] = [420, 190, 52, 34, 14];
    const x = (t) => left + ((t - low) / (high - low)) * (width - left - 12);
    const y = (count) => height - bottom - (count / most) * (height - bottom - top);
    const bars = counts.map((count, i) => {
      const [from, to] = [low + (i * (high - low)) / bins, low + ((i + 1) * (high - low)) / bins];
      const label = `${isopatch.withSeparators(count)} ${what} from ${isopatch.general(from, 3)} to ${isopatch.general(to, 3)}`;
      // What is there stays visible beside the tallest bar.
      const size = count === 0 ? 0 : Math.max(1.5, y(0) - y(count));
      return svg("rect", {x: x(from) + 0.5, width: Math.max(1, x(to) - x(from) - 1), y: y(0) - size, height: size,
                          class: from < 0 ? "plot-bar plot-bad" : "plot-bar"}, svg("title", {}, label));
    });
    const countTicks = isopatch.ticks(0, most, 4).filter(Number.isInteger);
    const picture = svg("svg", {viewBox: `0 0 ${width} ${height}`, role: "img", class: "plot",
                                "aria-label": `${title}: ${found.count} ${what}, smallest ${isopatch.general(found.min, 4)}`},
      ...countTicks.map((count) => svg("line", {x1: left, x2: width - 12, y1: y(count), y2: y(count), class: "plot-grid"})),
      ...bars,
      ...countTicks.map((count) => text(left - 6, y(count) + 4, "end", isopatch.withSeparators(count))),
      ...isopatch.ticks(low, high, 5).map((t) => text(x(t), height - bottom + 15, "middle", isopatch.general(Math.abs(t) < 1e-9 ? 0 : t, 3))),
      text((left + width) / 2, height - 3, "middle", "scaled Jacobian"));
    return isopatch.element("figure", {}, isopatch.element("figcaption", {}, title), picture);
  };

  function worstPatches(scene, elements) {
    const worst = new Map();
    for (const {patch, value} of elements) worst.set(patch, Math.min(value, worst.has(patch) ? worst.get(patch) : Infinity));
    return [...worst].sort((a, b) => a[1] - b[1]).slice(0, 5).map(([patch, value]) => (
      [scene.patches[patch].name, isopatch.general(value, 4)]));
  }

  // The section about the quality of the elements, or null without samples.
  isopatch.qualitySection = function (scene) {
    const values = scene && scene.blocks.scaled_jacobian;
    if (!values) return null;
    const element = isopatch.element;
    const elements = isopatch.elementMinima(scene, values);
    const bad = elements.filter(({value}) => !(value > 0)).length;
    return isopatch.section("Quality of the elements",
      element("p", {}, "The scaled Jacobian is 1 for a brick, and must not reach 0. The samples include the corners of the elements, which the Gauss points do not. ", bad === 0
        ? "It is positive at all sampled points."
        : element("strong", {}, `It is not positive in ${isopatch.withSeparators(bad)} of ${isopatch.withSeparators(elements.length)} elements.`)),
      element("div", {class: "figures"},
        isopatch.histogram("At the sampled points", values, "points"),
        isopatch.histogram("Smallest value of each element", elements.map(({value}) => value), "elements"),
        element("figure", {}, element("figcaption", {}, "Patches with the smallest values"),
                isopatch.table(["patch", "smallest scaled Jacobian"], worstPatches(scene, elements)))));
  };
})(globalThis.isopatch);
