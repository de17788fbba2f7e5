#pragma once
#include "fields/copy_rows.hpp"
#include "fields/field.hpp"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <typeindex>
#include <vector>

namespace breccia {

/// Owner of all fields. A field exists only when a module has asked for it; asking twice gives
/// the same field. Views are fetched anew in every task, so that growing an entity is safe
/// between tasks.
class Store {
 public:
  Store() = default;
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Number of entities, and room for more (capacity >= count). Fields that exist already keep
  /// their values; new room is zero.
  void set_size(Entity entity, Index count, Index capacity);
  void set_count(Entity entity, Index count);
  /// In every field of the entity, rows first ... first + n - 1 become copies of rows from(0) ...
  /// from(n - 1): how a node that splits hands on all that it carries.
  void copy_rows(Entity entity, const Array<Index>& from, Index first, Index n);
  Index count(Entity entity) const { return size_[index(entity)].count; }
  Index capacity(Entity entity) const { return size_[index(entity)].capacity; }

  /// Makes the field (zero-filled) for the effect `owner`, whose bytes it counts to.
  template <class Field>
  void add(const std::string& owner) {
    auto& slot = slots_[std::type_index(typeid(Field))];
    if (slot) return;
    slot = std::make_unique<Slot<Field>>(owner, capacity(Field::info.entity));
    order_.push_back(slot.get());
  }

  template <class Field>
  bool has() const {
    return slots_.count(std::type_index(typeid(Field))) != 0;
  }

  /// The field's view. Asking for a field that nobody added is a programming error (throws
  /// std::logic_error that names it).
  template <class Field>
  const typename Field::View& get() const {
    const auto found = slots_.find(std::type_index(typeid(Field)));
    if (found == slots_.end()) missing(Field::info);
    return static_cast<const Slot<Field>&>(*found->second).view;
  }

  /// The field's view, or an empty view when it does not exist.
  template <class Field>
  typename Field::View get_or_empty() const {
    return has<Field>() ? get<Field>() : typename Field::View{};
  }

  /// Bytes of an effect's fields, and of all.
  std::size_t bytes(const std::string& owner) const;
  std::size_t bytes() const;

  /// One field as plain memory on the host, for checkpoints and listings.
  struct Block {
    FieldInfo info;
    std::string owner;
    std::size_t bytes_per_entity;
    std::size_t bytes;
  };
  std::vector<Block> blocks() const;

  /// Every field of the restart list as (info, first `count` entities, bytes), in the order of
  /// its making; the host memory is valid during the call only.
  void save(const std::function<void(const FieldInfo&, const void*, std::size_t)>& sink) const;
  /// The inverse: `source` fills the memory it is given.
  void load(const std::function<void(const FieldInfo&, void*, std::size_t)>& source);

 private:
  struct Size {
    Index count = 0, capacity = 0;
  };
  struct SlotBase {
    explicit SlotBase(std::string o) : owner(std::move(o)) {}
    virtual ~SlotBase() = default;
    virtual FieldInfo info() const = 0;
    virtual void resize(Index capacity) = 0;
    virtual void copy_rows(const Array<Index>& from, Index first, Index n) = 0;
    virtual std::size_t bytes() const = 0;
    virtual std::size_t bytes_per_entity() const = 0;
    virtual void read(std::vector<char>& to, Index count) const = 0;
    virtual void write(const std::vector<char>& from, Index count) = 0;
    std::string owner;
  };
  template <class Field>
  struct Slot : SlotBase {
    using View = typename Field::View;
    Slot(std::string o, Index capacity)
        : SlotBase(std::move(o)), view("breccia::" + std::string(Field::info.name), capacity) {}
    FieldInfo info() const override { return Field::info; }
    void resize(Index capacity) override { Kokkos::resize(view, capacity); }
    void copy_rows(const Array<Index>& from, Index first, Index n) override {
      for_each("breccia::fields::copy_rows", n, CopyRows<View>{view, from, first});
    }
    std::size_t bytes() const override { return view.span() * sizeof(typename View::value_type); }
    std::size_t bytes_per_entity() const override {
      std::size_t n = sizeof(typename View::value_type);
      for (unsigned r = 1; r < View::rank; ++r) n *= view.extent(r);
      return n;
    }
    // Row by row, whatever the layout, so that a file does not depend on the backend.
    using HostRows = Kokkos::View<typename View::data_type, Rows, Kokkos::HostSpace>;
    void read(std::vector<char>& to, Index count) const override {
      HostRows rows("breccia::rows", view.extent(0));
      copy(rows, view);
      to.resize(bytes_per_entity() * count);
      std::copy_n(reinterpret_cast<const char*>(rows.data()), to.size(), to.data());
    }
    void write(const std::vector<char>& from, Index count) override {
      HostRows rows("breccia::rows", view.extent(0));
      copy(rows, view);
      std::copy_n(from.data(), bytes_per_entity() * count, reinterpret_cast<char*>(rows.data()));
      const auto mirror = Kokkos::create_mirror_view(view);
      Kokkos::deep_copy(mirror, rows);
      Kokkos::deep_copy(view, mirror);
    }
    static void copy(const HostRows& rows, const View& view) {
      const auto mirror = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
      Kokkos::deep_copy(rows, mirror);
    }
    View view;
  };

  static int index(Entity e) { return static_cast<int>(e); }
  [[noreturn]] static void missing(const FieldInfo& info);

  std::array<Size, kEntities> size_{};
  std::map<std::type_index, std::unique_ptr<SlotBase>> slots_;
  std::vector<SlotBase*> order_;
};

}  // namespace breccia
