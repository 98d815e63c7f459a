using Nowpose.Cli;
using Nowpose.Cli.Demo;
using Nowpose.Gateway.Plants;

namespace Nowpose.Benchmarks.Links;

/// <summary>Compares the frames of a session with the true values.</summary>
sealed class LinkScore
{
    readonly RecordedFrames _session;
    readonly IDemoTruth _truth;
    readonly TimeSpan _visualisation;
    readonly double _framesPerSecond;
    readonly IReadOnlyList<RecordedFrames.Frame> _scored;
    readonly ToolKinematics _kinematics;

    public LinkScore(RecordedFrames session, IDemoTruth truth, string robot, TimeSpan visualisation, double framesPerSecond)
    {
        if (session.All.Count == 0) throw new InputException("the headset recorded no frame");
        (_session, _truth, _visualisation, _framesPerSecond) = (session, truth, visualisation, framesPerSecond);
        _kinematics = new ToolKinematics(RobotFiles.Load(robot));
        _scored = [.. session.All.SkipWhile(frame => !frame.IsCurrent)];
    }

    /// <param name="profile">Profile of the link.</param>
    /// <param name="linkStart">Headset time at the start of the link. The times of stalls are relative to it.</param>
    public LinkResult Result(LinkProfile profile, HeadsetTime linkStart, int seed)
    {
        var tool = ErrorComparison.Of(_scored.Select(ToolErrorsMm));
        var clock = _scored.Where(frame => frame.Light.HasValue).ToList();
        var errors = clock.Select(frame => ClockError(frame).TotalMicroseconds).ToList();
        var stated = clock.Where(frame => frame.StatedError.HasValue).ToList();
        var stalls = Stalls(profile, linkStart).ToList();
        return new LinkResult(
            profile.Name, seed, _session.All.Count, _scored.Count == 0 ? null : Since(_scored[0].Start),
            Since(_session.FirstIn("coarse", "synchronised")), Since(_session.FirstIn("synchronised")),
            _scored.Count == 0 ? null : _scored.Average(frame => frame.IsCurrent ? 1.0 : 0), LongestNotCurrent(),
            tool?.Reduction, tool?.RmsHold, tool?.Rms, tool?.P95,
            Quantile.OfOrNull(errors, 0.5), Quantile.OfOrNull(errors, 0.99), Quantile.OfOrNull(errors, 1),
            Quantile.OfOrNull(stated.Select(frame => frame.StatedError.Value.TotalMicroseconds), 0.5),
            // A frame without a stated error counts as outside the stated error.
            clock.Count == 0 ? null : clock.Average(frame => ClockError(frame) <= frame.StatedError ? 1.0 : 0),
            Greatest(stalls, stall => FirstAfter(stall.From, isCurrent: false)), Greatest(stalls, stall => FirstAfter(stall.To, isCurrent: true)))
        {
            FrameLateMsP99 = FrameLateMs(0.99),
        };
    }

    (double Hold, double Displayed) ToolErrorsMm(RecordedFrames.Frame frame)
    {
        var truth = _kinematics.TrueAt(_truth, _truth.ControlAt(frame.Start + _visualisation));
        return (_kinematics.At(frame.Held).DistanceMm(truth), _kinematics.At(frame.Joints).DistanceMm(truth));
    }

    // Lateness is relative to the least late frame, because the first frame can be late itself.
    double FrameLateMs(double fraction)
    {
        var late = _session.All.Select((frame, i) => Since(frame.Start).Value - i / _framesPerSecond).ToList();
        return 1000 * (Quantile.Of(late, fraction) - late.Min());
    }

    TimeSpan ClockError(RecordedFrames.Frame frame) =>
        (frame.Light.Value - _visualisation - _truth.ControlAt(frame.Start)).Duration();

    double? Since(HeadsetTime? time) => time is { } t ? (t - _session.All[0].Start).TotalSeconds : null;

    double? LongestNotCurrent()
    {
        if (_scored.Count == 0) return null;
        var longest = TimeSpan.Zero;
        HeadsetTime? lost = null;
        foreach (var frame in _scored)
        {
            if (!frame.IsCurrent) lost ??= frame.Start;
            if (frame.Start - lost > longest) longest = frame.Start - lost.Value;
            if (frame.IsCurrent) lost = null;
        }

        return longest.TotalSeconds;
    }

    // Returns the stalls that begin after the first scored frame and end more than one second before the last one.
    IEnumerable<(HeadsetTime From, HeadsetTime To)> Stalls(LinkProfile profile, HeadsetTime linkStart)
    {
        if (profile.StallInterval == TimeSpan.Zero || _scored.Count == 0) yield break;
        var last = _scored[^1].Start - TimeSpan.FromSeconds(1);
        for (var from = linkStart + profile.StallInterval; from + profile.StallLength < last; from += profile.StallInterval)
            if (from > _scored[0].Start) yield return (from, from + profile.StallLength);
    }

    // Gets the time until the next frame whose pose is current, or not current, in s. If no such frame follows, returns the time until the last
    // scored frame.
    double FirstAfter(HeadsetTime time, bool isCurrent) =>
        ((_scored.FirstOrDefault(frame => frame.Start >= time && frame.IsCurrent == isCurrent) ?? _scored[^1]).Start - time).TotalSeconds;

    static double? Greatest<T>(List<T> items, Func<T, double> value) => items.Count == 0 ? null : items.Max(value);
}
