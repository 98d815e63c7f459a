using System.Globalization;
using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Clock;

/// <summary>Finds out that the served clock and the stamps of the sources contradict each other. Any thread.</summary>
/// <remarks>
/// A source that stamps with system time and a control clock that does not follow a correction of the system clock differ from then on: its
/// samples lie in the future and are refused, or they are old. Only stamps without a plant clock of their own are looked at.
/// </remarks>
/// <param name="control">The control clock.</param>
/// <param name="own">The gateway's own clock; null while another one is the control clock.</param>
/// <param name="errorBound">How wrong the control clock may be.</param>
/// <param name="system">The system clock, Unix time.</param>
sealed class StampWatch(Func<ControlTime> control, Func<TimeSpan> errorBound, Func<IControlClock> own, Func<ControlTime> system, TimeProvider time)
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

    /// <summary>Sources that are judged at the same time; further ones are not.</summary>
    const int MaxSources = 64;

    /// <summary>Sources that a warning names.</summary>
    const int MaxNamed = 5;

    readonly Lock _lock = new();
    readonly Dictionary<HubSource, SourceStamps> _sources = [];
    // By the source's title, so that one that connects again is still compared with its first seconds.
    readonly Dictionary<string, LeastAges> _usual = [];
    TimeSpan? _ahead;
    ControlTime _since;
    TimeSpan _correction;
    string _said;

    /// <summary>The fault that was found, with its remedy; null without one.</summary>
    public StampWarning Found { get; private set; }

    /// <summary><see cref="Found"/> as text.</summary>
    public string Warning => Found?.Text;

    /// <summary>Whether most samples of a source in the last seconds cannot be used with the control clock.</summary>
    public bool IsContradicted => Found is { IsContradiction: true };

    /// <summary>The sources whose accepted samples lie in the future for long, and by how much.</summary>
    public IReadOnlyList<(string Source, string By)> Ahead { get; private set; } = [];

    long Now => time.GetTimestamp() / time.TimestampFrequency;

    /// <summary>Takes the stamp of a sample.</summary>
    /// <param name="isRefused">Whether it was refused as in the future.</param>
    public void Add(HubSource source, ControlTime stamp, bool isRefused)
    {
        var age = control() - stamp;
        var systemAge = system() - stamp;
        var fitsSystem = !IsPlausible(age) && IsPlausible(systemAge);
        var isAhead = age < -(MaxAhead + errorBound());
        lock (_lock)
        {
            if (!_sources.TryGetValue(source, out var stamps))
            {
                if (_sources.Count >= MaxSources) return;
                _sources.Add(source, stamps = new SourceStamps { Usual = _usual.TryGetValue(source.Title, out var usual) ? usual : null });
            }

            stamps.Add(Now, age, systemAge, isRefused, fitsSystem, isAhead);
        }
    }

    /// <summary>Looks once a second; says in the log what has changed.</summary>
    public void Look(Action<string> log)
    {
        MeasureCorrection();
        var sources = Read();
        Ahead = [.. sources.Where(one => one.Counts.IsAhead).DistinctBy(one => one.Source).Select(one => (one.Source, Length(-one.Counts.Age)))];
        var contradicting = sources.Where(one => one.Counts.IsContradiction)
            .OrderByDescending(one => one.Counts.IsImplausible).ThenByDescending(one => one.Counts.Percent).ToArray();
        Found = contradicting.Length > 0 ? Contradiction(contradicting) : Correction();
        var kind = IsContradicted ? "contradiction" : Warning;
        if (kind == _said) return;
        log(Warning == null ? "clock: stamps and control clock agree again" : "clock: " + Warning);
        _said = kind;
    }

    // Forgets the sources without recent samples.
    (string Source, StampCounts Counts)[] Read()
    {
        lock (_lock)
        {
            var now = Now;
            var isCorrected = _correction.Duration() >= MinCorrection / 2;
            var all = _sources.Select(one => (Source: one.Key, Counts: one.Value.Read(now, isCorrected))).ToArray();
            foreach (var (source, counts) in all)
            {
                if (_sources[source].Usual is { } usual && _usual.Count < MaxSources) _usual.TryAdd(source.Title, usual);
                if (counts.Samples == 0) _sources.Remove(source);
            }

            return [.. all.Where(one => one.Counts.Samples > 0).Select(one => (one.Source.Title, one.Counts))];
        }
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

    StampWarning Correction() => _correction.Duration() < MinCorrection ? null : new StampWarning(
        Text($"the system clock was corrected by {_correction.TotalSeconds:+0.0;-0.0} s since the start, and the control clock, the gateway's own, did not ")
            + "follow. Stamps that a source takes from the system clock are wrong by that",
        Remedy, false);

    // The worst first.
    StampWarning Contradiction((string Source, StampCounts Counts)[] sources)
    {
        var (source, counts) = sources[0];
        var others = sources.Skip(1).Select(one => one.Source).Distinct().Take(MaxNamed).ToArray();
        var same = others.Length == 0 ? "" : $"; the same is true of {string.Join(", ", others)}";
        if (!counts.IsImplausible)
            return new StampWarning(
                $"the stamps of the source {source} became {Length(counts.Shift.Duration())} {(counts.Shift > TimeSpan.Zero ? "older" : "newer")} by the "
                    + $"control clock, but not by the system clock: they followed a correction of the system clock{same}",
                Remedy, true);
        var where = counts.Age < TimeSpan.Zero
            ? Text($"in the future of the control clock, by {Length(-counts.Age)}") : Text($"before the control clock, by {Length(counts.Age)}");
        var fits = counts.FitsSystem && own() != null;
        var reason = Text($"{counts.Percent:0} % of the samples of the source {source} have stamps that lie {where}")
            + (fits ? ", and that fit the system clock" : "") + same;
        return new StampWarning(reason, fits ? Remedy : "Set the clock of the source, or let its adapter offer that clock.", true);
    }

    // No option of the verb simulate, whose gateway has this clock as well.
    const string Remedy = "Restart the gateway. Started as serve --own-clock system, it follows the system clock.";

    static string Length(TimeSpan length) =>
        length < TimeSpan.FromSeconds(1) ? Text($"{length.TotalMilliseconds:0} ms")
        : length < TimeSpan.FromMinutes(10) ? Text($"{length.TotalSeconds:0.0} s")
        : length < TimeSpan.FromHours(2) ? Text($"{length.TotalMinutes:0.0} minutes")
        : length < TimeSpan.FromDays(2) ? Text($"{length.TotalHours:0.0} hours") : Text($"{length.TotalDays:0} days");

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
