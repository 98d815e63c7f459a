using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>For how many frames the pose was current, and how long it was not.</summary>
sealed class PoseCount
{
    TimeSpan? _first, _lost;
    TimeSpan _longest;
    PoseState _state = PoseState.Incomplete;
    int _frames, _current;

    /// <param name="time">Since the start; increasing.</param>
    public void Add(TimeSpan time, PoseState state)
    {
        _state = state;
        if (state == PoseState.Current) _first ??= time;
        if (_first == null) return;
        _frames++;
        if (state == PoseState.Current)
        {
            _current++;
            _lost = null;
            return;
        }

        _lost ??= time;
        if (time - _lost.Value > _longest) _longest = time - _lost.Value;
    }

    public HeadsetResult.PoseResult Result() => new(
        _state.ToString().ToLowerInvariant(), _first?.TotalSeconds, _frames == 0 ? null : (double)_current / _frames, _longest.TotalSeconds);
}
