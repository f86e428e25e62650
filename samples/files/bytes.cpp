#include "samples/files/bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "tools/layout/error.h"

namespace boxcar {
namespace {

Error ReadError(const std::string& path) {
    return Error("{}: cannot be read: {}", InputName(path), std::strerror(errno));
}

Error WriteError(const std::string& path) {
    return Error("{}: cannot be written: {}", OutputName(path), std::strerror(errno));
}

// An open file, or -1 where open(2) failed. The standard streams stay open.
class Descriptor {
public:
    explicit Descriptor(int fd) : m_fd(fd) {}
    ~Descriptor() { Close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    operator int() const { return m_fd; }

    // As close(2): some file systems only now say that the disk is full.
    bool Close() { return m_fd <= STDERR_FILENO || ::close(std::exchange(m_fd, -1)) == 0; }

private:
    int m_fd;
};

bool WriteAll(int fd, ByteView bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) return false;
        if (written > 0) bytes = bytes.subspan(static_cast<size_t>(written));
    }
    return true;
}

void WriteDirectly(const std::string& path, ByteView bytes) {
    Descriptor file(path == "-" ? STDOUT_FILENO : ::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file < 0 || !WriteAll(file, bytes) || !file.Close()) throw WriteError(path);
}

// Makes a new file in `folder` and sets `path` to it; -1 as open(2). mkstemp would make it unreadable to others,
// where this one has what the umask allows.
int CreateTemporary(const std::filesystem::path& folder, std::filesystem::path& path) {
    for (int i = 0;; ++i) {
        path = folder / fmt::format(".boxcar-{}-{}", ::getpid(), i);
        const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST) return fd;
    }
}

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

void WriteFileAtomically(const std::string& path, ByteView bytes) {
    struct stat old = {};
    const bool exists = path != "-" && ::stat(path.c_str(), &old) == 0;
    if (path == "-" || (exists && !S_ISREG(old.st_mode))) return WriteDirectly(path, bytes);
    if (exists && ::access(path.c_str(), W_OK) != 0) throw WriteError(path);  // rename(2) would not ask

    std::error_code ignored;  // an empty target cannot be written either
    const std::filesystem::path target =
        exists ? std::filesystem::canonical(path, ignored) : std::filesystem::path(path);
    std::filesystem::path temporary;
    Descriptor file(CreateTemporary(target.parent_path(), temporary));
    if (file < 0) throw WriteError(path);
    if (exists) ::fchmod(file, old.st_mode & 0777);
    if (WriteAll(file, bytes) && file.Close() && ::rename(temporary.c_str(), target.c_str()) == 0) return;
    const Error error = WriteError(path);
    ::unlink(temporary.c_str());
    throw error;
}

}  // namespace boxcar
