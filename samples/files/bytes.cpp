#include "samples/files/bytes.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "tools/layout/error.h"
#include "tools/layout/temporary_file.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

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
        if (written > 0) bytes = bytes.subspan(static_cast<size_t>(written));
        if (written >= 0 || errno == EINTR) continue;
        pollfd wait = {fd, POLLOUT, 0};  // a pipe that does not block
        if (errno != EAGAIN || ::poll(&wait, 1, -1) < 0) return false;
    }
    return true;
}

// The number in /proc/self/fd/N, /dev/fd/N and the like.
std::optional<int> DescriptorNumber(const fs::path& path) {
    std::error_code missing;
    const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", missing);
    if (missing) return {};
    for (const char* own : {"/proc/self/fd", "/proc/thread-self/fd"}) {
        if (fs::canonical(own, missing) != folder || missing) continue;
        const std::string name = path.filename();
        int number = -1;
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
        if (error == std::errc() && end == name.data() + name.size()) return number;
    }
    return {};
}

// Where the links of a path lead: a descriptor of this process, or a name that is no link (there may be no such file
// yet).
struct Target {
    fs::path path;
    std::optional<int> descriptor;
};
Target Follow(fs::path path) {
    constexpr int kMaxLinks = 40;  // as Linux does; then opening it says ELOOP
    for (int i = 0; i < kMaxLinks; i++) {
        if (const auto number = DescriptorNumber(path)) return {path, number};
        std::error_code isNoLink;
        const fs::path next = fs::read_symlink(path, isNoLink);
        if (isNoLink) break;
        path = path.parent_path() / next;
    }
    return {path, {}};
}

// Writes to a descriptor that the process was started with. Its own close when it runs another program.
void WriteToDescriptor(const std::string& path, int fd, ByteView bytes) {
    const int flags = ::fcntl(fd, F_GETFD);
    if (flags > 0 && (flags & FD_CLOEXEC) != 0) errno = EBADF;
    if (flags != 0 || !WriteAll(fd, bytes)) throw WriteError(path);
}

void WriteDirectly(const std::string& path, ByteView bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file < 0 || !WriteAll(file, bytes) || !file.Close()) throw WriteError(path);
}

void WriteOver(const std::string& path, uint64_t oldBytes, ByteView bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    const auto size = static_cast<off_t>(bytes.size());
    if (file >= 0 && ::fallocate(file, 0, 0, size) != 0 && (errno == ENOSPC || errno == EDQUOT || errno == EFBIG)) {
        const Error error = WriteError(path);
        if (::ftruncate(file, static_cast<off_t>(oldBytes)) != 0) throw WriteError(path);
        throw error;
    }
    if (file < 0 || !WriteAll(file, bytes) || ::ftruncate(file, size) != 0 || !file.Close()) throw WriteError(path);
}

// Whether the new file could be made to belong to whom the old one does, with the same permissions.
bool HandOn(const struct stat& old, int newFile) {
    struct stat made = {};
    if (::fstat(newFile, &made) != 0) return false;
    const bool isTheirs = made.st_uid == old.st_uid && made.st_gid == old.st_gid;
    return (isTheirs || ::fchown(newFile, old.st_uid, old.st_gid) == 0) && ::fchmod(newFile, old.st_mode & 0777) == 0;
}

// Whether errno says that a folder takes no new file, or not in this one's place, where the file itself may well be
// written.
bool IsFolderClosed() {
    constexpr std::array kErrors = {EACCES, EPERM, EROFS, EBUSY, EXDEV};
    return std::ranges::find(kErrors, errno) != kErrors.end();
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

bool IsStandardOutput(const std::string& path) {
    return path == "-" || Follow(path).descriptor == STDOUT_FILENO;
}

void WriteFileAtomically(const std::string& path, ByteView bytes) {
    if (path == "-") return WriteToDescriptor(path, STDOUT_FILENO, bytes);
    const Target target = Follow(path);
    if (target.descriptor) return WriteToDescriptor(path, *target.descriptor, bytes);
    struct stat old = {};
    const bool exists = ::stat(path.c_str(), &old) == 0;
    if (!exists && errno != ENOENT) throw WriteError(path);
    if (exists && !S_ISREG(old.st_mode)) return WriteDirectly(path, bytes);
    if (exists && ::access(path.c_str(), W_OK) != 0) throw WriteError(path);  // rename(2) would not ask

    const auto oldBytes = static_cast<uint64_t>(old.st_size);
    TemporaryFile file(target.path.parent_path(), exists ? 0600 : 0666);
    if (file.Descriptor() >= 0) {
        if (exists && !HandOn(old, file.Descriptor())) return WriteOver(path, oldBytes, bytes);
        if (WriteAll(file.Descriptor(), bytes) && file.Close() && file.RenameTo(target.path)) return;
    }
    if (!exists || !IsFolderClosed()) throw WriteError(path);
    WriteOver(path, oldBytes, bytes);
}

}  // namespace boxcar
