using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>A part of a run between two outages: from its first to its last frame with a current pose.</summary>
sealed class PoseStretch(TimeSpan from, ControlTime displayTime)
{
    readonly ErrorRun _errors = new();
    readonly List<ErrorSample> _pending = [];
    int _frames, _notCurrent, _current;
    ControlTime _lastDisplayTime;

    /// <summary>Start of the last frame with a current pose, since the start of the run.</summary>
    public TimeSpan To { get; private set; }

    /// <param name="time">Since the start of the run.</param>
    public void AddCurrent(TimeSpan time, ControlTime displayTime)
    {
        To = time;
        _lastDisplayTime = displayTime;
        _current++;
        _frames += 1 + _notCurrent;
        _notCurrent = 0;
        foreach (var error in _pending) _errors.Add(error);
        _pending.Clear();
    }

    /// <summary>Counts only when the pose becomes current again before the stretch ends.</summary>
    public void AddNotCurrent() => _notCurrent++;

    /// <summary>Whether a frame was shown after this stretch began.</summary>
    public bool HasBegunBy(ControlTime at) => displayTime <= at;

    /// <summary>Takes the error of a frame. One after the last current frame counts only when the pose becomes current again, as above.</summary>
    public void AddError(ControlTime at, in ErrorSample error)
    {
        if (at <= _lastDisplayTime) _errors.Add(error);
        else if (at - _lastDisplayTime <= PoseStretches.MaxGap) _pending.Add(error);
    }

    public HeadsetResult.StretchResult Result() => new(
        from.TotalSeconds, To.TotalSeconds, (double)_current / _frames, HeadsetResult.ErrorResult.Of(_errors.Read()?.Times(1000)));
}
