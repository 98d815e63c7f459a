using System.Globalization;

namespace Nowpose.Cli.Demo;

/// <summary>What table and report say of frames that this machine had no time for; nothing where there were hardly any.</summary>
/// <remarks>A delayed frame shows the pose of its own time. But what delays frames delays samples and clock exchanges, too, unseen.</remarks>
sealed class DemoDelayWords(DemoFrames frames)
{
    /// <summary>Half a frame.</summary>
    static readonly TimeSpan Long = TimeSpan.FromSeconds(0.5 / DemoDisplay.FramesPerSecond);

    /// <summary>Of all frames: fewer move no figure.</summary>
    const double WorthSaying = 0.01;

    public IEnumerable<(string Label, string Value)> Rows
    {
        get
        {
            var scored = frames.Rows.Where(row => row.Elapsed >= DemoScore.WarmUp).ToList();
            var delays = scored.Where(row => row.Delay > Long).Select(row => row.Delay.TotalMilliseconds).ToList();
            if (delays.Count > WorthSaying * scored.Count) yield return ("frames that began late", Text(delays, scored.Count));
        }
    }

    static string Text(List<double> delays, int frames) => string.Create(
        CultureInfo.InvariantCulture,
        $"{delays.Count} of {frames}, by up to {delays.Max():0} ms: this machine was busy, and delays and errors are larger for it");
}
