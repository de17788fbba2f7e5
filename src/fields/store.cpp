#include "fields/store.hpp"

#include <stdexcept>

namespace breccia {

void Store::set_size(Entity entity, Index count, Index capacity) {
  Size& size = size_[index(entity)];
  size = {count, capacity};
  for (SlotBase* slot : order_)
    if (slot->info().entity == entity) slot->resize(capacity);
}

void Store::set_count(Entity entity, Index count) {
  Size& size = size_[index(entity)];
  if (count > size.capacity) throw std::logic_error("Store::set_count: beyond the capacity");
  size.count = count;
}

void Store::copy_rows(Entity entity, const Array<Index>& from, Index first, Index n) {
  for (SlotBase* slot : order_)
    if (slot->info().entity == entity) slot->copy_rows(from, first, n);
}

std::size_t Store::bytes(const std::string& owner) const {
  std::size_t n = 0;
  for (const SlotBase* slot : order_)
    if (slot->owner == owner) n += slot->bytes();
  return n;
}

std::size_t Store::bytes() const {
  std::size_t n = 0;
  for (const SlotBase* slot : order_) n += slot->bytes();
  return n;
}

std::vector<Store::Block> Store::blocks() const {
  std::vector<Block> list;
  for (const SlotBase* slot : order_)
    list.push_back({slot->info(), slot->owner, slot->bytes_per_entity(), slot->bytes()});
  return list;
}

void Store::save(
    const std::function<void(const FieldInfo&, const void*, std::size_t)>& sink) const {
  std::vector<char> memory;
  for (const SlotBase* slot : order_) {
    if (slot->info().restart == Restart::no) continue;
    slot->read(memory, count(slot->info().entity));
    sink(slot->info(), memory.data(), memory.size());
  }
}

void Store::load(const std::function<void(const FieldInfo&, void*, std::size_t)>& source) {
  std::vector<char> memory;
  for (SlotBase* slot : order_) {
    if (slot->info().restart == Restart::no) continue;
    memory.resize(slot->bytes_per_entity() * count(slot->info().entity));
    source(slot->info(), memory.data(), memory.size());
    slot->write(memory, count(slot->info().entity));
  }
}

void Store::missing(const FieldInfo& info) {
  throw std::logic_error("field '" + std::string(info.name) + "' was never added to the store");
}

}  // namespace breccia
