using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Demo;

/// <summary>
/// Creates a row for the table and the report if this machine started more than 1 % of the frames late. Otherwise, creates none.
/// </summary>
/// <remarks>A late frame shows the pose for its actual start time. Samples and sync exchanges can also be late; this is not measured.</remarks>
sealed class DemoDelayRows(DemoFrames frames)
{
    /// <summary>Minimum delay of a frame that counts as late: half a frame interval.</summary>
    static readonly TimeSpan Long = TimeSpan.FromSeconds(0.5 / DemoDisplay.FramesPerSecond);

    /// <summary>Share of late frames above which they are reported. A smaller share does not change the results.</summary>
    const double MinShare = 0.01;

    public IEnumerable<(string Label, string Value)> Rows
    {
        get
        {
            var scored = frames.Rows.Where(row => row.Elapsed >= DemoScore.WarmUp).ToList();
            var delays = scored.Where(row => row.Delay > Long).Select(row => row.Delay.TotalMilliseconds).ToList();
            if (delays.Count > MinShare * scored.Count) yield return (DemoTexts.LateFrames, Text(delays, scored.Count));
        }
    }

    static string Text(List<double> delays, int frames) => DemoTexts.LateFramesValue(delays.Count, frames, delays.Max());
}
