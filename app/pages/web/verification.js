// The page of `isopatch verify`: every claim with its reference, suite by suite.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const element = (...all) => isopatch.element(...all);
  const number = (x, digits) => (typeof x === "number" ? isopatch.general(x, digits) : "");

  function row(claim) {
    const badge = element("span", {class: claim.verdict === "holds" ? "verdict good" : claim.verdict === "FAILS" ? "verdict bad" : "verdict"},
                          claim.verdict);
    const what = (claim.case ? claim.case + ": " : "") + claim.what + (claim.unit ? ` (${claim.unit})` : "");
    return [what, badge, number(claim.reference, 7), number(claim.value, 7), number(claim.difference, 2), number(claim.allowed, 2),
            [claim.kind, claim.source].filter(Boolean).join(", "), studyText(claim.study)];
  }

  const studyText = (study) => (study ? element("code", {}, [study.file, ...study.set].join(" ")) : "");

  const head = ["claim", "verdict", "reference", "value", "differs by", "allowed", "kind of reference", "study"];

  isopatch.buildVerification = function (main, data) {
    const summary = data.summary || {claims: []};
    const suites = [...new Set(summary.claims.map((claim) => claim.suite))];
    main.append(isopatch.section("In all", element("p", {class: summary.fail ? "verdict bad" : "verdict good", id: "verdict"},
      `${summary.hold} claims hold, ${summary.fail} fail, ${summary.not_run} were not run (level ${summary.level}).`)));
    for (const suite of suites) {
      const claims = summary.claims.filter((claim) => claim.suite === suite);
      const plots = (data.plots || []).filter((plot) => plot.title.startsWith(suite + ": "));
      const section = isopatch.section(suite, isopatch.table(head, claims.map(row)),
        element("div", {class: "figures"}, isopatch.plotFigures(plots)));
      section.classList.add("claims");
      main.append(section);
    }
  };
})(globalThis.isopatch);
