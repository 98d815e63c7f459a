using Nowpose.Gateway.Clock;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Simulates the gateway's counter and the clocks, which are measured every 50 ms with one-way delays of 0.4 to 0.6 ms.</summary>
sealed class VirtualPlant : IPerformanceCounterClock
{
    static readonly TimeSpan OneWay = TimeSpan.FromMilliseconds(0.4);

    readonly List<VirtualPlantClock> _clocks = [];
    readonly Random _random = new(7);

    public VirtualPlant(string wanted = null, IControlClock own = null)
    {
        Clocks = new PlantClocks(wanted, this);
        Served = new ServedClock(own ?? new StopwatchControlClock(ControlTime.FromSeconds(1)), Clocks);
    }

    public PlantClocks Clocks { get; }
    public ServedClock Served { get; }
    public HeadsetTime Now { get; private set; } = HeadsetTime.FromSeconds(50);

    public HeadsetTime At(long count) => throw new NotSupportedException("virtual time has no counts");

    public VirtualPlantClock Add(string name, double startSeconds, double ppm)
    {
        var clock = new VirtualPlantClock(this, Clocks.Find(name), ControlTime.FromSeconds(startSeconds), ppm * 1e-6);
        _clocks.Add(clock);
        return clock;
    }

    public void Run(TimeSpan length)
    {
        for (var end = Now + length; Now < end; Pass(TimeSpan.FromMilliseconds(50)))
            foreach (var clock in _clocks) clock.Exchange(Way(), Way());
    }

    public void Pass(TimeSpan length) => Now += length;

    TimeSpan Way() => OneWay + TimeSpan.FromMilliseconds(0.2 * _random.NextDouble());
}

sealed class VirtualPlantClock(VirtualPlant plant, PlantClock measured, ControlTime start, double skew)
{
    readonly HeadsetTime _started = plant.Now;
    ControlTime _start = start;

    public double Skew { get; set; } = skew;

    public ControlTime Shown => At(plant.Now);

    public void Step(TimeSpan by) => _start += by;

    public void Exchange(TimeSpan there, TimeSpan back)
    {
        // The exchange is added when the reply arrives, so the request was sent one round-trip time earlier.
        var asked = plant.Now - there - back;
        measured.Add(new SyncExchange(asked, At(asked + there), At(asked + there), plant.Now, new TimeSpan(1)));
    }

    ControlTime At(HeadsetTime time) => _start + new TimeSpan((long)((time - _started).Ticks * (1 + Skew)));
}
