using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>Splits a run at its outages, so that what was measured before and after one is reported apart.</summary>
sealed class PoseStretches
{
    /// <summary>A pose that is not current for longer is an outage.</summary>
    public static readonly TimeSpan MaxGap = TimeSpan.FromSeconds(1);

    readonly List<PoseStretch> _stretches = [];

    /// <param name="time">Since the start; increasing.</param>
    public void Add(TimeSpan time, PoseState state, ControlTime? displayTime)
    {
        if (state == PoseState.Current)
        {
            if (_stretches.Count == 0 || time - _stretches[^1].To > MaxGap) _stretches.Add(new PoseStretch(time, displayTime.Value));
            _stretches[^1].AddCurrent(time, displayTime.Value);
        }
        else if (_stretches.Count > 0)
        {
            _stretches[^1].AddNotCurrent();
        }
    }

    /// <summary>Takes the error of a frame that was shown before, m.</summary>
    /// <param name="displayTime">The frame's.</param>
    public void AddError(ControlTime displayTime, ErrorSample error) =>
        _stretches.FindLast(stretch => stretch.HasBegunBy(displayTime))?.AddError(displayTime, error);

    public IReadOnlyList<HeadsetResult.StretchResult> Result() => [.. _stretches.Select(stretch => stretch.Result())];
}
