// The values at a place, as rows of name and text: exact ones of a marker, interpolated ones of a click.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const general = (value) => isopatch.general(value, 4);
  const length = (vector) => Math.hypot(...vector);
  const parameters = (values) => "(" + values.map((x) => general(Math.abs(x) < 1e-12 ? 0 : x)).join(", ") + ")";

  function displacementRows(scene, vector) {
    const clean = vector.map((x) => isopatch.withoutRoundOff(x, scene.maxDisplacement));
    return [["displacement", isopatch.vectorWithUnit(clean, "m")], ["its length", isopatch.withUnit(length(clean), "m")]];
  }

  function scalarText(field, value) {
    if (!Number.isFinite(value)) return "none here";
    if (field.key === "von_mises") return isopatch.withUnit(value, "Pa");
    return (general(value * field.factor) + " " + field.unit).trim();
  }

  isopatch.scalarText = scalarText;

  function fieldRows(scene, field, value) {
    const name = field.label.charAt(0).toLowerCase() + field.label.slice(1);
    if (field.key === "displacement") return displacementRows(scene, value);
    if (field.components === 1) return [[field.key === "von_mises" ? "von Mises stress" : name, scalarText(field, value[0])]];
    if (!value.every(Number.isFinite)) return [];
    if (value.length === 6)
      return [[name + " " + isopatch.tensorComponents.join(", "), "(" + value.map((x) => general(x * field.factor)).join(", ") + ") " + field.unit]];
    return [[name, "(" + value.map((x) => general(x * field.factor)).join(", ") + ") " + field.unit],
            [name + ", length", scalarText(field, length(value))]];
  }

  const placeRow = (scene, point) => ["place", isopatch.placeWithUnit(point, scene.size)];

  // {title, how, rows} of what a click met.
  isopatch.valuesOfPick = function (scene, picked) {
    const rows = [placeRow(scene, picked.place)];
    for (const field of scene.fields) rows.push(...fieldRows(scene, field, picked.fields[field.key]));
    const label = picked.face && picked.face.label ? ", face " + picked.face.label : "";
    rows.push(["patch", picked.patch.name + label], ["parameters", parameters(picked.parameter)]);
    for (const [key, title] of [["supports", "support"], ["loads", "load"]])
      for (const index of (picked.face && picked.face[key]) || []) rows.push([title, scene[key][index].name]);
    return {title: "Clicked point", how: "interpolated between the points of the picture", rows};
  };

  // {title, how, rows} of a marker or a warning.
  isopatch.valuesOfPlace = function (scene, place) {
    if (place.kind === "warning") return {title: place.name, how: place.text, rows: [placeRow(scene, place.point)]};
    const rows = [placeRow(scene, place.point)];
    if (place.displacement) rows.push(...displacementRows(scene, place.displacement));
    if (Number.isFinite(place.von_mises)) rows.push(["von Mises stress", isopatch.withUnit(place.von_mises, "Pa")]);
    if (place.text) rows.push(["value", place.text]);
    if (Number.isInteger(place.patch)) rows.push(["patch", scene.patches[place.patch] ? scene.patches[place.patch].name : place.patch]);
    if (place.parameter) rows.push(["parameters", parameters(place.parameter)]);
    return {title: place.name, how: "exact: computed by the program at this place", rows};
  };

  // The value of a marker behind its name in the picture: what it is the largest of, else the displacement's length where
  // the displacement is shown, and the von Mises stress where anything else is. Empty if it has none.
  isopatch.valueOfPlace = function (place, quantity) {
    if (place.kind === "warning") return "";
    if (place.text) return place.text;
    const isMoved = place.kind === "max_displacement" || (place.kind !== "max_von_mises" && quantity.field === "displacement");
    if (isMoved) return place.displacement ? isopatch.withUnit(length(place.displacement), "m") : "";
    return Number.isFinite(place.von_mises) ? isopatch.withUnit(place.von_mises, "Pa") : "";
  };

  isopatch.showValues = function (host, values) {
    const element = isopatch.element;
    host.replaceChildren(
      element("h3", {}, values.title), element("p", {class: "how"}, values.how),
      element("dl", {}, values.rows.map(([name, text]) => element("div", {}, element("dt", {}, name), element("dd", {}, text)))));
  };
})(globalThis.isopatch);
