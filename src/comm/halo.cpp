#include "comm/halo.hpp"

#include <cstring>

namespace breccia {

namespace {

Array<Index> joined(const std::vector<std::vector<Index>>& lists, Index& count,
                    std::vector<Halo::Stretch>& stretches) {
  std::vector<Index> all;
  stretches.clear();
  for (std::size_t r = 0; r < lists.size(); ++r) {
    if (lists[r].empty()) continue;
    const auto begin = static_cast<Index>(all.size());
    all.insert(all.end(), lists[r].begin(), lists[r].end());
    stretches.push_back({static_cast<int>(r), begin, static_cast<Index>(all.size())});
  }
  count = static_cast<Index>(all.size());
  return to_device("breccia::halo::list", all);
}

std::vector<Post> posts_of(const std::vector<Halo::Stretch>& stretches, void* memory,
                           std::size_t row_bytes) {
  std::vector<Post> posts;
  for (const Halo::Stretch& s : stretches)
    posts.push_back({s.rank,
                     static_cast<char*>(memory) + static_cast<std::size_t>(s.begin) * row_bytes,
                     static_cast<std::size_t>(s.end - s.begin) * row_bytes});
  return posts;
}

}  // namespace

void Halo::set(const std::vector<std::vector<Index>>& out,
               const std::vector<std::vector<Index>>& in) {
  out_ = joined(out, out_count_, to_);
  in_ = joined(in, in_count_, from_);
}

void Halo::post(void* send, void* receive, std::size_t row_bytes) {
  world_->swap(posts_of(to_, send, row_bytes), posts_of(from_, receive, row_bytes));
  sent_ += static_cast<std::int64_t>(row_bytes) * out_count_;
}

std::size_t Halo::bytes() const {
  return (out_.span() + in_.span()) * sizeof(Index) + send_.span() + receive_.span();
}

std::vector<std::vector<Index>> ask(const World& world,
                                    const std::vector<std::vector<Index>>& wanted) {
  std::vector<Parcel> out;
  for (std::size_t r = 0; r < wanted.size(); ++r) {
    if (wanted[r].empty()) continue;
    Parcel parcel{static_cast<int>(r), std::vector<char>(wanted[r].size() * sizeof(Index))};
    std::memcpy(parcel.bytes.data(), wanted[r].data(), parcel.bytes.size());
    out.push_back(std::move(parcel));
  }
  std::vector<std::vector<Index>> asked(static_cast<std::size_t>(world.size()));
  for (const Parcel& parcel : world.deliver(out)) {
    std::vector<Index>& list = asked[static_cast<std::size_t>(parcel.rank)];
    list.resize(parcel.bytes.size() / sizeof(Index));
    std::memcpy(list.data(), parcel.bytes.data(), parcel.bytes.size());
  }
  return asked;
}

}  // namespace breccia
