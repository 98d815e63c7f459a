using System.Globalization;

namespace Nowpose.Gateway.Clock;

/// <summary>Finds out that the served clock and the stamps of the sources contradict each other. Any thread.</summary>
/// <remarks>
/// A source that stamps with system time and a control clock that does not follow a correction of the system clock differ from then on: its
/// samples lie in the future and are refused, or they are old. Only stamps without a plant clock of their own are looked at.
/// </remarks>
/// <param name="control">The control clock.</param>
/// <param name="own">The gateway's own clock; null while another one is the control clock.</param>
/// <param name="system">The system clock, Unix time.</param>
sealed class StampWatch(Func<ControlTime> control, Func<IControlClock> own, Func<ControlTime> system, TimeProvider time)
{
    /// <summary>A correction that a headset would see: at 1 m/s it is 100 mm.</summary>
    internal static readonly TimeSpan MinCorrection = TimeSpan.FromMilliseconds(100);

    /// <summary>The time that is looked back.</summary>
    internal const int Seconds = 5;

    /// <summary>Samples in that time below which nothing is concluded.</summary>
    internal const int MinSamples = 5;

    /// <summary>A stamp may lie this far in the future: two clocks that NTP keeps differ by less.</summary>
    static readonly TimeSpan MaxAhead = TimeSpan.FromMilliseconds(50);

    /// <summary>Samples of a live source are not older.</summary>
    static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(1);

    /// <summary>A reading of two clocks that took longer says little about their difference.</summary>
    static readonly TimeSpan MaxReading = TimeSpan.FromMilliseconds(5);

    readonly Lock _lock = new();
    readonly Second[] _seconds = new Second[Seconds];
    TimeSpan? _ahead;
    ControlTime _since;
    TimeSpan _correction;
    string _said;

    /// <summary>What is wrong and what to do, for people; null while nothing is.</summary>
    public string Warning { get; private set; }

    /// <summary>Whether most samples of the last seconds cannot be used with the control clock.</summary>
    public bool IsContradicted { get; private set; }

    /// <summary>Takes the stamp of a sample.</summary>
    /// <param name="isRefused">Whether it was refused as in the future.</param>
    public void Add(ControlTime stamp, bool isRefused)
    {
        var onControl = control() - stamp;
        var fitsSystem = !IsPlausible(onControl) && IsPlausible(system() - stamp);
        lock (_lock)
        {
            ref var second = ref Current();
            second.Samples++;
            if (isRefused) second.Refused++;
            if (fitsSystem) second.OnSystem++;
            if (isRefused || fitsSystem) second.Age = onControl;
        }
    }

    /// <summary>Looks once a second; says in the log what has changed.</summary>
    public void Look(Action<string> log)
    {
        MeasureCorrection();
        lock (_lock)
        {
            Current();
            var samples = _seconds.Sum(second => second.Samples);
            var refused = _seconds.Sum(second => second.Refused);
            var onSystem = _seconds.Sum(second => second.OnSystem);
            IsContradicted = samples >= MinSamples && 2 * Math.Max(refused, onSystem) > samples;
            Warning = IsContradicted ? Contradiction(samples, refused, onSystem) : Correction();
        }

        var kind = IsContradicted ? "contradiction" : Warning;
        if (kind == _said) return;
        log(Warning == null ? "clock: stamps and control clock agree again" : "clock: " + Warning);
        _said = kind;
    }

    static bool IsPlausible(TimeSpan age) => age >= -MaxAhead && age <= MaxAge;

    void MeasureCorrection()
    {
        if (own() is not { } clock)
        {
            (_ahead, _correction) = (null, TimeSpan.Zero);
            return;
        }

        var before = clock.Now;
        var shown = system();
        if ((clock.Now - before).Duration() > MaxReading) return;
        var ahead = shown - before;
        if (_ahead == null) (_ahead, _since) = (ahead, before);
        // The rate that the gateway's clock was given is no correction of the other one.
        _correction = ahead - _ahead.Value + ((before - _since) * clock.Skew);
    }

    string Correction() => _correction.Duration() < MinCorrection ? null : Text(
        $"the system clock was corrected by {_correction.TotalSeconds:+0.0;-0.0} s since the start, and the control clock, the gateway's own, did not ")
        + $"follow. Stamps that a source takes from the system clock are wrong by that. {Remedy}";

    string Contradiction(int samples, int refused, int onSystem)
    {
        var age = _seconds.Where(second => second.Age != TimeSpan.Zero).Select(second => second.Age).Last();
        var where = age < TimeSpan.Zero
            ? Text($"in the future of the control clock, by {-age.TotalSeconds:0.0} s") : Text($"before the control clock, by {age.TotalSeconds:0.0} s");
        var share = Text($"{100.0 * Math.Max(refused, onSystem) / samples:0} % of the samples have stamps that lie {where}");
        return 2 * onSystem > samples && own() != null
            ? $"{share}, and that fit the system clock. {Remedy}"
            : $"{share}. Set the clock of the source, or let its adapter offer that clock.";
    }

    const string Remedy = "Restart the gateway, or start it with --own-clock system.";

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    // Empties the seconds that went by without a sample.
    ref Second Current()
    {
        var now = time.GetTimestamp() / time.TimestampFrequency;
        for (var i = 0; i < Seconds; i++)
            if (_seconds[i].Number <= now - Seconds) _seconds[i] = default;
        ref var second = ref _seconds[now % Seconds];
        if (second.Number != now) second = new Second { Number = now };
        return ref second;
    }

    struct Second
    {
        public long Number;
        public int Samples, Refused, OnSystem;
        public TimeSpan Age;
    }
}
