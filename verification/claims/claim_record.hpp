#pragma once

#include "verification/claims/claim.hpp"

namespace isopatch::verification {

/// Notes a claim for the record of this program's run, as belonging to the running test.
void record(const Claim& claim, bool holds);
void record(const Convergence& convergence, bool holds);
/// Its verdict is "reported".
void record(const Figure& figure);

/// Makes GoogleTest write the record at the end of the run into the file that the environment variable
/// ISOPATCH_CLAIMS names: a JSON array with one object for each claim, one for each test that failed without
/// a claim of its own doing so, and one, "not run", for each test that was skipped. Does nothing without the
/// variable.
void write_record_at_the_end();

}  // namespace isopatch::verification
