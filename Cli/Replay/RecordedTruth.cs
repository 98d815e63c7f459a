using Nowpose.Session;
using Nowpose.Session.Hindcast;

namespace Nowpose.Cli.Replay;

/// <summary>The true position of a recorded joint: its own samples, interpolated on the control clock by cubics.</summary>
/// <remarks>
/// Uses the cubic of the headset's own hindcast. There is no truth before the first sample, after the last one, or between two samples
/// that are further apart than the maximum gap.
/// </remarks>
sealed class RecordedTruth
{
    readonly List<(long Ticks, double Position)> _samples = [];
    readonly long _maximumGap;
    bool _isSorted = true;

    public RecordedTruth(TimeSpan maximumGap) => _maximumGap = maximumGap.Ticks;

    public void Add(ControlTime at, double position)
    {
        var ticks = at.SinceEpoch.Ticks;
        _isSorted &= _samples.Count == 0 || _samples[^1].Ticks < ticks;
        _samples.Add((ticks, position));
    }

    /// <summary>Sorts late samples. Of two samples with the same time, the first is used. Call this once, after the last sample.</summary>
    public void Complete()
    {
        if (_isSorted) return;
        var sorted = _samples.Select((sample, i) => (sample, i)).OrderBy(s => s.sample.Ticks).ThenBy(s => s.i).Select(s => s.sample).ToList();
        _samples.Clear();
        foreach (var sample in sorted)
            if (_samples.Count == 0 || sample.Ticks > _samples[^1].Ticks) _samples.Add(sample);
        _isSorted = true;
    }

    /// <returns>False if the truth is unknown at that time.</returns>
    public bool TryAt(ControlTime at, out double position)
    {
        var ticks = at.SinceEpoch.Ticks;
        var after = FirstAfter(ticks);
        // The last sample's own time belongs to the interval before it.
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

    int FirstAfter(long ticks)
    {
        var (low, high) = (0, _samples.Count);
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (_samples[middle].Ticks <= ticks) low = middle + 1;
            else high = middle;
        }
        return low;
    }
}
