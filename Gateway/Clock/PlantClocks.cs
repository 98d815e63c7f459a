using System.Collections.Immutable;

namespace Nowpose.Gateway.Clock;

/// <summary>The clocks of the control system that adapters offer, and which of them is C1. Any thread.</summary>
public sealed class PlantClocks
{
    /// <summary>Asks for the gateway's own clock, whatever adapters offer.</summary>
    public const string Own = "own";

    /// <summary>One plant has two or three; a source that invents names must not fill the memory.</summary>
    internal const int AtMost = 16;

    readonly IPerformanceCounterClock _counter;
    readonly string _wanted;
    readonly object _gate = new();
    ImmutableArray<PlantClock> _clocks = [];

    /// <param name="wanted">The name of the clock that is C1; null for the first that comes; <see cref="Own"/> for none of them.</param>
    /// <param name="counter">This machine's, in the place of C2.</param>
    internal PlantClocks(string wanted, IPerformanceCounterClock counter)
    {
        _wanted = wanted;
        _counter = counter;
        // Known from the start, so that whoever waits for it can see what for.
        if (wanted is not (null or Own)) _clocks = [new PlantClock(wanted, counter)];
    }

    /// <summary>In the order in which they came.</summary>
    public IReadOnlyList<PlantClock> All => _clocks;

    /// <summary>The one that is C1; null while the gateway's own is.</summary>
    public PlantClock Control => _wanted == Own ? null : _clocks.FirstOrDefault();

    /// <summary>A clock that was not known before. A handler must be quick and must not throw.</summary>
    public event Action<PlantClock> Added;

    internal IPerformanceCounterClock Counter => _counter;

    /// <summary>Whether a text can name a clock: 1 to 32 of a–z, 0–9, _ and -.</summary>
    public static bool IsName(string text) =>
        text.Length is > 0 and <= 32 && text != Own && text.All(c => c is (>= 'a' and <= 'z') or (>= '0' and <= '9') or '_' or '-');

    /// <summary>The clock of a name, a new one if need be; null when there are <see cref="AtMost"/> others.</summary>
    internal PlantClock Find(string name)
    {
        PlantClock added;
        lock (_gate)
        {
            if (_clocks.FirstOrDefault(clock => clock.Name == name) is { } known) return known;
            if (_clocks.Length == AtMost) return null;
            added = new PlantClock(name, _counter);
            _clocks = _clocks.Add(added);
        }

        Added?.Invoke(added);
        return added;
    }
}
