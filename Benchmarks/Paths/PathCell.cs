using System.Globalization;
using Nowpose.Simulation;

namespace Nowpose.Benchmarks.Paths;

/// <summary>Runs of one change of one size on one link, and whether they keep the limits that are required.</summary>
sealed class PathCell
{
    /// <summary>Greatest error in parts of what physics allows, on top of the link's error without a change.</summary>
    const double ErrorFactor = 1.2;

    /// <summary>Greatest distance of the skew from its value before, ppm, on links that allow it.</summary>
    const double LeastMaxSkewPpm = 5;

    /// <summary>
    /// Greatest distance of the skew in parts of that without a change. Once the least delays of both directions have changed, exchanges before
    /// and after tell the skew only separately: half as many in half the time each, which doubles the standard error.
    /// </summary>
    const double SkewFactor = 2;

    /// <summary>Size from which on the skew has a limit, ms: less is close to what the jitter hides.</summary>
    const double MinSizeForSkewMs = 2;

    const double MinWithin = 0.99;

    readonly string _name;
    readonly double _physicsMs, _ownErrorMs, _ownSkewPpm, _errorMs, _within;
    readonly bool _isSkewLimited;

    /// <param name="runs">With the change.</param>
    /// <param name="undisturbed">The same link and seeds without a change.</param>
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
        _within = runs.Average(run => run.Within);
    }

    /// <summary>Greatest distance of the skew from its value before the change, ppm.</summary>
    public double SkewPpm { get; }

    double MaxErrorMs => (ErrorFactor * _physicsMs) + _ownErrorMs;

    double MaxSkewPpm => Math.Max(LeastMaxSkewPpm, SkewFactor * _ownSkewPpm);

    /// <summary>A line for each limit that is missed; empty when all limits are kept.</summary>
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

    /// <summary>Error over what physics allows, skew, share within the stated ±; ** where a limit is missed.</summary>
    public override string ToString()
    {
        var text = Text($"{_errorMs:0.00} / {_physicsMs:0.##} ms, {SkewPpm:0.0} ppm, {100 * _within:0} %");
        return Missed.Any() ? $"**{text}**" : text;
    }

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
