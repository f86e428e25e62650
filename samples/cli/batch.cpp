#include "samples/cli/batch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "samples/cli/console.h"
#include "samples/files/bytes.h"

namespace boxcar {
namespace {

// "[3/12] holiday.jpg" on a terminal; nothing elsewhere.
class Progress {
public:
    Progress(size_t total) : m_total(total), m_shown(isatty(STDERR_FILENO)) {}
    ~Progress() { Clear(); }

    void Next(const std::string& name) {
        Clear();
        m_done++;
        if (m_shown) fmt::print(stderr, "[{}/{}] {}", m_done, m_total, Printable(name));
    }
    void Clear() const {
        if (m_shown) fmt::print(stderr, "\r\033[K");
    }

private:
    size_t m_total;
    size_t m_done = 0;
    bool m_shown;
};

}  // namespace

void AddBatchOptions(CLI::App& command, BatchOptions& options) {
    command.add_option("IN", options.files.inputs, "PNG, JPEG, HDR, EXR or PFM pictures; - is standard input")
        ->required();
    command.add_option("-o,--output", options.files.output, "File, folder/ or - for standard output")
        ->required()
        ->type_name("OUT");
    AddFormatOption(command, options.files.formatWord);
    AddReadOptions(command, options.read);
    AddDeviceOptions(command, options.device);
    command.add_flag("--stats", options.stats,
                     "Print device, passes, milliseconds a pass and device memory to stderr");
    command.add_flag("--json", options.json,
                     "Print the same as one JSON document on stdout; bytes of names that are not UTF-8 as \\xHH");
}

void RunBatch(const std::string& command, const BatchOptions& options, const std::vector<Job>& jobs,
              const Work& work) {
    if (options.json && IsStandardOutput(options.files.output))
        throw UsageError("--json and -o {} would both write to standard output", options.files.output);
    CheckedDevice device(options.device);
    nlohmann::ordered_json document = {{"command", command},
                                       {"device", device->Info().name},
                                       {"driver", device->Info().driver},
                                       {"results", nlohmann::ordered_json::array()}};
    size_t failed = 0;
    Progress progress(jobs.size());
    for (const Job& job : jobs) {
        progress.Next(job.input);
        try {
            const Stats stats = work(*device, job);
            progress.Clear();
            if (options.stats) PrintStats(stats, device->Info());
            document["results"].push_back(ToJson(stats));
        } catch (const Error& error) {
            if (jobs.size() == 1) throw;
            progress.Clear();
            PrintProblem(error.what());
            document["results"].push_back({{"input", job.input}, {"error", error.what()}});
            failed++;
        }
    }
    progress.Clear();
    if (options.json) PrintJson(document);
    device.RequireClean();
    if (failed > 0) throw Error("{} of {} inputs failed", failed, jobs.size());
}

}  // namespace boxcar
