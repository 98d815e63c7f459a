using Nowpose.Cli.Messages;
using Nowpose.Prediction;
using Nowpose.Session;

namespace Nowpose.Cli.Replay;

/// <summary>The gaps of a recorded motion: intervals between two rows in which the recording was interrupted.</summary>
/// <remarks>
/// The truth is unknown in a gap. An interval is a gap if it exceeds the maximum gap of a session, and also twice the median interval and twice the
/// sampling interval, so that a recording with few rows has no gaps. Times are in seconds since the start of the recording.
/// </remarks>
sealed class RecordingGaps
{
    const double MinRatio = 2;

    readonly List<(double Start, double End)> _gaps = [];

    /// <param name="times">Times of the rows, increasing.</param>
    /// <param name="samplingInterval">Sampling interval T_s, s.</param>
    public RecordingGaps(IReadOnlyList<double> times, double samplingInterval)
    {
        var session = new PredictionSettings().MaximumGap.TotalSeconds;
        var max = Math.Max(session, MinRatio * Math.Max(RowInterval.Of(times), samplingInterval));
        for (var row = 1; row < times.Count; row++)
            if (times[row] - times[row - 1] > max) _gaps.Add((times[row - 1], times[row]));
        // Predictors ignore samples before a gap, as in a session.
        if (_gaps.Count > 0) Limits = new PredictionLimits(horizonCap: double.PositiveInfinity, maximumGap: max);
    }

    /// <summary>Limits of the predictors: the maximum gap if the recording has gaps, otherwise none.</summary>
    public PredictionLimits Limits { get; } = PredictionLimits.Unlimited;

    /// <summary>Gets the warning about the gaps; null if there are none.</summary>
    public string Warning => _gaps.Count == 0 ? null : ReplayMessages.Gaps(_gaps.Count, _gaps.Max(gap => gap.End - gap.Start));

    /// <summary>Gets whether a time lies within a gap.</summary>
    public bool Includes(double time) => Separates(time, time);

    /// <summary>Gets whether a part of a gap lies between two times.</summary>
    public bool Separates(double earlier, double later)
    {
        var started = SortedSearch.CountUpTo(_gaps, later, gap => gap.Start);
        if (started > 0 && _gaps[started - 1].Start == later) started--;
        return started > 0 && _gaps[started - 1].End > earlier;
    }
}
