using System.Globalization;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

/// <summary>Lines of a gateway's recording of one continuous joint. The replay adds frames at 60 Hz whose L_visu is 0.</summary>
static class JointFile
{
    public const string Header = """
        {"kind":"session","format":"nowpose-session","version":1,"robot":{"name":"r","joints":[{"name":"elbow","unit":"rad"}]},"settings":{"predictor":"linear","horizon_cap_ms":1000,"maximum_gap_ms":500}}
        """;

    /// <param name="stamp">t_k, s.</param>
    /// <param name="arrival">Arrival time on the control clock, s.</param>
    /// <param name="position">Position, rad.</param>
    public static string Sample(double stamp, double arrival, double position) => string.Create(
        CultureInfo.InvariantCulture,
        $$"""{"kind":"sample","arrival_ns":{{Ns(arrival)}},"stamp_ns":{{Ns(stamp)}},"control_arrival_ns":{{Ns(arrival)}},"names":["elbow"],"position":[{{position:R}}]}""");

    // Starts a day after the epoch, so that no stamp is 0.
    static long Ns(double seconds) => 86_400_000_000_000 + (long)Math.Round(seconds * 1e9);
}
