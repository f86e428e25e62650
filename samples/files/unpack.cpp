#include "samples/files/unpack.h"

#include <algorithm>
#include <new>
#include <vector>

#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr size_t kChunkBytes = 1 << 16;

}  // namespace

bool IsPacked(ByteView file) {
    return file.size() > 1 && file[0] == 0x1f && file[1] == 0x8b;
}

Unpacker::Unpacker(ByteView file) : m_file(file), m_isPacked(IsPacked(file)) {
    if (!m_isPacked) return;
    m_stream.next_in = const_cast<uint8_t*>(file.data());
    m_stream.avail_in = static_cast<uInt>(file.size());
    constexpr int kGzip = 16 + MAX_WBITS;
    if (inflateInit2(&m_stream, kGzip) != Z_OK) throw std::bad_alloc();
}

Unpacker::~Unpacker() {
    if (m_isPacked) inflateEnd(&m_stream);
}

bool Unpacker::OpenNextMember() {
    return IsPacked({m_stream.next_in, m_stream.avail_in}) && inflateReset(&m_stream) == Z_OK;
}

size_t Unpacker::Read(std::span<uint8_t> bytes) {
    if (!m_isPacked) {
        const size_t count = std::min(bytes.size(), m_file.size());
        std::copy_n(m_file.begin(), count, bytes.begin());
        m_file = m_file.subspan(count);
        return count;
    }
    m_stream.next_out = bytes.data();
    m_stream.avail_out = static_cast<uInt>(bytes.size());
    while (m_stream.avail_out > 0 && !m_isAtEnd) {
        const int result = inflate(&m_stream, Z_NO_FLUSH);
        m_isCut = result == Z_BUF_ERROR;
        if (result == Z_STREAM_END)
            m_isAtEnd = !OpenNextMember();
        else if (m_isCut)
            m_isAtEnd = true;
        else if (result != Z_OK)
            throw Error("it is damaged: its packed bytes contradict themselves");
    }
    return bytes.size() - m_stream.avail_out;
}

void Unpacker::ReadAll(std::span<uint8_t> bytes, const char* what) {
    if (Read(bytes) < bytes.size()) throw Error("it is cut off: its {} are incomplete", what);
}

void Unpacker::Skip(uint64_t bytes, const char* what) {
    std::vector<uint8_t> skipped(kChunkBytes);
    while (bytes > 0) {
        const size_t count = std::min<uint64_t>(bytes, skipped.size());
        ReadAll(std::span(skipped).first(count), what);
        bytes -= count;
    }
}

void Unpacker::Finish() {
    std::vector<uint8_t> rest(kChunkBytes);
    for (int i = 0; i < 16 && Read(rest) == rest.size(); i++) {
    }
    if (m_isCut) throw Error("it is cut off: its packed bytes have no end");
}

}  // namespace boxcar
