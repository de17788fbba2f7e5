#pragma once
#include "base/views.hpp"
#include "core/world.hpp"
#include "loops/halo_rows.hpp"

#include <vector>

namespace breccia {

/// Rows that this rank shows to neighbours, and rows that it gets from them. Both ends list them in
/// the same order.
class Halo {
 public:
  /// One neighbour and its stretch of a list.
  struct Stretch {
    int rank;
    Index begin, end;
  };

  explicit Halo(const World& world) : world_(&world) {}

  /// Both lists, grouped by rank: out[r] are the rows that rank r sees, in[r] those that come from
  /// it. Both are as long as the number of ranks.
  void set(const std::vector<std::vector<Index>>& out, const std::vector<std::vector<Index>>& in);

  const Array<Index>& out() const { return out_; }
  const Array<Index>& in() const { return in_; }
  Index out_count() const { return out_count_; }
  Index in_count() const { return in_count_; }
  int neighbours() const { return static_cast<int>(from_.size()); }

  /// Brings the rows of the views, all of one number type, from their owners.
  template <class... Views>
  void exchange(const Array<Index>& rows_out, const Views&... views) {
    exchange_rows(rows_out, in_, views...);
  }
  /// The same of other rows that stand for the listed ones at both ends; none where both have none.
  template <class... Views>
  void exchange_rows(const Array<Index>& rows_out, const Array<Index>& rows_in,
                     const Views&... views) {
    using Number = std::common_type_t<typename Views::non_const_value_type...>;
    const std::size_t stride = (row_size(views) + ...);
    const Array<Number> send = room<Number>(stride * static_cast<std::size_t>(out_count_), send_);
    const Array<Number> receive =
        room<Number>(stride * static_cast<std::size_t>(in_count_), receive_);
    std::size_t shift = 0;
    ((pack_rows("breccia::halo::pack", views, rows_out, out_count_, send, stride, shift),
      shift += row_size(views)),
     ...);
    swap(send, receive, stride);
    shift = 0;
    ((unpack_rows("breccia::halo::unpack", views, rows_in, in_count_, receive, stride, shift),
      shift += row_size(views)),
     ...);
  }

  std::size_t bytes() const;
  /// Bytes that this rank has sent so far.
  std::int64_t sent() const { return sent_; }

 private:
  /// Memory for n numbers; grows and is kept.
  template <class Number>
  static Array<Number> room(std::size_t n, Array<char>& memory) {
    if (memory.extent(0) < n * sizeof(Number))
      memory = allocate<Array<char>>("breccia::halo::buffer", n * sizeof(Number) * 5 / 4);
    return Array<Number>(reinterpret_cast<Number*>(memory.data()), n);
  }

  template <class Number>
  void swap(const Array<Number>& send, const Array<Number>& receive, std::size_t stride) {
    const auto from = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, send);
    const auto to = Kokkos::create_mirror_view(receive);
    Kokkos::fence("breccia::halo::packed");
    post(from.data(), to.data(), stride * sizeof(Number));
    Kokkos::deep_copy(receive, to);
  }
  void post(void* send, void* receive, std::size_t row_bytes);

  const World* world_;
  Array<Index> out_, in_;
  Index out_count_ = 0, in_count_ = 0;
  std::vector<Stretch> to_, from_;
  Array<char> send_, receive_;
  std::int64_t sent_ = 0;
};

/// Lists of numbers for the ranks they are wanted from: what each rank asks of this one.
/// Collective.
std::vector<std::vector<Index>> ask(const World& world,
                                    const std::vector<std::vector<Index>>& wanted);

}  // namespace breccia
