#include "fieldfab/frep/expression.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "fieldfab/core/error.h"

namespace fieldfab::frep {

/// Members of an `opened` node beyond two arguments.
struct Opened {
  const Node* c;
  SourcePtr source;
};

struct Node {
  Opcode op;
  double constant;
  const Node* a;
  const Node* b;
  std::size_t hash;
  mutable std::atomic<std::uint32_t> references{1};
  std::unique_ptr<const Opened> opened;

  [[nodiscard]] const Node* c() const { return opened == nullptr ? nullptr : opened->c; }
  [[nodiscard]] const Source* source() const { return opened == nullptr ? nullptr : opened->source.get(); }
};

namespace {

std::size_t mix(std::size_t seed, std::size_t value) {
  seed ^= value + 0x9e3779b97f4a7c15ULL + (seed << 6) + (seed >> 2);
  return seed * 0xff51afd7ed558ccdULL;
}

struct Key {
  Opcode op;
  double constant;
  const Node* a;
  const Node* b;
  const Node* c = nullptr;
  SourcePtr source = nullptr;
  [[nodiscard]] std::size_t hash() const {
    std::size_t seed = mix(static_cast<std::size_t>(op), std::bit_cast<std::uint64_t>(constant));
    seed = mix(seed, reinterpret_cast<std::uintptr_t>(a));
    seed = mix(seed, reinterpret_cast<std::uintptr_t>(b));
    if (source != nullptr) {
      seed = mix(seed, reinterpret_cast<std::uintptr_t>(c));
      seed = mix(seed, reinterpret_cast<std::uintptr_t>(source.get()));
    }
    return seed ^ (seed >> 32);
  }
};

struct HashNode {
  using is_transparent = void;
  std::size_t operator()(const Node* node) const { return node->hash; }
  std::size_t operator()(const std::pair<Key, std::size_t>& key) const { return key.second; }
};

struct EqualNode {
  using is_transparent = void;
  bool operator()(const Node* one, const Node* other) const { return one == other; }
  bool operator()(const std::pair<Key, std::size_t>& key, const Node* node) const { return (*this)(node, key); }
  bool operator()(const Node* node, const std::pair<Key, std::size_t>& key) const {
    return node->op == key.first.op && node->constant == key.first.constant && node->a == key.first.a &&
           node->b == key.first.b && node->c() == key.first.c && node->source() == key.first.source.get();
  }
};

/// All living nodes, in shards to reduce waiting of threads for each other. A count goes from 1 to
/// 0 only under the lock of its shard, so a node found here is alive.
class UniqueNodes {
 public:
  const Node* find_or_make(const Key& key) {
    const std::size_t hash = key.hash();
    Shard& shard = shard_of(hash);
    const std::lock_guard lock(shard.mutex);
    if (const auto found = shard.nodes.find(std::pair(key, hash)); found != shard.nodes.end()) {
      (*found)->references.fetch_add(1, std::memory_order_relaxed);
      return *found;
    }
    auto opened = key.source == nullptr ? nullptr : std::make_unique<const Opened>(Opened{key.c, key.source});
    const Node* node = new Node{key.op, key.constant, key.a, key.b, hash, 1, std::move(opened)};
    for (const Node* argument : {key.a, key.b, key.c})
      if (argument != nullptr) argument->references.fetch_add(1, std::memory_order_relaxed);
    shard.nodes.insert(node);
    return node;
  }

  /// Drops one reference. Frees nodes without references, with an explicit list instead of
  /// recursion.
  void release(const Node* node) {
    std::vector<const Node*> falling{node};
    while (!falling.empty()) {
      const Node* next = falling.back();
      falling.pop_back();
      if (next == nullptr || !drop(next)) continue;
      falling.push_back(next->a);
      falling.push_back(next->b);
      falling.push_back(next->c());
      delete next;
    }
  }

 private:
  struct Shard {
    std::mutex mutex;
    std::unordered_set<const Node*, HashNode, EqualNode> nodes;
  };

  /// Returns true if the last reference is gone and the node is out of the table.
  bool drop(const Node* node) {
    std::uint32_t count = node->references.load(std::memory_order_relaxed);
    while (count > 1)
      if (node->references.compare_exchange_weak(count, count - 1, std::memory_order_acq_rel)) return false;
    Shard& shard = shard_of(node->hash);
    const std::lock_guard lock(shard.mutex);
    if (node->references.fetch_sub(1, std::memory_order_acq_rel) > 1) return false;
    shard.nodes.erase(node);
    return true;
  }

  Shard& shard_of(std::size_t hash) { return shards_[(hash >> 20) % shards_.size()]; }

