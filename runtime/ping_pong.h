// Two images that take turns: each step reads Front() and writes Back(), then Swap().
// Hensley 2005, sect. 3 (two textures, or a pbuffer's two sides: the same idea)
#pragma once

#include <utility>

#include "runtime/image.h"

namespace boxcar {

class PingPong {
public:
    PingPong(Device& device, ImageDesc desc)
        : m_front(device, Named(desc, " A")), m_back(device, Named(desc, " B")) {}

    const Image& Front() const { return m_swapped ? m_back : m_front; }
    const Image& Back() const { return m_swapped ? m_front : m_back; }
    void Swap() { m_swapped = !m_swapped; }

private:
    static ImageDesc Named(ImageDesc desc, const char* suffix) {
        desc.name += suffix;
        return desc;
    }

    Image m_front;
    Image m_back;
    bool m_swapped = false;
};

}  // namespace boxcar
