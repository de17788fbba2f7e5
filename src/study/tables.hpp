#pragma once

#include "study/results.hpp"

#include <iosfwd>

namespace breccia {

/// The table of one quantity with its sentences, for people.
void print_findings(const Study& study, const Judged& judged, const Runs& runs,
                    const Findings& findings, std::ostream& out);

/// study.csv: one row per job.
std::string study_csv(const Study& study, const Runs& runs, const std::vector<Findings>& findings);

/// study.json: everything that tables and pictures say.
std::string study_json(const Study& study, const Runs& runs, const std::vector<Findings>& findings);

}  // namespace breccia
