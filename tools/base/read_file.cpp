#include "tools/base/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include "tools/base/descriptor.h"
#include "tools/base/error.h"

namespace boxcar {

std::vector<uint8_t> ReadFile(const std::string& path, const ReadFileOptions& options) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    return ReadDescriptor(file.Number(), options);
}

std::vector<uint8_t> ReadDescriptor(int descriptor, const ReadFileOptions& options) {
    constexpr size_t kStartBytes = 16;
    const auto systemError = [&] { return Error("{}: cannot be read: {}", options.name, std::strerror(errno)); };
    struct stat status = {};
    if (descriptor < 0 || ::fstat(descriptor, &status) != 0) throw systemError();
    if (S_ISDIR(status.st_mode)) throw Error("{}: a folder; a file is expected", options.name);
    const auto requireWithin = [&](uint64_t size) {
        if (size > options.maxBytes)
            throw Error("{}: longer than {} MiB, the most that is read", options.name, options.maxBytes >> 20);
    };
    requireWithin(static_cast<uint64_t>(status.st_size));

    std::vector<uint8_t> bytes;
    const auto resize = [&](size_t size) {
        try {
            bytes.resize(size);
        } catch (const std::bad_alloc&) {
            throw Error("{}: there is not enough memory to read it", options.name);
        }
    };
    resize(std::max<size_t>(static_cast<size_t>(status.st_size) + 1, 1 << 16));
    size_t filled = 0;
    bool isChecked = !options.checkStart;
    for (ssize_t got = -1; got != 0;) {
        if (filled == bytes.size()) resize(2 * filled);
        got = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw systemError();
        filled += static_cast<size_t>(got);
        if (!isChecked && (filled >= kStartBytes || got == 0)) {
            options.checkStart(std::span<const uint8_t>(bytes).first(filled));
            isChecked = true;
        }
        requireWithin(filled);
    }
    resize(filled);
    return bytes;
}

}  // namespace boxcar
