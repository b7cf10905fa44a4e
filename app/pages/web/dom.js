// Elements of the page made from values.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  // element("button", {class: "small", onclick: f}, "text", other, [more]): absent (null) children are left out.
  isopatch.element = function (name, attributes, ...children) {
    const result = document.createElement(name);
    for (const [key, value] of Object.entries(attributes || {})) {
      if (value === null || value === undefined || value === false) continue;
      if (typeof value === "function") result[key] = value;
      else result.setAttribute(key, value === true ? "" : value);
    }
    for (const child of children.flat(Infinity)) if (child !== null && child !== undefined) result.append(child);
    return result;
  };

  // A table with a head; rows are arrays of texts or elements, the first column names the row.
  isopatch.table = function (head, rows) {
    const element = isopatch.element;
    const cells = (row) => row.map((cell, i) => element(i === 0 ? "th" : "td", i === 0 ? {scope: "row"} : {}, cell));
    return element("div", {class: "table"}, element("table", {},
      head ? element("thead", {}, element("tr", {}, head.map((text) => element("th", {scope: "col"}, text)))) : null,
      element("tbody", {}, rows.map((row) => element("tr", {}, cells(row))))));
  };

  isopatch.section = function (title, ...children) {
    return isopatch.element("section", {class: "card"}, isopatch.element("h2", {}, title), children);
  };
})(globalThis.isopatch);
