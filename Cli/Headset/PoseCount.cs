using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>Counts the frames with a current pose, and measures the time without one.</summary>
sealed class PoseCount
{
    TimeSpan? _first, _lost;
    TimeSpan _longest, _notCurrent, _previous;
    int _frames, _framesOfRun, _current;

    /// <param name="time">Time since the start of the run; must increase.</param>
    public void Add(TimeSpan time, PoseState state)
    {
        if (state == PoseState.Current) _first ??= time;
        _framesOfRun++;
        if (_first == null) return;
        if (_lost is { } lost)
        {
            // A frame is displayed until the next one.
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

    /// <param name="state">State of the last frame, as named in the diagnostics.</param>
    public HeadsetResult.PoseResult Result(string state) => new(
        state, _first?.TotalSeconds, Share(_frames), _longest.TotalSeconds, Share(_framesOfRun), _notCurrent.TotalSeconds);

    double? Share(int frames) => frames == 0 ? null : (double)_current / frames;
}
