#pragma once
#include "base/views.hpp"

namespace breccia {

/// Numbers in a row of a view.
template <class View>
std::size_t row_size(const View& view) {
  std::size_t n = 1;
  for (unsigned r = 1; r < View::rank; ++r) n *= view.extent(r);
  return n;
}

/// Copies the listed rows of a view into stretches of a buffer, or back: row list(k) is at
/// buffer[k * stride + shift] and what follows.
template <class View>
struct HaloRows {
  using Number = typename View::non_const_value_type;
  View view;
  Array<Index> list;
  Array<Number> buffer;
  std::size_t stride, shift;
  bool packs;

  KOKKOS_FUNCTION
  void operator()(Index k) const {
    std::size_t at = static_cast<std::size_t>(k) * stride + shift;
    const Index i = list(k);
    if (i < 0) return;  // neither end has it
    if constexpr (View::rank == 1) {
      move(view(i), at);
    } else if constexpr (View::rank == 2) {
      for (std::size_t a = 0; a < view.extent(1); ++a) move(view(i, a), at);
    } else {
      for (std::size_t a = 0; a < view.extent(1); ++a)
        for (std::size_t b = 0; b < view.extent(2); ++b) move(view(i, a, b), at);
    }
  }

 private:
  KOKKOS_FUNCTION
  void move(Number& number, std::size_t& at) const {
    if (packs)
      buffer(at++) = number;
    else
      number = buffer(at++);
  }
};

template <class View>
void pack_rows(const char* label, const View& view, const Array<Index>& list, Index count,
               const Array<typename View::non_const_value_type>& buffer, std::size_t stride,
               std::size_t shift) {
  for_each(label, count, HaloRows<View>{view, list, buffer, stride, shift, true});
}

template <class View>
void unpack_rows(const char* label, const View& view, const Array<Index>& list, Index count,
                 const Array<typename View::non_const_value_type>& buffer, std::size_t stride,
                 std::size_t shift) {
  for_each(label, count, HaloRows<View>{view, list, buffer, stride, shift, false});
}

/// The nodes at the listed corners.
template <int D>
void nodes_at_corners(const ConstConnectivity<D>& element_nodes, const Array<Index>& corners,
                      Index count, const Array<Index>& nodes) {
  for_each(
      "breccia::halo::nodes", count, KOKKOS_LAMBDA(Index k) {
        nodes(k) = element_nodes(corners(k) / (D + 1), corners(k) % (D + 1));
      });
}

}  // namespace breccia
