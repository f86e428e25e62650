#include "samples/files/bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include "tools/base/descriptor.h"
#include "tools/base/error.h"
#include "tools/base/output_file.h"

namespace boxcar {
namespace {

Error ReadError(const std::string& path) {
    return Error("{}: cannot be read: {}", InputName(path), std::strerror(errno));
}

// An open file, or -1 where open(2) failed. Standard input stays open.
class Descriptor {
public:
    explicit Descriptor(int fd) : m_fd(fd) {}
    ~Descriptor() {
        if (m_fd > STDIN_FILENO) ::close(m_fd);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    operator int() const { return m_fd; }

private:
    int m_fd;
};

}  // namespace

std::string InputName(const std::string& path) {
    return path == "-" ? "standard input" : path;
}
std::string OutputName(const std::string& path) {
    return path == "-" ? "standard output" : path;
}

Bytes ReadBytes(const std::string& path, uint64_t maxBytes, const std::function<void(ByteView)>& checkStart) {
    constexpr size_t kStartBytes = 16;
    const Descriptor file(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status = {};
    if (file < 0 || ::fstat(file, &status) != 0) throw ReadError(path);
    if (S_ISDIR(status.st_mode)) throw Error("{}: a folder; a file is expected", InputName(path));
    const auto requireWithin = [&](uint64_t size) {
        if (size > maxBytes)
            throw Error("{}: longer than {} MiB, the most that is read", InputName(path), maxBytes >> 20);
    };
    requireWithin(static_cast<uint64_t>(status.st_size));

    Bytes bytes;
    const auto resize = [&](size_t size) {
        try {
            bytes.resize(size);
        } catch (const std::bad_alloc&) {
            throw Error("{}: there is not enough memory to read it", InputName(path));
        }
    };
    resize(std::max<size_t>(static_cast<size_t>(status.st_size) + 1, 1 << 16));
    size_t filled = 0;
    bool isChecked = false;
    for (ssize_t got = -1; got != 0;) {
        if (filled == bytes.size()) resize(2 * filled);
        got = ::read(file, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw ReadError(path);
        filled += static_cast<size_t>(got);
        if (!isChecked && (filled >= kStartBytes || got == 0)) {
            checkStart(ByteView(bytes).first(filled));
            isChecked = true;
        }
        requireWithin(filled);
    }
    resize(filled);
    return bytes;
}

bool IsStandardOutput(const std::string& path) {
    return path == "-" || DescriptorOf(path) == STDOUT_FILENO;
}

void WriteFileAtomically(const std::string& path, ByteView bytes) {
    OutputFile file(path, std::as_bytes(bytes));
    const bool isWritten =
        path == "-" ? WriteAll(STDOUT_FILENO, std::as_bytes(bytes)) : file.Prepare() && file.Commit();
    if (!isWritten) throw Error("{}: cannot be written: {}", OutputName(path), std::strerror(errno));
}

}  // namespace boxcar
