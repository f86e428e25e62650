// Files that may be packed by gzip, read from front to back.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <span>

#include "samples/files/bytes.h"

namespace boxcar {

// The bytes of a file one after the other, out of gzip's members (bgzip and `cat a.gz b.gz` make several) if that is
// what it is. What follows the last member is not read, as gzip does. Never unpacks more than it is asked for.
//
// Everything throws Error, without the file's name: the packed bytes are damaged.
class Unpacker {
public:
    // `file` must live on.
    explicit Unpacker(ByteView file);
    ~Unpacker();
    Unpacker(const Unpacker&) = delete;

    // Returns how many bytes there were: fewer than were asked for at the end.
    size_t Read(std::span<uint8_t> bytes);

    // Throws Error where there are fewer; `what` names them, in the plural.
    void ReadAll(std::span<uint8_t> bytes, const char* what);

    // The same, of bytes that nobody wants.
    void Skip(uint64_t bytes, const char* what);

    // Reads on to where gzip holds the checksum, if that is within a megabyte. Throws Error where it is cut off.
    void Finish();

private:
    bool OpenNextMember();

    ByteView m_file;
    bool m_isPacked;
    bool m_isAtEnd = false;
    bool m_isCut = false;
    z_stream m_stream = {};
};

// Whether gzip's members begin so.
bool IsPacked(ByteView file);

}  // namespace boxcar
