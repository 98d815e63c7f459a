using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>For how many frames the pose was current, and how long it was not.</summary>
sealed class PoseCount
{
    /// <summary>Time that a run allows for the clock's synchronisation before a pose that is not current counts against it.</summary>
    static readonly TimeSpan StartAllowance = TimeSpan.FromSeconds(3);

    TimeSpan? _first, _lost;
    TimeSpan _longest, _notCurrent, _previous;
    int _frames, _framesOfRun, _current;

    /// <param name="time">Since the start; increasing.</param>
    public void Add(TimeSpan time, PoseState state)
    {
        if (state == PoseState.Current) _first ??= time;
        if (_first != null || time >= StartAllowance) _framesOfRun++;
        if (_first == null) return;
        if (_lost is { } lost)
        {
            // A frame stays in view until the next one.
            _notCurrent += time - _previous;
            if (time - lost > _longest) _longest = time - lost;
        }

        _previous = time;
        _frames++;
        if (state == PoseState.Current)
        {
            _current++;
            _lost = null;
            return;
        }

        _lost ??= time;
    }

    /// <param name="state">State of the last frame, as diagnostics name it.</param>
    public HeadsetResult.PoseResult Result(string state) => new(
        state, _first?.TotalSeconds, Share(_frames), _longest.TotalSeconds, Share(_framesOfRun), _notCurrent.TotalSeconds);

    double? Share(int frames) => frames == 0 ? null : (double)_current / frames;
}
