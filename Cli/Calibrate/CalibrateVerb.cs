using System.CommandLine;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>calibrate</c>: measures the visualisation latency and the constant-latency range. Each method is a subcommand.</summary>
static class CalibrateVerb
{
    public static Command Create() => new Command(
        "calibrate", "Determine the visualisation latency and the constant-latency range. Each method writes a page and a profile for the headset; "
        + "sine writes a profile only with --app-ms or --visu-ms. simulate writes test data instead.")
    {
        VlcVerb.Create(), HeadVerb.Create(), RangeVerb.Create(), SineVerb.Create(), NudgeVerb.Create(), SimulateVerb.Create(),
    };
}
