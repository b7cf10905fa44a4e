#pragma once

#include "app/study/study.hpp"
#include "iga/problem/load_case.hpp"

namespace isopatch::app {

/// The load cases of a study and their combinations, with cases in the order in which loads, then supports,
/// name them; none if no load and no support names a case.
///
/// @throws Error invalid_argument  a load without a case beside others that have one, a combination of cases
///     that there are not, two of one name, displacements of supports that would count in several cases of a
///     combination; all with file, line and column
iga::LoadCases load_cases(const Study& study);

}  // namespace isopatch::app
