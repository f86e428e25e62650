#pragma once

#include <cstddef>
#include <span>
#include <utility>

namespace boxcar {

// An open file descriptor that closes itself, or none.
class Descriptor {
public:
    // number  as of open(2): negative is none
    explicit Descriptor(int number = -1) : m_number(number) {}
    ~Descriptor() { Close(); }
    Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(m_number, other.m_number);
        return *this;
    }

    int Number() const { return m_number; }

    // As close(2): on some file systems only this reports that the disk is full. True if there is none.
    bool Close();

private:
    int m_number;
};

// Writes all of `bytes`, with as many calls of write(2) as it takes. Waits if the descriptor is a non-blocking pipe
// that is full. Returns false if it fails, and errno says why.
bool WriteAll(int descriptor, std::span<const std::byte> bytes);

}  // namespace boxcar
