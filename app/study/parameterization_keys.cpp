#include "app/study/parameterization_keys.hpp"

#include <fmt/format.h>

namespace isopatch::app {
namespace {

using P = ParameterizationKeys;

Key<P> fit_integer_key(const std::string& name, int segmentation::FitOptions::*member, int least, int most,
                       std::string meaning) {
  Key<P> key = custom_key<P>(name, "integer", std::move(meaning), [=](P& target, const ConfigValue& value) {
    target.options.fit.*member = read_integer(value, name, least, most);
  });
  key.text.range = fmt::format("from {} to {}", least, most);
  key.text.fallback = fmt::format("{}", segmentation::FitOptions{}.*member);
  return key;
}

template <class Read>
Key<P> number_key(const std::string& name, const Range& range, double fallback, Read member,
                  std::string meaning) {
  Key<P> key = custom_key<P>(name, "number", std::move(meaning), [=](P& target, const ConfigValue& value) {
    member(target) = read_quantity(value, name, dimensions::none, range);
  });
  key.text.range = range.text();
  key.text.fallback = format_default(fallback);
  return key;
}

const Range tolerance_range = {1e-8, 0.1};

}  // namespace

const Keys<ParameterizationKeys>& parameterization_keys() {
  static const Keys<P> keys = {
      custom_key<P>(
          "method", quoted_list(names(parameterization_methods())),
          "shared fits edges and faces once, to the tolerance, so that neighbours have common control "
          "points; "
          "paper follows the five steps of the segmentation pipeline's paper, for comparison: 10 samples an "
          "edge, 343 control points a patch, averages at interfaces.",
          [](P& target, const ConfigValue& value) {
            target.options.method = read_choice(value, "method", parameterization_methods());
          })
          .with_default("\"shared\""),
      custom_key<P>(
          "tolerance", "number, " + tolerance_range.text(),
          "Largest deviation of the boundary, as a share of the model's size: knots are inserted until it is "
          "reached.",
          [](P& target, const ConfigValue& value) {
            target.options.fit.tolerance =
                read_quantity(value, "tolerance", dimensions::none, tolerance_range);
            target.gives_tolerance = true;
          })
          .with_default(
              "1e-4, or by how much vertices of triangles are off the solid made of them, up to 1e-3"),
      fit_integer_key("degree", &segmentation::FitOptions::degree, 2, 8, "Degree of the patches."),
      fit_integer_key("start_spans", &segmentation::FitOptions::start_spans, 1, 64,
                      "Knot spans along every direction before any is halved."),
      fit_integer_key("max_spans", &segmentation::FitOptions::max_spans, 1, 1024,
                      "Most knot spans along any direction; eight times as many as the solid's own splines "
                      "or turns ask for, if that is more."),
      number_key(
          "wanted_quality", {0, 1, true, false}, segmentation::ParameterizationOptions{}.wanted_quality,
          [](P& target) -> double& { return target.options.wanted_quality; },
          "Patches whose smallest scaled Jacobian is below it are optimized."),
      custom_key<P>(
          "optimize", "true or false",
          "Whether control points are moved where a patch is folded or poor; false only reports it.",
          [](P& target, const ConfigValue& value) { target.options.optimize = read_flag(value, "optimize"); })
          .with_default("true"),
      custom_key<P>(
          "same_point", "number, above 0 and below 0.05",
          "Points of two blocks closer than this share of the size are one point.",
          [](P& target, const ConfigValue& value) {
            target.same_point = read_quantity(value, "same_point", dimensions::none, {0, 0.05, false, false});
          })
          .with_default("1e-3, or 1e-5 where the faces of most blocks that meet agree to 1e-6"),
  };
  return keys;
}

const Choices<segmentation::ParameterizationMethod>& parameterization_methods() {
  static const Choices<segmentation::ParameterizationMethod> methods = {
      {"shared", segmentation::ParameterizationMethod::shared},
      {"paper", segmentation::ParameterizationMethod::paper}};
  return methods;
}

}  // namespace isopatch::app
