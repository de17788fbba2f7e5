#pragma once
#include "mesh/mesh.hpp"

#include <cstdint>
#include <vector>

namespace breccia {

/// Strengths of faces scatter by Weibull's distribution (Weibull 1951, doi:10.1115/1.4010337). It
/// is cut into grades of equal probability, so that the laws of faces stay a short table: each has
/// the strength in its middle. As shares of the mean, weakest first; their mean is 1.
std::vector<double> strength_grades(double modulus);

/// The grade at a share of the probability in (0, 1).
Index grade_at(double share, Index grades);

/// The grade of a face: random, and the same for any number of threads.
Index grade_of_face(int seed, std::uint64_t face, Index grades);

}  // namespace breccia
