using Nowpose.Session;
using Nowpose.Session.Hindcast;

namespace Nowpose.Cli.Headset;

/// <summary>A part of a run between two outages, from its first to its last frame with a current pose.</summary>
sealed class PoseStretch(TimeSpan from, ControlTime displayTime)
{
    readonly ErrorRun _errors = new();
    int _frames, _notCurrent, _current;
    TimeSpan _to;

    /// <param name="time">Time since the start of the run.</param>
    public void AddCurrent(TimeSpan time)
    {
        _to = time;
        _current++;
        _frames += 1 + _notCurrent;
        _notCurrent = 0;
    }

    /// <summary>Adds a frame without a current pose. The frame counts only if a current frame follows it in this stretch.</summary>
    public void AddNotCurrent() => _notCurrent++;

    /// <summary>Gets whether this stretch had begun by a display time.</summary>
    public bool HasBegunBy(ControlTime at) => displayTime <= at;

    /// <summary>Adds the error of a current frame, m.</summary>
    public void AddError(in ErrorSums error) => _errors.Add(error);

    public HeadsetResult.StretchResult Result() => new(
        from.TotalSeconds, _to.TotalSeconds, (double)_current / _frames, HeadsetResult.ErrorResult.Of(_errors.Read()?.Times(1000)));
}
