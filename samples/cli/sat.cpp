#include <memory>

#include "runtime/passes/summed_area_table.h"
#include "samples/cli/batch.h"
#include "samples/cli/device_run.h"
#include "samples/cli/filter.h"
#include "samples/cli/light.h"

namespace boxcar {
namespace {

Stats WriteTable(Device& device, const Job& job, const ReadOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferFor(picture, options);
    const Extent2D extent{picture.widthTexels, picture.heightTexels};

    SummedAreaTable table(device, {.extent = extent, .taps = Taps(options)});
    DeviceRun run = RunOnDevice(
        device, extent, ToLight(picture, transfer),
        [&](CommandList& commands, const Image& source) -> const Image& { return table.Record(commands, source); });

    WritePicture(FromLight(run.texels, picture, transfer, SampleType::Float32), job.output, job.format,
                 SampleType::Float32);
    return {job.input, job.output, extent, std::move(run.passes), run.deviceBytes};
}

}  // namespace

void AddSatCommand(CLI::App& app) {
    const auto options = std::make_shared<BatchOptions>();
    CLI::App& command = *app.add_subcommand("sat", "Write the summed-area table of a picture, as floats");
    command.footer(
        "Entry (x, y) is the sum of all texels left of and above it, itself included, in float32. Under srgb the "
        "sums\n"
        "are of linear light, colours times alpha.\n\n"
        "Example:\n"
        "  boxcar sat photo.png -o table.exr --transfer raw");
    AddBatchOptions(command, *options);
    command.callback([options] {
        const std::vector<Job> jobs = PlanJobs(options->files);
        for (const Job& job : jobs)
            if (job.format != FileFormat::Exr && job.format != FileFormat::Pfm)
                throw UsageError("-o {}: a table needs a float format, .exr or .pfm", job.output);
        RunBatch("sat", *options, jobs,
                 [&](Device& device, const Job& job) { return WriteTable(device, job, options->read); });
    });
}

}  // namespace boxcar
