using Nowpose.Session;
using Nowpose.Session.Hindcast;

namespace Nowpose.Cli.Headset;

/// <summary>Computes the errors of the frames with a current pose, for the whole run and for each stretch between outages.</summary>
sealed class PoseStretches
{
    readonly List<PoseStretch> _stretches = [];
    readonly ErrorRun _errors = new();
    bool _isWithin;

    /// <summary>The errors of all current frames; null while unknown.</summary>
    public HeadsetResult.ErrorResult Total => HeadsetResult.ErrorResult.Of(_errors.Read()?.Times(1000));

    /// <param name="time">Time since the start of the run; must increase.</param>
    /// <param name="isOutage">The value of <see cref="PoseOutages.IsOutage"/> for this frame.</param>
    public void Add(TimeSpan time, PoseState state, ControlTime? displayTime, bool isOutage)
    {
        if (state == PoseState.Current)
        {
            if (!_isWithin) _stretches.Add(new PoseStretch(time, displayTime.Value));
            _isWithin = true;
            _stretches[^1].AddCurrent(time);
            return;
        }

        _isWithin &= !isOutage;
        if (_isWithin) _stretches[^1].AddNotCurrent();
    }

    /// <summary>Adds the error of an earlier frame, in m.</summary>
    /// <param name="displayTime">Display time of the frame.</param>
    /// <param name="state">
    /// State of the frame. Only current frames are scored. The samples after an outage also give errors for the last frames of the outage,
    /// whose pose is older than the outage.
    /// </param>
    public void AddError(ControlTime displayTime, PoseState state, ErrorSums error)
    {
        if (state != PoseState.Current || _stretches.FindLast(stretch => stretch.HasBegunBy(displayTime)) is not { } stretch) return;
        stretch.AddError(error);
        _errors.Add(error);
    }

    public IReadOnlyList<HeadsetResult.StretchResult> Result() => [.. _stretches.Select(stretch => stretch.Result())];
}
