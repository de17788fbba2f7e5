#pragma once
#include "base/views.hpp"

#include <string>

namespace breccia {

/// Room for n numbers at least; contents are lost when it grows. Growth is geometric, so that
/// lists that grow a little with every crack do not allocate each time.
template <class View>
void make_room(View& view, Index n) {
  if (static_cast<Index>(view.extent(0)) >= n) return;
  view = View();  // frees before it allocates
  view = allocate<View>("breccia::contact::list", static_cast<std::size_t>(n + n / 4 + 16));
}

/// Number of i in [0, n) for which keep(i).
template <class Keep>
Index count_where(const char* label, Index n, const Keep& keep) {
  Index total = 0;
  if (n <= 0) return total;
  count_launch();
  Kokkos::parallel_reduce(
      label, Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, n),
      KOKKOS_LAMBDA(Index i, Index & sum) { sum += keep(i) ? 1 : 0; }, total);
  return total;
}

/// Writes the i of [0, n) for which keep(i) to `to`, ascending; returns how many.
template <class Keep>
Index list_where(const char* label, Index n, const Keep& keep, Array<Index>& to) {
  const Index total = count_where(label, n, keep);
  make_room(to, total);
  if (total == 0) return 0;
  const Array<Index> list = to;
  return scan(
      label, n, KOKKOS_LAMBDA(Index i, Index & place, bool last) {
        if (!keep(i)) return;
        if (last) list(place) = i;
        ++place;
      });
}

/// begins[i] = sum of counts(j) over j < i, for i in [0, n]; returns the total.
template <class Counts>
Index list_begins(const char* label, Index n, const Counts& counts, Array<Index>& begins) {
  make_room(begins, n + 1);
  const Array<Index> list = begins;
  return scan(
      label, n + 1, KOKKOS_LAMBDA(Index i, Index & place, bool last) {
        if (last) list(i) = place;
        if (i < n) place += counts(i);
      });
}

KOKKOS_INLINE_FUNCTION
void swap_numbers(Index& a, Index& b) {
  const Index t = a;
  a = b;
  b = t;
}

/// Heap sort of different numbers.
KOKKOS_INLINE_FUNCTION
void sort_many(Index* list, Index n) {
  Index start = n / 2;
  for (Index end = n; end > 1;) {
    if (start > 0) {
      --start;
    } else {
      --end;
      swap_numbers(list[0], list[end]);
    }
    Index root = start;
    for (Index child = 2 * root + 1; child < end; child = 2 * root + 1) {
      if (child + 1 < end && list[child] < list[child + 1]) ++child;
      if (list[root] >= list[child]) break;
      swap_numbers(list[root], list[child]);
      root = child;
    }
  }
}

/// Sorts different numbers in place; lists are short, except many small pieces on a large one.
KOKKOS_INLINE_FUNCTION
void sort_list(Index* list, Index n) {
  if (n > 24) {
    sort_many(list, n);
    return;
  }
  for (Index i = 1; i < n; ++i) {
    const Index t = list[i];
    Index j = i;
    for (; j > 0 && list[j - 1] > t; --j) list[j] = list[j - 1];
    list[j] = t;
  }
}

/// Place of `value` in an ascending list, or kNone.
template <class List>
KOKKOS_INLINE_FUNCTION
Index find_in(const List& list, Index n, Index value) {
  Index low = 0, high = n;
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    if (list(middle) < value) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < n && list(low) == value ? low : kNone;
}

}  // namespace breccia