  std::array<Shard, 32> shards_;
};

UniqueNodes& unique_nodes() {
  // Never destroyed, since expressions in static objects may be destroyed later.
  static auto* nodes = new UniqueNodes;
  return *nodes;
}

}  // namespace

Expression::Expression(double value) : node_(nullptr) {
  if (!std::isfinite(value)) throw Error(ErrorKind::bad_input, "", "a constant must be a finite number");
  if (value == 0) value = 0;  // one zero, so that -0 and 0 are one node
  node_ = unique_nodes().find_or_make({Opcode::constant, value, nullptr, nullptr});
}

Expression::Expression(const Expression& other) noexcept : node_(other.node_) {
  if (node_ != nullptr) node_->references.fetch_add(1, std::memory_order_relaxed);
}

Expression::Expression(Expression&& other) noexcept : node_(std::exchange(other.node_, nullptr)) {}

Expression& Expression::operator=(Expression other) noexcept {
  std::swap(node_, other.node_);
  return *this;
}

Expression::~Expression() {
  if (node_ != nullptr) unique_nodes().release(node_);
}

Expression Expression::x() { return Expression(unique_nodes().find_or_make({Opcode::x, 0, nullptr, nullptr})); }
Expression Expression::y() { return Expression(unique_nodes().find_or_make({Opcode::y, 0, nullptr, nullptr})); }
Expression Expression::z() { return Expression(unique_nodes().find_or_make({Opcode::z, 0, nullptr, nullptr})); }

Expression Expression::make(Opcode op, const Expression& a) {
  if (info(op).arity != 1)
    throw Error(ErrorKind::internal, "Expression::make", "this operation does not take one argument");
  return Expression(unique_nodes().find_or_make({op, 0, a.node_, nullptr}));
}

Expression Expression::make(Opcode op, const Expression& a, const Expression& b) {
  if (info(op).arity != 2)
    throw Error(ErrorKind::internal, "Expression::make", "this operation does not take two arguments");
  return Expression(unique_nodes().find_or_make({op, 0, a.node_, b.node_}));
}

Expression Expression::opened(const SourcePtr& source, const Expression& x, const Expression& y, const Expression& z) {
  if (source == nullptr || source->field == nullptr)
    throw Error(ErrorKind::internal, "Expression::opened", "there is no Field");
  return Expression(unique_nodes().find_or_make({Opcode::opened, 0, x.node_, y.node_, z.node_, source}));
}

SourcePtr Expression::source() const { return node_->opened == nullptr ? nullptr : node_->opened->source; }

Opcode Expression::opcode() const noexcept { return node_->op; }
double Expression::constant() const noexcept { return node_->constant; }

Expression Expression::argument(int index) const {
  const Node* node = index == 0 ? node_->a : index == 1 ? node_->b : node_->c();
  node->references.fetch_add(1, std::memory_order_relaxed);
  return Expression(node);
}

Flat flatten(const Expression& root) {
  Flat flat;
  std::unordered_map<const Node*, std::uint32_t> place;
  std::vector<const Node*> stack{root.id()};
  while (!stack.empty()) {
    const Node* node = stack.back();
    if (place.contains(node)) {
      stack.pop_back();
      continue;
    }
    const bool wait_a = node->a != nullptr && !place.contains(node->a);
    const bool wait_b = node->b != nullptr && !place.contains(node->b);
    const bool wait_c = node->c() != nullptr && !place.contains(node->c());
    if (wait_c) stack.push_back(node->c());
    if (wait_b) stack.push_back(node->b);
    if (wait_a) stack.push_back(node->a);  // pushed last, so that arguments keep their written order
    if (wait_a || wait_b || wait_c) continue;
    stack.pop_back();
    const auto at = [&](const Node* argument) { return argument == nullptr ? 0U : place.at(argument); };
    place.emplace(node, static_cast<std::uint32_t>(flat.order.size()));
    flat.order.push_back({node->op, node->constant, at(node->a), at(node->b), at(node->c()), node->source()});
  }
  return flat;
}

bool has_opened(const Expression& root) {
  const Flat flat = flatten(root);
  return std::any_of(flat.order.begin(), flat.order.end(),
                     [](const auto& entry) { return entry.op == Opcode::opened; });
}

std::size_t node_count(const Expression& root) { return flatten(root).order.size(); }

Expression made_again(const Flat::Entry& entry, std::span<const Expression> made) {
  switch (entry.op) {
    case Opcode::constant: return entry.constant;
    case Opcode::x: return Expression::x();
    case Opcode::y: return Expression::y();
    case Opcode::z: return Expression::z();
    case Opcode::opened:
      return Expression::opened(entry.source->shared_from_this(), made[entry.a], made[entry.b], made[entry.c]);
    default: break;
  }
  return info(entry.op).arity == 1 ? Expression::make(entry.op, made[entry.a])
                                   : Expression::make(entry.op, made[entry.a], made[entry.b]);
}

Expression remap(const Expression& root, const Expression& x, const Expression& y, const Expression& z) {
  const Flat flat = flatten(root);
  std::vector<Expression> made;
  made.reserve(flat.order.size());
  for (const Flat::Entry& entry : flat.order)
    made.push_back(entry.op == Opcode::x   ? x
                   : entry.op == Opcode::y ? y
                   : entry.op == Opcode::z ? z
                                           : made_again(entry, made));
  return made.back();
}

}  // namespace fieldfab::frep
