#pragma once

#include "study/plan.hpp"

namespace breccia {

/// `breccia study`: 0 done, 1 interrupted, or nothing can be said (no job is complete, a quantity
/// is the same in all). \throws Error (status 2) for what is wrong with the study.
int study_scene(const StudyRequest& request);

}  // namespace breccia
