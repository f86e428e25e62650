#include "tools/base/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <system_error>
#include <utility>

#include "tools/base/descriptor.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

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
bool WriteToInherited(int descriptor, std::span<const std::byte> bytes) {
    const int flags = ::fcntl(descriptor, F_GETFD);
    if (flags > 0 && (flags & FD_CLOEXEC) != 0) errno = EBADF;
    return flags == 0 && WriteAll(descriptor, bytes);
}

// Opens a file that is there, has `write` write to it, closes it.
template <typename Write>
bool WithOpen(const std::string& path, Write write) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.Number() < 0) return false;
    const bool isWritten = write(file.Number());
    const int error = errno;
    const bool isClosed = file.Close();
    if (!isWritten) errno = error;
    return isWritten && isClosed;
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

std::optional<int> DescriptorOf(const std::string& path) {
    return Follow(path).descriptor;
}

OutputFile::OutputFile(std::string path, std::span<const std::byte> bytes)
    : m_path(std::move(path)), m_bytes(bytes) {}

bool OutputFile::Prepare() {
    const Target target = Follow(m_path);
    m_target = target.path;
    if (target.descriptor) return m_isWritten = WriteToInherited(*target.descriptor, m_bytes);
    struct stat old = {};
    const bool exists = ::stat(m_path.c_str(), &old) == 0;
    if (!exists && errno != ENOENT) return false;
    if (exists && !S_ISREG(old.st_mode))
        return m_isWritten = WithOpen(m_path, [&](int file) { return WriteAll(file, m_bytes); });
    if (exists && ::access(m_path.c_str(), W_OK) != 0) return false;  // rename(2) would not ask

    if (exists) m_oldBytes = old.st_size;
    m_temporary.emplace(target.path.parent_path(), exists ? 0600 : 0666);
    const int file = m_temporary->Number();
    if (file < 0 ? exists && IsFolderClosed() : exists && !HandOn(old, file)) {
        m_temporary.reset();
        return true;
    }
    return file >= 0 && WriteAll(file, m_bytes) && m_temporary->Close();
}

bool OutputFile::Commit() {
    if (m_isWritten || (m_temporary && m_temporary->RenameTo(m_target))) return true;
    return (!m_temporary || (m_oldBytes && IsFolderClosed())) && WriteOver();
}

bool OutputFile::WriteOver() {
    return WithOpen(m_path, [&](int file) {
        const auto size = static_cast<off_t>(m_bytes.size());
        if (::fallocate(file, 0, 0, size) != 0 && (errno == ENOSPC || errno == EDQUOT || errno == EFBIG)) {
            const int error = errno;
            if (::ftruncate(file, *m_oldBytes) == 0) errno = error;
            return false;
        }
        return WriteAll(file, m_bytes) && ::ftruncate(file, size) == 0;
    });
}

}  // namespace boxcar
