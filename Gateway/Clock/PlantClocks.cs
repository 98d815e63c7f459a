using System.Collections.Immutable;

namespace Nowpose.Gateway.Clock;

/// <summary>The clocks of the control system that adapters offer, and the selection of C1. Thread-safe.</summary>
public sealed class PlantClocks
{
    /// <summary>Selects the gateway's own clock, even if adapters offer others.</summary>
    public const string Own = "own";

    /// <summary>Maximum number of clocks. A plant has two or three. The limit bounds the memory that a faulty source can use.</summary>
    internal const int AtMost = 16;

    readonly IPerformanceCounterClock _counter;
    readonly string _wanted;
    readonly IReadOnlyCollection<string> _reserved;
    readonly object _gate = new();
    ImmutableArray<PlantClock> _clocks = [];

    /// <param name="wanted">Name of the clock that is C1; null for the first one offered; <see cref="Own"/> for the gateway's own.</param>
    /// <param name="counter">This machine's counter, used as C2.</param>
    /// <param name="reserved">Names of the clocks that only adapters of this gateway may serve.</param>
    internal PlantClocks(string wanted, IPerformanceCounterClock counter, IReadOnlyCollection<string> reserved = null)
    {
        _wanted = wanted;
        _reserved = reserved ?? [];
        _counter = counter;
        // Added at startup, so that the status shows the clock as missing until an adapter offers it.
        if (wanted is not (null or Own)) _clocks = [new PlantClock(wanted, counter)];
    }

    /// <summary>The clocks in the order in which they were first offered.</summary>
    public IReadOnlyList<PlantClock> All => _clocks;

    /// <summary>The plant's clock that is C1; null while C1 is the gateway's own clock.</summary>
    public PlantClock Control => _wanted == Own ? null : _clocks.FirstOrDefault();

    /// <summary>Raised when an adapter offers a clock with a new name. Handlers must be quick and must not throw.</summary>
    public event Action<PlantClock> Added;

    internal IPerformanceCounterClock Counter => _counter;

    /// <summary>Whether a string is a valid name of a clock: 1 to 32 characters of a–z, 0–9, _ and -, but not <see cref="Own"/>.</summary>
    public static bool IsName(string text) =>
        text.Length is > 0 and <= 32 && text != Own && text.All(c => c is (>= 'a' and <= 'z') or (>= '0' and <= '9') or '_' or '-');

    /// <summary>Whether only an adapter that this gateway has started may serve the clock with this name.</summary>
    internal bool IsReserved(string name) => _reserved.Contains(name);

    /// <summary>
    /// Gets the clock with this name; creates it if necessary. At the limit, it replaces a clock that no adapter offers at present and that is not C1.
    /// Returns null if there is none. The limit does not apply to reserved clocks.
    /// </summary>
    internal PlantClock Find(string name)
    {
        PlantClock added;
        lock (_gate)
        {
            if (_clocks.FirstOrDefault(clock => clock.Name == name) is { } known) return known;
            // The first clock is C1, unless C1 is the gateway's own clock.
            var unused = _clocks.Length < AtMost ? null : _clocks.Skip(_wanted == Own ? 0 : 1).FirstOrDefault(clock => !clock.IsConnected);
            if (_clocks.Length >= AtMost && unused == null && !IsReserved(name)) return null;
            if (unused != null) _clocks = _clocks.Remove(unused);
            added = new PlantClock(name, _counter);
            _clocks = _clocks.Add(added);
        }

        Added?.Invoke(added);
        return added;
    }
}
