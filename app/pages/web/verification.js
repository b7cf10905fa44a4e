// The page of `isopatch verify`: the verdict of every suite at a glance, then its claims, case by case, and its plots.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const number = (x, digits) => (typeof x === "number" ? isopatch.general(x, digits) : "");
  const words = (name) => name.replace(/_/g, " ");
  const counts = [["hold", "hold"], ["fail", "FAIL"], ["not_run", "not run"], ["reported", "reported"]];
  const colours = {holds: " good", FAILS: " bad", "not run": " open"};

  const badge = (verdict) => element("span", {class: "verdict" + (colours[verdict] || "")}, verdict);

  // A suite fails with any of its claims, and holds if nothing of it was left out.
  function verdictOf(suite) {
    if (suite.fail) return "FAILS";
    return suite.hold ? "holds" : suite.not_run ? "not run" : "reported";
  }

  const countsText = (suite) => counts.filter(([key]) => suite[key]).map(([key, text]) => `${suite[key]} ${text}`).join(", ");

  // As a shell takes it.
  const quoted = (text) => (/^[\w.,=/-]+$/.test(text) ? text : text.includes('"') ? `'${text}'` : `"${text}"`);
  const studyText = (study) => (study ? element("code", {}, ["isopatch run " + study.file, ...study.set.map((x) => "--set " + quoted(x))].join(" ")) : "");

  // A difference, or the side of a limit.
  function allowed(claim) {
    if (claim.comparison === "at least") return "at least";
    if (claim.comparison === "at most" && claim.allowed !== null) return `at most, from ${isopatch.general(claim.least, 2)}`;
    return number(claim.allowed, 2);
  }

  function row(claim) {
    const why = claim.why || claim.reason;
    const what = [claim.what + (claim.unit ? ` (${claim.unit})` : ""), why ? element("span", {class: "why"}, why) : null];
    // What was not run, or broke outside its claims, has a reason and no numbers.
    if (!("value" in claim)) return element("tr", {class: "reason"}, element("th", {scope: "row"}, "no figures"), element("td", {}, badge(claim.verdict)),
                                            element("td", {colspan: 6}, what));
    const cells = [badge(claim.verdict), number(claim.reference, 7), number(claim.value, 7), number(claim.difference, 2), allowed(claim),
                   [claim.kind, claim.source].filter(Boolean).join(", "), studyText(claim.study)];
    return element("tr", {}, element("th", {scope: "row"}, what), cells.map((cell) => element("td", {}, cell)));
  }

  const head = ["claim", "verdict", "reference", "value", "differs by", "allowed", "kind of reference", "to run it alone"];

  function table(claims) {
    const cases = [...new Set(claims.map((claim) => claim.case))];
    return element("div", {class: "table"}, element("table", {},
      element("thead", {}, element("tr", {}, head.map((text) => element("th", {scope: "col"}, text)))),
      cases.map((name) => element("tbody", {},
        element("tr", {class: "case"}, element("th", {scope: "rowgroup", colspan: head.length}, name)),
        claims.filter((claim) => claim.case === name).map(row)))));
  }

  function overview(summary) {
    const good = !summary.fail && summary.hold;
    const sentence = `${summary.hold} claims hold, ${summary.fail} fail, ${summary.not_run} were not run` +
      ` (level ${summary.level}${summary.seconds ? ", " + isopatch.secondsText(summary.seconds) : ""}).`;
    const link = (suite) => element("a", {href: "#" + suite.name}, words(suite.name));
    const failures = summary.claims.filter((claim) => claim.verdict === "FAILS");
    return isopatch.section("In all",
      element("p", {class: good ? "verdict good" : "verdict bad", id: "verdict"}, sentence),
      element("div", {class: "suites"}, isopatch.table(["suite", "", ...counts.map(([, text]) => text.toLowerCase())],
        summary.suites.map((suite) => [link(suite), badge(verdictOf(suite)), ...counts.map(([key]) => String(suite[key]))]))),
      failures.length ? element("ul", {id: "failures"}, failures.map((claim) => (
        element("li", {}, `${words(claim.suite)}, ${claim.case}: ${claim.what}`)))) : null);
  }

  isopatch.buildVerification = function (main, data) {
    const summary = {claims: [], suites: [], hold: 0, fail: 0, not_run: 0, level: "", ...data.summary};
    main.append(overview(summary));
    for (const suite of summary.suites) {
      const plots = (data.plots || []).filter((plot) => plot.section === suite.name);
      const section = element("section", {class: "card claims", id: suite.name},
        element("h2", {}, words(suite.name), " ", element("small", {class: suite.fail ? "bad" : ""}, countsText(suite))),
        table(summary.claims.filter((claim) => claim.suite === suite.name)),
        plots.length ? element("div", {class: "figures"}, isopatch.plotFigures(plots)) : null);
      main.append(section);
    }
  };
})(globalThis.isopatch);
