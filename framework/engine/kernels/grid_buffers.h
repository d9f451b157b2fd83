#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace muelle::engine::kernels {

/// Where the forces of a grid's runs stand between the loop over springs and the pass over nodes: for each run the
/// block's own from `lead` on, behind them the last ones of the block before; or, for a long stride, a ring of blocks,
/// of which the first is repeated behind the last. A buffer reaches back by its stride and no further, so that all of
/// them stay in the cache.
template <class Real>
class GridBuffers {
 public:
  /// \param lanes  nodes, rounded up to a multiple of 8   \param block nodes a block, a multiple of 8
  GridBuffers(int dimension, std::size_t lanes, std::size_t block, const std::vector<std::size_t>& strides)
      : dimension_(static_cast<std::size_t>(dimension)), lanes_(lanes), block_(block) {
    std::size_t size = 0;
    for (const std::size_t stride : strides) {
      buffers_.push_back(bufferFor(stride, size));
      planes_.push_back(buffers_.back().plane);
      size += dimension_ * buffers_.back().plane;
    }
    memory_.resize(size + line);
    own_.resize(strides.size());
    past_.resize(strides.size());
  }

  /// Before the first block: no spring begins before the first node.
  void clear() {
    for (const Buffer& buffer : buffers_) {
      for (std::size_t c = 0; c < dimension_; ++c) {
        Real* plane = start() + buffer.offset + c * buffer.plane;
        Real* zero = plane + (buffer.ring ? buffer.ring : buffer.lead);
        std::fill(zero - buffer.stride, zero, Real(0));
      }
    }
  }

  /// Run r's forces on the nodes of the block that begins there, component 0; see plane().
  Real* own(std::size_t r, std::size_t begin) { return start() + buffers_[r].own(begin); }
  /// From a component to the next.
  std::size_t plane(std::size_t r) const { return planes_[r]; }

  /// Of run r, written for the nodes [from, to) of the block [begin, end): 0 for the others.
  void clearRest(std::size_t r, std::size_t begin, std::size_t from, std::size_t to, std::size_t end) {
    for (std::size_t c = 0; c < dimension_; ++c) {
      Real* plane = own(r, begin) + c * planes_[r];
      std::fill(plane, plane + (from - begin), Real(0));
      std::fill(plane + (to - begin), plane + (end - begin), Real(0));
    }
  }
  /// No spring of run r begins at the node.
  void clearNode(std::size_t r, std::size_t begin, std::size_t node) {
    for (std::size_t c = 0; c < dimension_; ++c) own(r, begin)[c * planes_[r] + (node - begin)] = Real(0);
  }
  /// After all that of run r's block.
  void repeatFirst(std::size_t r, std::size_t begin, std::size_t end) {
    const Buffer& buffer = buffers_[r];
    if (!buffer.ring || begin % buffer.ring != 0) return;
    for (std::size_t c = 0; c < dimension_; ++c) {
      Real* plane = own(r, begin) + c * buffer.plane;
      std::copy(plane, plane + (end - begin), plane + buffer.ring);
    }
  }

  /// What the pass over the block's nodes is given.
  const Real* const* ownOfAll(std::size_t begin) {
    for (std::size_t r = 0; r < own_.size(); ++r) own_[r] = own(r, begin);
    return own_.data();
  }
  const Real* const* pastOfAll(std::size_t begin) {
    for (std::size_t r = 0; r < past_.size(); ++r) past_[r] = start() + buffers_[r].past(begin);
    return past_.data();
  }
  const std::size_t* planes() const { return planes_.data(); }

  /// After the pass over the block: what the next one needs.
  void keepPast(std::size_t begin, std::size_t end) {
    if (end == lanes_) return;
    for (const Buffer& buffer : buffers_) {
      if (buffer.ring) continue;
      for (std::size_t c = 0; c < dimension_; ++c) {
        Real* own = start() + buffer.own(begin) + c * buffer.plane;
        std::copy(own + (end - begin) - buffer.stride, own + (end - begin), own - buffer.stride);
      }
    }
  }

 private:
  static constexpr std::size_t line = 64 / sizeof(Real);  ///< of the cache

  struct Buffer {
    std::size_t stride, lead, ring, plane, offset;
    std::size_t own(std::size_t begin) const { return offset + lead + (ring ? begin % ring : 0); }
    std::size_t past(std::size_t begin) const {
      return ring ? offset + (begin + ring - stride % ring) % ring : offset + lead - stride;
    }
  };

  static std::size_t roundedUp(std::size_t value, std::size_t unit) { return (value + unit - 1) / unit * unit; }

  Buffer bufferFor(std::size_t stride, std::size_t offset) const {
    Buffer buffer = {stride, 0, 0, 0, offset};
    // A copy of what the next block needs, as long as that is little; or there is no next block.
    if (stride <= 2 * block_ || lanes_ <= block_) {
      buffer.lead = roundedUp(stride, line);
      buffer.plane = buffer.lead + roundedUp(block_, line);
    } else {
      buffer.ring = roundedUp(stride, block_) + 2 * block_;
      buffer.plane = roundedUp(buffer.ring + block_, line);
    }
    buffer.plane += 9 * line;  // the components apart in the sets of the first cache
    return buffer;
  }

  Real* start() {
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
    return memory_.data() + (line - address / sizeof(Real) % line) % line;
  }

  std::size_t dimension_, lanes_, block_;
  std::vector<Buffer> buffers_;
  std::vector<std::size_t> planes_;
  std::vector<Real> memory_;
  std::vector<const Real*> own_, past_;
};

}  // namespace muelle::engine::kernels
