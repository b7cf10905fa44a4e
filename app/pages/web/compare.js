// The page that sets elimination and Lagrange multipliers side by side.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const counts = (n) => isopatch.withSeparators(n);
  const unit = (name) => (x) => isopatch.withUnit(x, name);

  const lines = [
    ["dofs", "unknowns", counts], ["dofs_free", "free of supports", counts], ["multipliers", "multipliers", counts],
    ["method", "solver", String], ["iterations", "iterations", counts], ["matrix_nonzeros", "non-zeros of the matrix", counts],
    ["factor_nonzeros", "non-zeros of the factor", counts], ["memory_bytes", "memory of the solver", (x) => isopatch.bytesText(x)],
    ["relative_residual", "relative residual", (x) => isopatch.general(x, 2)],
    ["max_displacement", "largest displacement", unit("m")], ["max_von_mises", "largest von Mises stress", unit("Pa")],
    ["internal_energy", "internal energy", unit("J")]];

  function sideBySide(summary) {
    const [a, b] = [summary.elimination || {}, summary.lagrange || {}];
    const cell = (value, format) => (value === undefined || value === null ? "" : format(value));
    const rows = lines.filter(([key]) => key in a || key in b).map(([key, name, format]) => (
      [name, cell(a[key], format), cell(b[key], format)]));
    return isopatch.table(["", "elimination", "Lagrange multipliers"], rows);
  }

  function differences(summary) {
    const found = summary.difference;
    if (!found) return null;
    const rows = [["displacement", found.displacement, found.allowed], ["internal energy", found.internal_energy, found.allowed],
                  ["multipliers", found.multipliers, found.allowed_multipliers]]
      .filter(([, value]) => value !== undefined)
      .map(([name, value, allowed]) => [name, isopatch.general(value, 2), isopatch.general(allowed, 2)]);
    const verdict = summary.agree ? "The two couplings agree." : "The two couplings do not agree.";
    return isopatch.section("Differences",
      element("p", {class: summary.agree ? "verdict good" : "verdict bad", id: "verdict"}, verdict),
      isopatch.table(["largest relative difference", "found", "allowed"], rows));
  }

  function tables(data) {
    return (data.tables || []).map((table) => isopatch.section(table.title, isopatch.table(table.head, table.rows)));
  }

  isopatch.buildCompare = function (main, data, scene, viewer) {
    const summary = data.summary || {};
    const plots = isopatch.plotFigures(data.plots);
    const times = [["Time, elimination", summary.elimination], ["Time, Lagrange multipliers", summary.lagrange]]
      .map(([title, side]) => (side ? isopatch.timeBars(title, side.timings) : null));
    const sections = [
      differences(summary), isopatch.warningsSection(isopatch.warningTexts(data, scene), viewer),
      summary.elimination ? isopatch.section("Side by side", sideBySide(summary), element("div", {class: "figures"}, times, plots)) : null,
      ...tables(data), isopatch.studySection(data)];
    main.append(...sections.filter(Boolean));
  };
})(globalThis.isopatch);
