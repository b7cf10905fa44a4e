#include "iga/operator/internal/line_table.hpp"

#include <algorithm>

#include "geometry/splines/basis.hpp"

namespace isopatch::iga {

namespace {

struct AtPoint {
  int first;
  Eigen::MatrixXd rows;  // values, derivatives
};

// Table of what `at(element, point)` says.
template <class At>
LineTable tabulate(int functions, const DirectionTable& elements, At at) {
  LineTable table;
  table.functions = functions;
  table.kinds.resize(2);
  table.run_start = {0};
  for (const DirectionTable::Element& element : elements.elements) {
    for (Eigen::Index q = 0; q < element.nodes.size(); ++q) {
      const AtPoint here = at(element, q);
      const int point = table.points();
      const bool first_of_element = static_cast<int>(table.runs.size()) == table.run_start.back();
      if (first_of_element || table.runs.back().first != here.first)
        table.runs.push_back({here.first, point, point});
      ++table.runs.back().end;
      table.first.push_back(here.first);
      for (int kind = 0; kind < 2; ++kind)
        for (int a = 0; a < functions; ++a)
          table.kinds[static_cast<std::size_t>(kind)].push_back(here.rows(kind, a));
    }
    table.run_start.push_back(static_cast<int>(table.runs.size()));
  }
  return table;
}

}  // namespace

LineTable line_table(const DirectionTable& elements) {
  return tabulate(static_cast<int>(elements.elements.front().values.cols()), elements,
                  [](const DirectionTable::Element& element, Eigen::Index q) {
                    AtPoint here{element.first, Eigen::MatrixXd(2, element.values.cols())};
                    here.rows.row(0) = element.values.row(q);
                    here.rows.row(1) = element.derivatives.row(q);
                    return here;
                  });
}

LineTable line_table(const geometry::KnotVector& knots, const DirectionTable& elements) {
  return tabulate(knots.degree() + 1, elements, [&](const DirectionTable::Element& element, Eigen::Index q) {
    const int span = knots.span(element.nodes[q]);
    return AtPoint{span - knots.degree(), geometry::basis_on_span(knots, span, element.nodes[q], 1)};
  });
}

LineTable squares(const LineTable& table) {
  LineTable result = table;
  const std::vector<double>& value = table.kinds[0];
  const std::vector<double>& derivative = table.kinds[1];
  result.kinds.assign(3, std::vector<double>(value.size()));
  for (std::size_t i = 0; i < value.size(); ++i) {
    result.kinds[0][i] = value[i] * value[i];
    result.kinds[1][i] = value[i] * derivative[i];
    result.kinds[2][i] = derivative[i] * derivative[i];
  }
  return result;
}

std::vector<LaneBand> lane_bands(const LineTable& table) {
  std::vector<LaneBand> bands;
  const int kinds = table.kind_count();
  for (int begin = 0; begin < table.points(); begin += lane_count) {
    const int last = std::min(begin + lane_count, table.points()) - 1;
    LaneBand band;
    band.first = table.first[static_cast<std::size_t>(begin)];
    band.functions = table.first[static_cast<std::size_t>(last)] + table.functions - band.first;
    band.values.assign(static_cast<std::size_t>(band.functions * kinds), Lanes{});
    for (int lane = 0; lane < lane_count; ++lane) {
      const int point = std::min(begin + lane, last);
      const int offset = table.first[static_cast<std::size_t>(point)] - band.first;
      for (int kind = 0; kind < kinds; ++kind)
        for (int a = 0; a < table.functions; ++a)
          band.values[static_cast<std::size_t>((offset + a) * kinds + kind)][lane] =
              table.kinds[static_cast<std::size_t>(kind)]
                         [static_cast<std::size_t>(point * table.functions + a)];
    }
    bands.push_back(std::move(band));
  }
  return bands;
}

}  // namespace isopatch::iga
