#pragma once
#include "base/views.hpp"

namespace breccia {

/// Row first + i becomes a copy of row from(i), for any rank up to 3.
template <class View>
struct CopyRows {
  View view;
  Array<Index> from;
  Index first;

  KOKKOS_FUNCTION
  void operator()(Index i) const {
    if constexpr (View::rank == 1) {
      view(first + i) = view(from(i));
    } else if constexpr (View::rank == 2) {
      for (std::size_t a = 0; a < view.extent(1); ++a) view(first + i, a) = view(from(i), a);
    } else {
      static_assert(View::rank == 3);
      for (std::size_t a = 0; a < view.extent(1); ++a)
        for (std::size_t b = 0; b < view.extent(2); ++b)
          view(first + i, a, b) = view(from(i), a, b);
    }
  }
};

}  // namespace breccia
