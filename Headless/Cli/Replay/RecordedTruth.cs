namespace Nowpose.Cli.Replay;

/// <summary>Where a recorded joint was: its own samples, joined on the control clock by cubics through them.</summary>
/// <remarks>
/// It knows nothing before the first sample, after the last, and between two that lie further apart than the maximum gap. The
/// slope at a sample is that of the parabola through it and its neighbours; a straight line would take the corners of the
/// motion for truth and call whoever rounds them wrong.
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

    /// <summary>Puts late samples in their place; of two of the same time the first counts. Once, after the last was added.</summary>
    public void Complete()
    {
        if (_isSorted) return;
        var sorted = _samples.Select((sample, i) => (sample, i)).OrderBy(s => s.sample.Ticks).ThenBy(s => s.i).Select(s => s.sample).ToList();
        _samples.Clear();
        foreach (var sample in sorted)
            if (_samples.Count == 0 || sample.Ticks > _samples[^1].Ticks) _samples.Add(sample);
        _isSorted = true;
    }

    /// <returns>False where nobody knows.</returns>
    public bool TryAt(ControlTime at, out double position)
    {
        var ticks = at.SinceEpoch.Ticks;
        var after = FirstAfter(ticks);
        // The last sample's own moment lies between it and the one before.
        if (after == _samples.Count && after > 1 && _samples[^1].Ticks == ticks) after--;
        position = 0;
        if (after == 0 || after == _samples.Count || !AreNear(after - 1)) return false;
        var (start, end) = (_samples[after - 1], _samples[after]);
        var length = Seconds(end.Ticks - start.Ticks);
        var x = Seconds(ticks - start.Ticks) / length;
        var (slope0, slope1) = (SlopeAt(after - 1) * length, SlopeAt(after) * length);
        var step = end.Position - start.Position;
        position = start.Position + x * (slope0 + x * (3 * step - 2 * slope0 - slope1 + x * (slope0 + slope1 - 2 * step)));
        return true;
    }

    double SlopeAt(int i)
    {
        var (hasBefore, hasAfter) = (i > 0 && AreNear(i - 1), i + 1 < _samples.Count && AreNear(i));
        if (!hasBefore) return Rise(i);
        if (!hasAfter) return Rise(i - 1);
        var (before, after) = (Seconds(_samples[i].Ticks - _samples[i - 1].Ticks), Seconds(_samples[i + 1].Ticks - _samples[i].Ticks));
        return (Rise(i - 1) * after + Rise(i) * before) / (before + after);
    }

    double Rise(int i) => (_samples[i + 1].Position - _samples[i].Position) / Seconds(_samples[i + 1].Ticks - _samples[i].Ticks);

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

    static double Seconds(long ticks) => ticks / (double)TimeSpan.TicksPerSecond;
}
