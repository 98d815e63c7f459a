using System.CommandLine;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>calibrate</c>: measures the visualisation latency and the constant-latency range. Each method is a subcommand.</summary>
static class CalibrateVerb
{
    public static Command Create() => new(
        "calibrate", "Determine the visualisation latency and the constant-latency range. Each method writes a profile for the headset and a page.")
    {
        VlcVerb.Create(), HeadVerb.Create(), RangeVerb.Create(), SineVerb.Create(), NudgeVerb.Create(), SimulateVerb.Create(),
    };
}
