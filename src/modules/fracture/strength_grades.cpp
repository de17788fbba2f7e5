#include "modules/fracture/strength_grades.hpp"

#include "core/random.hpp"

#include <cmath>
#include <numeric>

namespace breccia {

namespace {

constexpr int kGrades = 16;
constexpr std::uint32_t kStream = 0x66616365;  // "face": independent of other random fields

}  // namespace

std::vector<double> strength_grades(double modulus) {
  std::vector<double> share;
  for (int i = 0; i < kGrades; ++i)
    share.push_back(std::pow(-std::log1p(-(i + 0.5) / kGrades), 1 / modulus));
  const double mean = std::accumulate(share.begin(), share.end(), 0.0) / kGrades;
  for (double& s : share) s /= mean;
  return share;
}

Index grade_at(double share, Index grades) {
  return static_cast<Index>(share * static_cast<double>(grades));
}

Index grade_of_face(int seed, std::uint64_t face, Index grades) {
  const Random random{static_cast<std::uint64_t>(seed), kStream};
  return grade_at(random.uniform(face), grades);
}

}  // namespace breccia
