using System.Globalization;
using Nowpose.Simulation;

namespace Nowpose.Benchmarks.Paths;

/// <summary>Runs of one change of one size on one link, and whether they keep the limits that are required.</summary>
sealed class PathCell
{
    /// <summary>Greatest error in parts of what physics allows, on top of the link's error without a change.</summary>
    const double ErrorFactor = 1.2;

    const double MaxSkewPpm = 5;

    /// <summary>Size from which on the skew has a limit, ms: less is close to what the jitter hides.</summary>
    const double MinSizeForSkewMs = 2;

    const double MinWithin = 0.99;

    readonly string _name;
    readonly double _physicsMs, _ownErrorMs, _errorMs, _skewPpm, _within;
    readonly bool _isSkewLimited;

    /// <param name="runs">With the change.</param>
    /// <param name="undisturbed">The same link and seeds without a change.</param>
    public PathCell(
        LinkProfile link, PathChange change, double sizeMs, IReadOnlyCollection<PathRun> runs, IReadOnlyCollection<PathRun> undisturbed)
    {
        _name = Text($"{link.Name}, {change.Name}, {sizeMs} ms");
        _physicsMs = change.Limit * sizeMs;
        _ownErrorMs = undisturbed.Max(run => run.ErrorMs);
        _isSkewLimited = sizeMs >= MinSizeForSkewMs;
        _errorMs = runs.Max(run => run.ErrorMs);
        _skewPpm = runs.Max(run => run.SkewPpm);
        _within = runs.Average(run => run.Within);
    }

    double MaxErrorMs => (ErrorFactor * _physicsMs) + _ownErrorMs;

    /// <summary>A line for each limit that is missed; empty when all limits are kept.</summary>
    public IEnumerable<string> Missed
    {
        get
        {
            if (!(_errorMs <= MaxErrorMs)) yield return _name + Text($": error {_errorMs:0.00} ms; the limit is {MaxErrorMs:0.00} ms");
            if (_isSkewLimited && !(_skewPpm <= MaxSkewPpm))
                yield return _name + Text($": skew moved by {_skewPpm:0.0} ppm; the limit is {MaxSkewPpm} ppm");
            if (!(_within >= MinWithin))
                yield return _name + Text($": error within the stated ± in {100 * _within:0.0} % of the time; at least {100 * MinWithin} % are required");
        }
    }

    /// <summary>Error over what physics allows, skew, share within the stated ±; ** where a limit is missed.</summary>
    public override string ToString()
    {
        var text = Text($"{_errorMs:0.00} / {_physicsMs:0.##} ms, {_skewPpm:0.0} ppm, {100 * _within:0} %");
        return Missed.Any() ? $"**{text}**" : text;
    }

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
