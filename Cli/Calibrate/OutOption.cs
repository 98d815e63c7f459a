using System.CommandLine;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>--out</c> and <c>--json</c>: options that all calibration methods share.</summary>
static class OutOption
{
    public static Option<string> Create() => new("--out")
    {
        Description = "Folder for profile.json, calibration.html and, for pictures, pairs.csv",
        DefaultValueFactory = _ => "nowpose-calibration",
    };

    public static Option<bool> Json() => new("--json") { Description = "Print JSON instead of a table" };
}
