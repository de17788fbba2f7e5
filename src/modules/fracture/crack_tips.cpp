#include "modules/fracture/crack_tips.hpp"

#include "base/simplex.hpp"
#include "loops/compact.hpp"
#include "mesh/geometry.hpp"
#include "modules/fracture/interface_lists.hpp"

#include <cmath>
#include <numbers>

namespace breccia {

namespace {

/// Solid around a notch, in half turns: more than at a straight edge or on the rim of a round hole.
constexpr double kNotch = 1.1;

/// Angle of solid around each point on the rim of a plane mesh, rad; 0 inside.
std::vector<double> rim_angles(const Mesh<2>& mesh, const Topology<2>& topology) {
  std::vector<double> angle(mesh.point.size(), 0.0);
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    const Simplex<2> x = corners(mesh, static_cast<Index>(e));
    for (std::size_t a = 0; a < 3; ++a) {
      const auto u = minus(x[(a + 1) % 3], x[a]), v = minus(x[(a + 2) % 3], x[a]);
      angle[static_cast<std::size_t>(mesh.element[e][a])] +=
          std::acos(dot(u, v) / (length(u) * length(v)));
    }
  }
  std::vector<double> at_rim(angle.size(), 0.0);
  for (const ElementFace& face : topology.free)
    for (int c = 0; c < 2; ++c) {
      const auto point =
          static_cast<std::size_t>(mesh.element[face.element][face_node<2>(face.face, c)]);
      at_rim[point] = angle[point];
    }
  return at_rim;
}

/// The number of each listed family, none of the others.
void number_tips(const Array<Index>& tips, Index count, const Array<Index>& number) {
  Kokkos::deep_copy(number, kNone);
  for_each(
      "breccia::fracture::number_tips", count, KOKKOS_LAMBDA(Index t) { number(tips(t)) = t; });
}

}  // namespace

template <int D>
void CrackTips<D>::prepare(const Model<D>& model) {
  if constexpr (D == 2) {
    std::vector<std::uint8_t> flag;
    for (const double angle : rim_angles(model.mesh, model.topology))
      flag.push_back(angle > kNotch * std::numbers::pi ? tip::notch : std::uint8_t{0});
    flag_ = to_device("breccia::fracture::tip_flag", flag);
    tips_ = allocate<Array<Index>>("breccia::fracture::tips", flag.size());
    tip_of_ = allocate<Array<Index>>("breccia::fracture::tip_of", flag.size());
  }
}

template <int D>
void CrackTips<D>::renew(const TipOnsetIn<D>& in, const ConstArray<Index>& families, Index count) {
  if constexpr (D == 2) {
    const auto all = static_cast<Index>(flag_.extent(0));
    if (count == 0 || all == 0) return;
    flag_tips(in, families, count, flag_);
    count_ = compact("breccia::fracture::tips", flag_, all, tips_);
    make_room(choice_, "breccia::fracture::tip_choice", count_);
    make_room(found_, "breccia::fracture::tip_faces", count_);
    number_tips(tips_, count_, tip_of_);
  }
}

template <int D>
Index CrackTips<D>::find(const TipOnsetIn<D>& in) {
  if constexpr (D == 2) {
    if (count_ > 0) return find_tip_onset(in, tips_, count_, tip_of_, choice_, found_);
  }
  return 0;
}

template <int D>
std::size_t CrackTips<D>::bytes() const {
  return bytes_of(flag_, tips_, tip_of_, choice_, found_);
}

template class CrackTips<2>;
template class CrackTips<3>;

}  // namespace breccia
