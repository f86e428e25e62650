#include "samples/files/stb.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <set>
#include <utility>

namespace boxcar {
namespace {

// The blocks that one decoding holds. stb asks by way of three macros that carry no context, so the pool is found
// through the thread; whatever stb leaves behind, above all when a callback throws, goes with the pool.
class StbMemory {
public:
    explicit StbMemory(uint64_t maxBlockBytes) : m_maxBlockBytes(maxBlockBytes) { s_current = this; }
    ~StbMemory() {
        for (void* block : m_blocks)
            std::free(block);
        s_current = nullptr;
    }
    StbMemory(const StbMemory&) = delete;
    StbMemory& operator=(const StbMemory&) = delete;

    static StbMemory& Current() { return *s_current; }

    // As realloc. A stream that unpacks to more than its picture ends here.
    void* Reallocate(void* block, size_t bytes) {
        if (bytes > m_maxBlockBytes) return nullptr;
        auto owned = m_blocks.extract(block);  // before realloc may make the pointer one to nothing
        void* moved = std::realloc(block, bytes);
        if (moved != nullptr) {
            m_blocks.insert(moved);
        } else if (owned) {
            m_blocks.insert(std::move(owned));
        }
        return moved;
    }

    void Free(void* block) {
        m_blocks.erase(block);
        std::free(block);
    }

private:
    static thread_local StbMemory* s_current;
    uint64_t m_maxBlockBytes;
    std::set<void*> m_blocks;
};

thread_local StbMemory* StbMemory::s_current = nullptr;

[[noreturn]] void StbAssertFailed(const char* condition) {
    throw Error("damaged picture ({} does not hold)", condition);
}

}  // namespace
}  // namespace boxcar

#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_HDR
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 65536
#define STBI_MALLOC(bytes) boxcar::StbMemory::Current().Reallocate(nullptr, bytes)
#define STBI_REALLOC(block, bytes) boxcar::StbMemory::Current().Reallocate(block, bytes)
#define STBI_FREE(block) boxcar::StbMemory::Current().Free(block)
#define STBI_ASSERT(condition) ((condition) ? void() : boxcar::StbAssertFailed(#condition))
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

namespace boxcar {
namespace {

// The file as stb draws it in. stb takes zeros for what is missing, and so would make up the rest of a picture; here
// the first byte beyond the end throws.
class StbReader {
public:
    StbReader(ByteView file, FileFormat format) : m_rest(file), m_format(format) {}

    static int Read(void* self, char* data, int bytes) { return static_cast<StbReader*>(self)->Read(data, bytes); }
    static void Skip(void* self, int bytes) { static_cast<StbReader*>(self)->Skip(bytes); }
    static int AtEnd(void* self) { return static_cast<StbReader*>(self)->m_rest.empty(); }

private:
    int Read(char* data, int bytes) {
        // Only when it fills its own buffer does stb ask for more than it needs.
        const bool needsAll = bytes != sizeof(stbi__context::buffer_start);
        const int got = static_cast<int>(std::min<size_t>(static_cast<size_t>(bytes), m_rest.size()));
        if (got == 0 || (needsAll && got < bytes)) throw CutOff(m_format);
        std::memcpy(data, m_rest.data(), static_cast<size_t>(got));
        Skip(got);
        return got;
    }

    void Skip(int bytes) {
        if (static_cast<size_t>(bytes) > m_rest.size()) throw CutOff(m_format);
        m_rest = m_rest.subspan(static_cast<size_t>(bytes));
    }

    ByteView m_rest;
    FileFormat m_format;
};

constexpr stbi_io_callbacks kCallbacks = {&StbReader::Read, &StbReader::Skip, &StbReader::AtEnd};

// `load` is one of stbi_load.., `scale` what its largest sample stands for.
template <typename Load>
void ReadSamples(ByteView file, FileFormat format, Load load, float scale, Picture& picture) {
    StbReader reader(file, format);
    int width = 0;
    int height = 0;
    int channels = 0;
    stbi__g_failure_reason = "unreadable";  // stb does not give a reason every time
    const auto* samples = load(&kCallbacks, &reader, &width, &height, &channels, 0);
    if (samples == nullptr)
        throw Error("damaged {0}, or a kind of {0} that is not read ({1})", FormatName(format),
                    stbi_failure_reason());
    if (static_cast<uint32_t>(width) != picture.widthTexels || static_cast<uint32_t>(height) != picture.heightTexels)
        throw Error("damaged {}: its header says two sizes", FormatName(format));

    picture.channels = static_cast<uint32_t>(channels);
    picture.samples.resize(size_t{picture.widthTexels} * picture.heightTexels * picture.channels);
    std::transform(samples, samples + picture.samples.size(), picture.samples.begin(),
                   [scale](auto sample) { return static_cast<float>(sample) / scale; });
}

}  // namespace

Picture DecodeWithStb(ByteView file, FileFormat format, SampleType sampleType, uint64_t widthTexels,
                      uint64_t heightTexels) {
    // The largest blocks: the packed stream, doubled as it grows; 16-bit RGBA, the same; JPEG planes, whole MCUs.
    const StbMemory memory(2 * file.size() + 16 * (widthTexels + 64) * (heightTexels + 64));
    Picture picture = MakePicture(widthTexels, heightTexels, 0, sampleType);
    switch (sampleType) {
        case SampleType::Unorm8: ReadSamples(file, format, stbi_load_from_callbacks, 255.0f, picture); break;
        case SampleType::Unorm16: ReadSamples(file, format, stbi_load_16_from_callbacks, 65535.0f, picture); break;
        case SampleType::Float32: ReadSamples(file, format, stbi_loadf_from_callbacks, 1.0f, picture); break;
    }
    return picture;
}

}  // namespace boxcar
