// Colours for values: a perceptually uniform map (dark blue to yellow, that of S. van der Walt and N. Smith, 2015, by its
// ten anchors) and twelve colours that are easily told apart.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const anchors = ["#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b",
                   "#fde725"];
  isopatch.categories = ["#4c78a8", "#f58518", "#54a24b", "#e45756", "#72b7b2", "#eeca3b", "#b279a2", "#ff9da6", "#9d755d",
                         "#8cb4e0", "#b6992d", "#79706e"];
  isopatch.noValueColour = "#8f8f8f";

  const channels = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

  // Red, green and blue from 0 to 255 for t from 0 to 1.
  isopatch.colourAt = function (t) {
    const x = Math.min(1, Math.max(0, t)) * (anchors.length - 1);
    const i = Math.min(anchors.length - 2, Math.floor(x));
    const [a, b] = [channels(anchors[i]), channels(anchors[i + 1])];
    return a.map((value, c) => Math.round(value + (x - i) * (b[c] - value)));
  };

  isopatch.categoryOf = (index) => isopatch.categories[index % isopatch.categories.length];

  // Bytes (red, green, blue, opaque) of `count` steps of the map, and of the categories.
  isopatch.mapBytes = function (count) {
    const bytes = new Uint8Array(4 * count);
    for (let i = 0; i < count; ++i) bytes.set([...isopatch.colourAt(i / (count - 1)), 255], 4 * i);
    return bytes;
  };
  isopatch.categoryBytes = () => new Uint8Array(isopatch.categories.flatMap((hex) => [...channels(hex), 255]));

  // A CSS gradient, smooth or in bands, upwards unless the style sheet sets --direction.
  isopatch.gradient = function (bands) {
    const stops = [];
    const css = (t) => "rgb(" + isopatch.colourAt(t).join(",") + ")";
    if (bands === 0) for (let i = 0; i <= 18; ++i) stops.push(css(i / 18));
    for (let i = 0; i < bands; ++i)
      stops.push(`${css((i + 0.5) / bands)} ${(100 * i) / bands}% ${(100 * (i + 1)) / bands}%`);
    return "linear-gradient(var(--direction, to top), " + stops.join(", ") + ")";
  };
})(globalThis.isopatch);
