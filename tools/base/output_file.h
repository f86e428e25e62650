// Files out: whole or not at all, through links, and to streams.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "tools/base/temporary_file.h"

namespace boxcar {

// The descriptor of this process that `path` stands for: N for /dev/fd/N, 1 for /dev/stdout, and the same for links
// to them.
std::optional<int> DescriptorOf(const std::string& path);

// Bytes on their way to a file. They go to a new file in the same folder, which takes the name with Commit(). Until
// then, or if anything fails, the old file stays as it was. A link stays, and what it points to is written. The new
// file has the owner, group and permissions of the old one, but not its access control lists, extended attributes and
// other hard links.
//
// These are written directly, so a failure halfway leaves an incomplete file:
//   /dev/stdout, /dev/fd/N, ..       by Prepare(): the descriptor as it is, where it stands, at the end if it was
//                                    opened to append
//   not a regular file               by Prepare(): a FIFO, a device such as /dev/null
//   a file whose folder takes no     by Commit(): over its old bytes; what a new file would not keep (above) is kept.
//   new one, or no new one that has  A disk that is full is noticed before the first of them is lost, where the file
//   the same owner and permissions   system can tell
//
// Both functions return false if they fail, and errno says why. Not copyable.
class OutputFile {
public:
    // `bytes` must stay valid until Commit().
    OutputFile(std::string path, std::span<const std::byte> bytes);

    bool Prepare();
    bool Commit();

private:
    bool WriteOver();

    std::string m_path, m_target;  // m_target: where the links of m_path lead
    std::span<const std::byte> m_bytes;
    std::optional<TemporaryFile> m_temporary;
    std::optional<off_t> m_oldBytes;  // of the file that is there
    bool m_isWritten = false;
};

}  // namespace boxcar
