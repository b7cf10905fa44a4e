// The page of one run, and of a model that was not solved: the part, the figures, warnings, supports and loads, solver.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const size = (scene) => (scene ? scene.size : 1);
  const counts = (n) => isopatch.withSeparators(n);
  const many = (n, one, several) => counts(n) + " " + (n === 1 ? one : several || one + "s");

  function at(scene, point) {
    return point ? [" at ", element("span", {class: "nowrap"}, isopatch.placeWithUnit(point, size(scene)))] : [];
  }

  function modelRows(model, mass, scene) {
    if (!model) return [];
    const {box} = model;
    const pairs = model.non_matching_interfaces || 0;
    const rows = [["patches", `${counts(model.patches)}, ${many(model.interfaces, "interface")}${pairs > 0 ? `, ${counts(pairs)} that ${pairs === 1 ? "does" : "do"} not match` : ""}, `
                    + many(model.boundary_faces, "boundary face")],
                  ["volume, surface", `${isopatch.withUnit(model.volume, "m^3")}, ${isopatch.withUnit(model.boundary_area, "m^2")}`]];
    const apart = model.non_matching || [];
    if (apart.length > 0) rows.push(["not matching", apart.map(({first, second}) => `${first} and ${second}`).join(", ")]);
    if (box) rows.push(["box", isopatch.vectorWithUnit(box.max.map((x, i) => x - box.min[i]), "m")]);
    if (mass) rows.push(["mass, centre", [isopatch.withUnit(1e3 * mass.mass, "g"), at(scene, mass.centre)]]);
    rows.push(["smallest scaled Jacobian", isopatch.general(model.min_scaled_jacobian, 4) + " (at the Gauss points)"]);
    return rows;
  }

  // As on screen: "elimination and Nitsche's method".
  function couplingText(summary) {
    const others = {nitsche: " and Nitsche's method", mortar: " and mortar multipliers"};
    return summary.coupling + (others[summary.non_matching_coupling] || "");
  }

  function spaceRows(space, coupling) {
    if (!space) return [];
    return [["degree", space.degree.join(" \u00d7 ")], ["elements", counts(space.elements)],
            ["unknowns", `${counts(space.dofs)} (${counts(space.dofs_free)} free), coupled by ${coupling}`]];
  }

  // The energies of part and springs and of what couples faces equal the work of loads and temperatures.
  function energyRows(results, withFaces) {
    const scale = Math.max(Math.abs(results.internal_energy), Math.abs(results.external_work || 0));
    const rows = [["internal energy", isopatch.withUnit(results.internal_energy, "J")]];
    const more = (what, energy, always) => {
      const shown = isopatch.withoutRoundOff(energy, scale);
      if (Number.isFinite(energy) && (always || shown !== 0)) rows.push([what, isopatch.withUnit(shown, "J")]);
    };
    more("energy in springs", results.support_energy);
    if (withFaces) more("energy of Nitsche's method between faces", results.interface_energy, true);
    more("work of the loads", results.external_work, true);
    more("work of the temperatures", results.thermal_work);
    return rows;
  }

  function resultRows(summary, scene) {
    const results = summary.results;
    if (!results) return [];
    const scale = results.max_displacement;
    const stressScale = Math.max(results.max_von_mises || 0, 1e10 * (results.stress_round_off || 0));
    const stressText = (x) => isopatch.withUnit(isopatch.withoutRoundOff(x, stressScale), "Pa");
    const rows = [
      ["largest displacement", [isopatch.withUnit(scale, "m"), at(scene, results.max_displacement_point)]],
      ["largest von Mises stress", [stressText(results.max_von_mises), at(scene, results.max_von_mises_point),
                                    ` (${results.max_von_mises_sampled})`]],
      ...energyRows(results, summary.non_matching_coupling === "nitsche")];
    const error = results.discretization_error;
    if (error) rows.push(["discretization error", Number.isFinite(error.energy_norm)
      ? `about ${isopatch.general(100 * error.energy_norm, 2)} % in the energy norm, ${isopatch.general(100 * error.energy_norm ** 2, 2)} % of the energy; `
        + `largest von Mises stress \u00b1 ${stressText(error.max_von_mises)}`
      : `not estimated: ${error.missing}`]);
    if (error && error.singular) rows.push(["", `the largest von Mises stress grows with refinement: it is at ${error.singular}`]);
    if (Number.isFinite(results.max_tresca))
      rows.splice(2, 0,
        ["largest principal stress", [stressText(results.max_principal), at(scene, results.max_principal_point)]],
        ["smallest principal stress", [stressText(results.min_principal), at(scene, results.min_principal_point)]],
        ["largest Tresca stress", [stressText(results.max_tresca), at(scene, results.max_tresca_point)]]);
    if (Number.isFinite(results.min_safety_factor))
      rows.push(["safety factor against yield", [isopatch.general(results.min_safety_factor, 4), at(scene, results.min_safety_factor_point)]]);
    for (const cut of summary.sections || [])
      rows.push([cut.name, [`${isopatch.vectorWithUnit(cut.force, "N")}, moment ${isopatch.vectorWithUnit(cut.moment, "N m")}`,
                            at(scene, cut.point), `, area ${isopatch.withUnit(cut.area, "m^2")}`]]);
    for (const probe of summary.probes || []) {
      const moved = probe.displacement.map((x) => isopatch.withoutRoundOff(x, scale));
      rows.push([probe.name, [`displacement ${isopatch.vectorWithUnit(moved, "m")}, von Mises ${stressText(probe.von_mises)}`
                                + (Number.isFinite(probe.von_mises_error) ? ` \u00b1 ${stressText(probe.von_mises_error)}` : ""),
                              at(scene, probe.point)]]);
    }
    return rows;
  }

  // Where the mortar method has its multipliers, why there, and what goes through each face.
  function mortarRows(results) {
    const ties = (results || {}).mortar || [];
    const scale = Math.max(0, ...ties.map((tie) => Math.hypot(...tie.force)));
    return ties.map((tie) => [tie.face, tie.covered_by.join(", "), tie.reason, counts(tie.multipliers),
      isopatch.vectorWithUnit(tie.force.map((x) => isopatch.withoutRoundOff(x, scale)), "N")]);
  }

  function figures(data, scene) {
    const summary = data.summary || {};
    const results = resultRows(summary, scene);
    const model = [...modelRows(summary.model, summary.mass, scene), ...spaceRows(summary.discretization, couplingText(summary))];
    const materials = (summary.materials || []).map((m) => [m.name, isopatch.withUnit(m.young, "Pa"), isopatch.general(m.poisson, 4),
                                                            m.density > 0 ? isopatch.general(m.density, 4) + " kg/m^3" : "not given", counts(m.patches.length)]);
    const levels = (summary.levels || []).map((level) => [counts(level.refine), counts(level.dofs),
      Number.isFinite(level.energy_norm_error) ? isopatch.general(100 * level.energy_norm_error, 2) + " %" : "not estimated",
      isopatch.withUnit(level.internal_energy, "J"), isopatch.withUnit(level.max_displacement, "m"), isopatch.withUnit(level.max_von_mises, "Pa")]);
    const convergence = summary.convergence || {};
    if (summary.accuracy) results.push(["accuracy", summary.accuracy.text]);
    else if (levels.length) results.push(["limit of the energy", Number.isFinite(convergence.extrapolated_energy)
      ? isopatch.withUnit(convergence.extrapolated_energy, "J") + " (extrapolated)" : "none can be told: fewer than three levels, or changes that do not shrink evenly"]);
    if (convergence.max_von_mises_grows) results.push(["largest von Mises stress", "grows with refinement: at a sharp corner or edge it has no limit"]);
    if (results.length + model.length === 0) return null;
    const part = (title, head, rows, id) => (rows.length === 0 ? null : element(
      "figure", {id, class: id === "levels" || id === "mortar" ? "wide" : undefined}, element("figcaption", {}, title), isopatch.table(head, rows)));
    return isopatch.section("Figures", element("div", {class: "figures"},
      part("Results", null, results, "results"), part("Model", null, model),
      part("Mortar multipliers, which hold faces together that do not match", ["on", "covered by", "why this side", "multipliers", "force through it"],
        mortarRows(summary.results), "mortar"),
      part("Levels: error in the energy norm, largest displacement and von Mises stress",
        [summary.accuracy ? "step" : "refine", "unknowns", "error", "energy", "displacement", "von Mises"], levels, "levels"),
      part("Materials", ["material", "Young's modulus", "Poisson's ratio", "density", "patches"], materials)));
  }

  // "bore, top (4 faces), 7.5 cm^2"; names that are the labels of the faces say nothing more.
  function extent(region) {
    if (region.faces && region.faces.length) {
      const given = region.given || [];
      const count = many(region.faces.length, "face");
      const named = given.every((name) => region.faces.includes(name)) ? count : `${given.join(", ")} (${count})`;
      return `${named}, ${isopatch.withUnit(region.area, "m^2")}`;
    }
    if (region.edges && region.edges.length) return many(region.edges.length, "edge") + " of patches";
    if (region.patches && region.patches.length)
      return `${many(region.patches.length, "patch", "patches")}, ${isopatch.withUnit(region.volume, "m^3")}`;
    return "";
  }

  // Forces that are round-off beside the others appear as 0.
  function forceScale(summary) {
    const results = summary.results || {};
    const forces = [results.total_load || [0, 0, 0], ...(results.reactions || []).map((reaction) => reaction.force)];
    const surface = (results.max_von_mises || 0) * ((summary.model || {}).boundary_area || 0);
    return Math.max(surface, ...forces.map((force) => Math.hypot(...force)));
  }

  function regions(data, scene) {
    const summary = data.summary || {};
    const scale = forceScale(summary);
    const force = (vector) => isopatch.vectorWithUnit(vector.map((x) => isopatch.withoutRoundOff(x, scale)), "N");
    const reactions = (summary.results || {}).reactions || [];
    const supports = (summary.supports || []).map((support) => {
      const found = reactions.find((reaction) => reaction.support === support.name);
      const moment = found && found.moment_about_point ? isopatch.vectorWithUnit(found.moment_about_point, "N m") : "";
      return [support.name, support.kind, extent(support), found ? force(found.force) : "", moment];
    });
    const point = (summary.results || {}).moments_about;
    const about = point && point.some((x) => x !== 0) ? "moment about " + isopatch.placeWithUnit(point, size(scene)) : "moment about the origin";
    const totals = new Map((scene ? scene.loads : []).map((load) => [load.name, load.total]));
    const loads = (summary.loads || []).map((load) => (
      [load.name, load.kind.replace("_", " "), extent(load), totals.get(load.name) ? force(totals.get(load.name)) : ""]));
    if (supports.length + loads.length === 0) return null;
    if (summary.results && summary.results.total_load) loads.push(["all loads", "", "", force(summary.results.total_load)]);
    return isopatch.section("Supports and loads",
      isopatch.table(["support", "kind", "on", "reaction on the part", about], supports),
      isopatch.table(["load", "kind", "on", "total force"], loads));
  }

  function solver(data) {
    const summary = data.summary || {};
    const found = summary.solver;
    if (!found) return null;
    const rows = [["method", found.levels > 0 ? `${found.method} with ${many(found.levels, "multigrid level")}, ${found.operator.replace("_", "-")}` : found.method],
                  ["why", found.reason], [found.factor_nonzeros > 0 ? "steps of refinement" : "iterations", counts(found.iterations)],
                  ["relative residual", isopatch.general(found.relative_residual, 2)]];
    if (found.energy_error > 0) rows.push(["error in energy norm", isopatch.general(found.energy_error, 2)]);
    if (found.matrix_nonzeros > 0) rows.push(["non-zeros of the matrix", counts(found.matrix_nonzeros)]);
    if (found.factor_nonzeros > 0) rows.push(["non-zeros of the factor", counts(found.factor_nonzeros)]);
    rows.push(["memory of the solver", isopatch.bytesText(found.memory_bytes)]);
    if (summary.memory) rows.push(["memory of the program", isopatch.bytesText(summary.memory.peak_bytes)]);
    if (summary.parallel) rows.push(["processes, threads", `${summary.parallel.processes}, ${summary.parallel.threads}`]);
    return isopatch.section("Solver", element("div", {class: "figures"},
      element("figure", {class: "wide"}, isopatch.table(null, rows)),
      isopatch.timeBars("Time", summary.timings), isopatch.plotFigures(data.plots)));
  }

  isopatch.buildReport = function (main, data, scene, viewer) {
    const sections = [
      isopatch.warningsSection(isopatch.warningTexts(data, scene), viewer), figures(data, scene), isopatch.stagesSection(data), regions(data, scene),
      solver(data), isopatch.parameterizationSection(data.summary), isopatch.qualitySection(scene), isopatch.studySection(data)];
    main.append(...sections.filter(Boolean));
  };
})(globalThis.isopatch);
