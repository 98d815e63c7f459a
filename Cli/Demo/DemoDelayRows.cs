using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Demo;

/// <summary>The text in table and report about frames that this machine could not run in time; empty if there were very few.</summary>
/// <remarks>A delayed frame shows the pose of its own time. Samples and clock exchanges may be delayed too, which is not measured.</remarks>
sealed class DemoDelayRows(DemoFrames frames)
{
    /// <summary>Minimum delay of a delayed frame: half a frame.</summary>
    static readonly TimeSpan Long = TimeSpan.FromSeconds(0.5 / DemoDisplay.FramesPerSecond);

    /// <summary>Minimum share of delayed frames. Fewer do not change any result.</summary>
    const double WorthSaying = 0.01;

    public IEnumerable<(string Label, string Value)> Rows
    {
        get
        {
            var scored = frames.Rows.Where(row => row.Elapsed >= DemoScore.WarmUp).ToList();
            var delays = scored.Where(row => row.Delay > Long).Select(row => row.Delay.TotalMilliseconds).ToList();
            if (delays.Count > WorthSaying * scored.Count) yield return (DemoTexts.LateFrames, Text(delays, scored.Count));
        }
    }

    static string Text(List<double> delays, int frames) => DemoTexts.LateFramesValue(delays.Count, frames, delays.Max());
}
