using System.Globalization;
using Nowpose.Benchmarks.Links;

namespace Nowpose.Benchmarks.Paths;

/// <summary>All runs with one kind and size of change on one link, with their limits.</summary>
sealed class PathCell
{
    /// <summary>
    /// Factor of the physical limit in the maximum error. The error that the same link has without a change is added to the product.
    /// </summary>
    const double ErrorFactor = 1.2;

    /// <summary>Lower bound of the limit for the deviation of the skew from its value before the change, ppm.</summary>
    const double MinSkewLimitPpm = 5;

    /// <summary>
    /// Maximum deviation of the skew relative to the deviation without a change. If the minimum delays in both directions have changed, the
    /// exchanges before and after the change can only be fitted separately. Each part has half of the exchanges in half of the time, so the
    /// mean of both fits has twice the standard error.
    /// </summary>
    const double SkewFactor = 2;

    /// <summary>Minimum size of a change for which the skew is limited, ms. Smaller changes are close to the jitter.</summary>
    const double MinSizeForSkewMs = 2;

    const double MinWithin = 0.99;

    readonly string _name;
    readonly double _physicsMs, _ownErrorMs, _ownSkewPpm, _errorMs, _within, _statedMs;
    readonly bool _isSkewLimited;

    /// <param name="runs">Runs with the change.</param>
    /// <param name="undisturbed">Runs without a change, with the same link and seeds.</param>
    public PathCell(
        LinkProfile link, PathChange change, double sizeMs, IReadOnlyCollection<PathRun> runs, IReadOnlyCollection<PathRun> undisturbed)
    {
        _name = Text($"{link.Name}, {change.Name}, {sizeMs} ms");
        _physicsMs = change.Limit * sizeMs;
        _ownErrorMs = undisturbed.Max(run => run.ErrorMs);
        _ownSkewPpm = undisturbed.Max(run => run.SkewPpm);
        _isSkewLimited = sizeMs >= MinSizeForSkewMs;
        _errorMs = runs.Max(run => run.ErrorMs);
        SkewPpm = runs.Max(run => run.SkewPpm);
        _within = runs.Min(run => run.Within);
        _statedMs = runs.Average(run => run.StatedMs);
    }

    /// <summary>Maximum deviation of the skew from its value before the change, ppm.</summary>
    public double SkewPpm { get; }

    double MaxErrorMs => (ErrorFactor * _physicsMs) + _ownErrorMs;

    double MaxSkewPpm => Math.Max(MinSkewLimitPpm, SkewFactor * _ownSkewPpm);

    /// <summary>One line for each limit that is not met; empty if all limits are met.</summary>
    public IEnumerable<string> Missed
    {
        get
        {
            if (!(_errorMs <= MaxErrorMs)) yield return _name + Text($": error {_errorMs:0.00} ms; the limit is {MaxErrorMs:0.00} ms");
            if (_isSkewLimited && !(SkewPpm <= MaxSkewPpm))
                yield return _name + Text($": skew moved by {SkewPpm:0.0} ppm; the limit is {MaxSkewPpm:0.0} ppm");
            if (!(_within >= MinWithin))
                yield return _name + Text($": error within the stated ± in {100 * _within:0.0} % of the time; at least {100 * MinWithin} % are required");
        }
    }

    /// <summary>
    /// Gets the error and its physical limit, the deviation of the skew, the minimum share within the stated error, and the mean stated error, in
    /// bold type if a limit is not met.
    /// </summary>
    public override string ToString()
    {
        var text = Text($"{_errorMs:0.00} / {_physicsMs:0.##} ms, {SkewPpm:0.0} ppm, {100 * _within:0} %, ± {_statedMs:0.00} ms");
        return Missed.Any() ? $"**{text}**" : text;
    }

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
