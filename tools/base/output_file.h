// Files out: whole or not at all, through links, to streams, beside other people's.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "tools/base/temporary_file.h"

namespace boxcar {

// The descriptor of this process that writing to `path` writes to: N of /dev/fd/N, 1 of /dev/stdout, and of links
// that end there.
std::optional<int> DescriptorOf(const std::string& path);

// Bytes on their way to a file. They go to a new file in the same folder, which takes the name with Commit(): until
// then, or where something fails, the old file is as it was. A link stays, and what it points to is written. A file
// that is replaced hands on its owner, group and permissions; its access control lists, extended attributes and other
// hard links stay with the old bytes.
//
// Written directly, so that a failure in the midst leaves a part:
//   /dev/stdout, /dev/fd/N, ..       by Prepare(): the descriptor as it is, where it stands, at the end if it was
//                                    opened to append
//   no regular file                  by Prepare(): a FIFO, a device such as /dev/null
//   a file whose folder takes no     by Commit(): over its old bytes; what a new file would not keep (above) is kept.
//   new one, or no new one that has  A disk that is full is noticed before the first of them is lost, where the file
//   the same owner and permissions   system can tell
//
// Both functions return false where they fail, and errno says why. Not copyable.
class OutputFile {
public:
    // `bytes` stay the caller's, until Commit().
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
