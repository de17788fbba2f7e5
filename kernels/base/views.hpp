#pragma once
#include "base/exec.hpp"
#include "base/vec.hpp"

#include <Kokkos_Core.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace breccia {

// The one place that names layouts. Node data are read at random corners, all components
// together: rows. Element constants are streamed: columns, so that neighbouring elements fill a
// SIMD register or a warp.
using Rows = Kokkos::LayoutRight;
using Columns = Kokkos::LayoutLeft;

template <class T>
using Array = Kokkos::View<T*, Memory>;

/// Flags of many entities of which few are raised: entity i has bit i % kWordBits of word
/// i / kWordBits.
using BitWord = std::uint64_t;
inline constexpr Index kWordBits = 64;

/// One vector per node, or per any entity that is gathered: (n, D).
template <int D>
using Vectors = Kokkos::View<double* [D], Rows, Memory>;
template <int D>
using ConstVectors = Kokkos::View<const double* [D], Rows, Memory>;

/// Nodes of the elements: (element, D + 1).
template <int D>
using Connectivity = Kokkos::View<Index * [D + 1], Columns, Memory>;
template <int D>
using ConstConnectivity = Kokkos::View<const Index * [D + 1], Columns, Memory>;

/// One force per element corner: (element, local node, component).
template <int D>
using CornerForces = Kokkos::View<double * [D + 1][D], Rows, Memory>;
template <int D>
using ConstCornerForces = Kokkos::View<const double * [D + 1][D], Rows, Memory>;

/// The same in single precision (precision = "mixed").
template <int D>
using CornerForcesSingle = Kokkos::View<float * [D + 1][D], Rows, Memory>;
template <int D>
using ConstCornerForcesSingle = Kokkos::View<const float * [D + 1][D], Rows, Memory>;

/// Corner forces of either precision, for whoever reads few of them; both empty: none.
template <int D>
struct AnyCornerForces {
  ConstCornerForces<D> wide;
  ConstCornerForcesSingle<D> single;

  KOKKOS_INLINE_FUNCTION
  bool present() const { return wide.extent(0) > 0 || single.extent(0) > 0; }
  KOKKOS_INLINE_FUNCTION
  double operator()(Index element, Index corner, int d) const {
    return single.extent(0) > 0 ? single(element, corner, d) : wide(element, corner, d);
  }
  /// Component d of corner number `corner` of all.
  KOKKOS_INLINE_FUNCTION
  double at(Index corner, int d) const {
    const auto place = static_cast<std::ptrdiff_t>(corner) * D + d;
    return single.extent(0) > 0 ? single.data()[place] : wide.data()[place];
  }
};

/// One matrix per element, streamed: (element, D, D).
template <int D>
using Matrices = Kokkos::View<double* [D][D], Columns, Memory>;
template <int D>
using ConstMatrices = Kokkos::View<const double* [D][D], Columns, Memory>;

/// One symmetric matrix per corner: (element, local node, component of Sym<D>).
template <int D>
using CornerMatrices = Kokkos::View<double * [D + 1][D * (D + 1) / 2], Rows, Memory>;
template <int D>
using ConstCornerMatrices = Kokkos::View<const double * [D + 1][D * (D + 1) / 2], Rows, Memory>;
/// One symmetric tensor of space per element, streamed, in the order of point/full_sym.hpp.
template <int D>
using FullTensors = Kokkos::View<double * [D == 2 ? 4 : 6], Columns, Memory>;
template <int D>
using ConstFullTensors = Kokkos::View<const double * [D == 2 ? 4 : 6], Columns, Memory>;

/// Pairs of numbers (begin, end).
using Ranges = Kokkos::View<Index* [2], Rows, Memory>;
using ConstRanges = Kokkos::View<const Index* [2], Rows, Memory>;

/// New array that is not filled.
template <class View>
View allocate(const std::string& label, std::size_t n) {
  return View(Kokkos::view_alloc(Kokkos::WithoutInitializing, label), n);
}

/// A device copy of host numbers.
template <class T>
Array<T> to_device(const std::string& label, const std::vector<T>& host) {
  Array<T> device = allocate<Array<T>>(label, host.size());
  Kokkos::View<const T*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> view(host.data(), host.size());
  Kokkos::deep_copy(device, view);
  return device;
}

/// A host copy of device numbers.
template <class T>
std::vector<T> to_host(const Array<T>& device, std::size_t n) {
  std::vector<T> host(n);
  Kokkos::View<T*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> view(host.data(), n);
  Kokkos::deep_copy(view, Kokkos::subview(device, std::make_pair(std::size_t(0), n)));
  return host;
}

template <int N, class View>
KOKKOS_FORCEINLINE_FUNCTION
Vec<N> row(const View& a, Index i) {
  Vec<N> r;
  for (int d = 0; d < N; ++d) r[d] = a(i, d);
  return r;
}

template <int N, class View>
KOKKOS_FORCEINLINE_FUNCTION
void set_row(const View& a, Index i, const Vec<N>& r) {
  for (int d = 0; d < N; ++d) a(i, d) = r[d];
}

}  // namespace breccia
