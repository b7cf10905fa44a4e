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
    ["condition", "condition number", (x) => isopatch.general(x, 2)],
    ["max_displacement", "largest displacement", unit("m")], ["max_von_mises", "largest von Mises stress", unit("Pa")],
    ["internal_energy", "internal energy", unit("J")]];

  // Of a factorization they are steps of refinement.
  const iterationsOf = ({factor_nonzeros, iterations}) => (factor_nonzeros > 0 ? "none" : iterations);

  function sideBySide(summary) {
    const [a, b] = [summary.elimination || {}, summary.lagrange || {}];
    const cell = (value, format) => (value === undefined || value === null ? "" : format(value));
    const withIterations = [a, b].map((run) => ({...run, iterations: iterationsOf(run)}));
    const rows = lines.filter(([key]) => (a[key] ?? b[key] ?? null) !== null).map(([key, name, format]) => (
      [name, ...withIterations.map((run) => cell(run[key], format))]));
    return isopatch.table(["", "elimination", "Lagrange multipliers"], rows);
  }

  // "1.5e-14 mm at (…) mm in patch 3".
  function largest(name, unitName, found, scene) {
    const value = found["max_" + name];
    const at = found[`max_${name}_at`];
    if (value === undefined || !at || at.patch < 0) return null;
    const place = scene ? isopatch.placeWithUnit(found[`max_${name}_point`], scene.size) : "";
    return `${isopatch.general(value, 2)} ${unitName} at ${place}, patch ${at.patch}, parameter (${
      at.parameter.map((x) => isopatch.general(x, 4)).join(", ")})`;
  }

  function differences(summary, scene) {
    const found = summary.difference;
    if (!found) return null;
    const rows = [["displacement", found.displacement, found.allowed], ["internal energy", found.internal_energy, found.allowed],
                  ["multipliers", found.multipliers, found.allowed_multipliers]]
      .filter(([, value]) => value !== undefined)
      .map(([name, value, allowed]) => [name, isopatch.general(value, 2), isopatch.general(allowed, 2)]);
    const places = [["displacement", largest("displacement", "m", found, scene)],
                    ["stress (von Mises)", largest("von_mises", "Pa", found, scene)]].filter(([, text]) => text);
    const verdict = summary.coupled === false ? "There is nothing to couple: no two patches meet."
      : summary.agree ? "The two couplings agree." : "The two couplings do not agree.";
    return isopatch.section("Differences",
      element("p", {class: summary.agree ? "verdict good" : "verdict bad", id: "verdict"}, verdict),
      isopatch.table(["relative difference", "found", "allowed"], rows),
      places.length ? isopatch.table(["largest difference in", "where"], places) : null);
  }

  function levels(summary) {
    if (!summary.levels || summary.levels.length < 2) return null;
    const head = ["refine", "degree", "coupling", "unknowns", "solver", "iterations", "non-zeros of the matrix", "of the factor",
                  "memory of the solver", "time", "energy", "difference in displacement", "in energy", "in multipliers"];
    const row = (level, key, name) => {
      const run = level[key];
      const shown = key === "elimination" ? ["", "", ""]
        : ["displacement", "internal_energy", "multipliers"].map((what) => isopatch.general(level.difference[what], 2));
      return [String(level.refine), [...new Set(level.degree)].join(", "), name, counts(run.dofs), run.method, counts(iterationsOf(run)),
              counts(run.matrix_nonzeros), counts(run.factor_nonzeros), isopatch.bytesText(run.memory_bytes),
              isopatch.secondsText(run.timings.total), isopatch.withUnit(run.internal_energy, "J"), ...shown];
    };
    const rows = summary.levels.flatMap((level) => [row(level, "elimination", "elimination"), row(level, "lagrange", "multipliers")]);
    const energy = summary.extrapolated_energy;
    return isopatch.section("Levels", isopatch.table(head, rows), typeof energy === "number"
      ? element("p", {class: "how"}, `The energies of the last three levels tend to ${isopatch.withUnit(energy, "J")}.`) : null);
  }

  function interfaces(summary) {
    if (!summary.interfaces || summary.interfaces.length === 0) return null;
    const size = (force) => Math.hypot(...force);
    const largestForce = Math.max(...summary.interfaces.map(({force}) => (force ? size(force) : 0)));
    const clean = (force) => force.map((x) => (Math.abs(x) < 1e-10 * largestForce ? 0 : x));  // round-off
    const rows = summary.interfaces.map(({first, second, area, force}) => [
      `${first} and ${second}`, isopatch.withUnit(area, "m^2"), force ? isopatch.vectorWithUnit(clean(force), "N") : "too few functions",
      force ? isopatch.withUnit(size(force) / area, "Pa") : ""]);
    return isopatch.section("Interfaces",
      element("p", {class: "how"}, "What the second patch does to the first, from the multipliers. The picture shows it as force per area. Near edges where more patches meet, or that a support holds, it is continued from inside."),
      isopatch.table(["interface", "area", "force on the first patch", "force per area"], rows));
  }

  isopatch.buildCompare = function (main, data, scene, viewer) {
    const summary = data.summary || {};
    const plots = isopatch.plotFigures(data.plots);
    const sections = [
      differences(summary, scene), isopatch.warningsSection(isopatch.warningTexts(data, scene), viewer),
      summary.elimination ? isopatch.section("Side by side", sideBySide(summary), element("div", {class: "figures large"}, plots)) : null,
      levels(summary), interfaces(summary), isopatch.studySection(data)];
    main.append(...sections.filter(Boolean));
  };
})(globalThis.isopatch);
