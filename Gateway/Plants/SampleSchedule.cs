namespace Nowpose.Gateway.Plants;

/// <summary>The times at which a simulated cell takes and sends its samples. The schedule is derived from a seed, without a clock.</summary>
sealed class SampleSchedule
{
    readonly ControlTime _start;
    readonly CellTiming _timing;
    readonly Random _random;
    long _index = -1;

    /// <param name="from">Start. The first sample is taken at the first multiple of T_s that is not earlier.</param>
    /// <param name="timing">Sampling interval and acquisition times.</param>
    /// <param name="seed">Seed of the acquisition times.</param>
    public SampleSchedule(ControlTime from, CellTiming timing, int seed)
    {
        var step = timing.SamplingInterval.Ticks;
        var late = (from.SinceEpoch.Ticks % step + step) % step;
        _start = late == 0 ? from : from + new TimeSpan(step - late);
        _timing = timing;
        _random = new Random(seed);
        Taken = Sent = _start;
    }

    /// <summary>Time t_k at which the sample is taken, rounded down to the control cycle.</summary>
    public ControlTime Taken { get; private set; }

    /// <summary>Time at which the sample is sent, never earlier than that of the previous sample.</summary>
    public ControlTime Sent { get; private set; }

    /// <summary>Advances to the next sample. The first call advances to the first sample.</summary>
    public void Next()
    {
        var nominal = _start + new TimeSpan(++_index * _timing.SamplingInterval.Ticks);
        var rest = nominal.SinceEpoch.Ticks % CellTiming.Cycle.Ticks;
        Taken = nominal - new TimeSpan(rest < 0 ? rest + CellTiming.Cycle.Ticks : rest);
        var spread = (_timing.AcquisitionMax - _timing.AcquisitionMin).Ticks;
        var sent = Taken + _timing.AcquisitionMin + new TimeSpan((long)(_random.NextDouble() * spread));
        Sent = _index > 0 && Sent > sent ? Sent : sent;
    }
}
