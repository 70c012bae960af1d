#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace rasterwalk {

/// Memory that begins at a line of the processor's cache, so that a load of many lanes never needs
/// two lines.
template <class Value>
struct CacheAligned {
    using value_type = Value;

    CacheAligned() = default;
    template <class Other>
    explicit CacheAligned(const CacheAligned<Other>&) {}

    static constexpr std::align_val_t line{64};
    Value* allocate(std::size_t count) {
        return static_cast<Value*>(::operator new(count * sizeof(Value), line));
    }
    void deallocate(Value* memory, std::size_t) { ::operator delete(memory, line); }

    friend bool operator==(const CacheAligned&, const CacheAligned&) { return true; }
};

template <class Value>
using AlignedVector = std::vector<Value, CacheAligned<Value>>;

} // namespace rasterwalk
