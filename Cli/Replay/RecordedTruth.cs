using Nowpose.Prediction;
using Nowpose.Session.Hindcast;

namespace Nowpose.Cli.Replay;

/// <summary>The true position of a joint in one run of its source: a cubic interpolation of its samples over control time.</summary>
/// <remarks>
/// Uses the same cubic as the headset's hindcast. The truth is unknown before the first sample, after the last one, and between two samples
/// whose interval exceeds the maximum gap. The positions of a continuous joint are unwrapped.
/// </remarks>
sealed class RecordedTruth : SampleRun
{
    readonly List<(long Ticks, double Position)> _samples = [];
    readonly long _maximumGap;
    readonly bool _isEndless;
    bool _isSorted = true;

    /// <param name="isEndless">Whether positions are angles in rad that may wrap from π to −π.</param>
    public RecordedTruth(int timeLine, TimeSpan maximumGap, bool isEndless) : base(timeLine) => (_maximumGap, _isEndless) = (maximumGap.Ticks, isEndless);

    public void Add(ControlTime at, double position)
    {
        Extend(at);
        var ticks = at.SinceEpoch.Ticks;
        _isSorted &= _samples.Count == 0 || _samples[^1].Ticks < ticks;
        _samples.Add((ticks, position));
    }

    /// <summary>
    /// Sorts the samples, keeps the first of several with the same time, and unwraps the positions. Must be called after the last sample.
    /// </summary>
    public void Complete()
    {
        Sort();
        for (var i = 1; i < _samples.Count && _isEndless; i++)
            _samples[i] = (_samples[i].Ticks, _samples[i - 1].Position + Difference(_samples[i].Position, _samples[i - 1].Position));
    }

    /// <summary>Returns the difference between two positions, for a continuous joint without whole turns.</summary>
    public double Difference(double position, double from) =>
        position - from - (_isEndless ? JointPredictor.WholeTurns(position - from) : 0);

    void Sort()
    {
        if (_isSorted) return;
        var sorted = _samples.Select((sample, i) => (sample, i)).OrderBy(s => s.sample.Ticks).ThenBy(s => s.i).Select(s => s.sample).ToList();
        _samples.Clear();
        foreach (var sample in sorted)
            if (_samples.Count == 0 || sample.Ticks > _samples[^1].Ticks) _samples.Add(sample);
        _isSorted = true;
    }

    /// <returns>True if the position is known at that time.</returns>
    public bool TryAt(ControlTime at, out double position)
    {
        var ticks = at.SinceEpoch.Ticks;
        var after = SortedSearch.CountUpTo(_samples, ticks, sample => sample.Ticks);
        // The time of the last sample belongs to the interval before it.
        if (after == _samples.Count && after > 1 && _samples[^1].Ticks == ticks) after--;
        position = 0;
        if (after == 0 || after == _samples.Count || !AreNear(after - 1)) return false;
        var before = after > 1 && AreNear(after - 2) ? SampleAt(after - 2) : default;
        var later = after + 1 < _samples.Count && AreNear(after) ? SampleAt(after + 1) : default;
        position = new TruthSpan(before, SampleAt(after - 1), SampleAt(after), later).At(at, out _);
        return true;
    }

    TruthSample SampleAt(int i) => new(new ControlTime(new TimeSpan(_samples[i].Ticks)), _samples[i].Position);

    bool AreNear(int i) => _samples[i + 1].Ticks - _samples[i].Ticks <= _maximumGap;
}
