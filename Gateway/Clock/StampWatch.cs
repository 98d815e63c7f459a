using System.Globalization;
using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Clock;

/// <summary>Detects contradictions between the served clock and the stamps of the sources. Thread-safe.</summary>
/// <remarks>
/// Example: a source stamps its samples with system time, and the system clock is corrected, but the control clock does not follow. From
/// then on, the stamps are either in the future, so that the gateway refuses the samples, or too old. The same happens if the control
/// clock is the system clock and a source does not follow the correction. On Windows, the counter of the control clock also has another rate
/// than the system clock, which has the same effect after some time. The stamps of a source that offers a clock are compared only with that
/// clock: if they are in the future, another clock has stamped them.
/// </remarks>
/// <param name="control">The control clock.</param>
/// <param name="own">The gateway's own clock; null while another one is the control clock.</param>
/// <param name="served">Name of the control clock. When it changes, the ages measured so far become invalid.</param>
/// <param name="errorBound">Maximum error of the control clock.</param>
/// <param name="other">
/// The other clock that a source may stamp with, as Unix time: the system clock. If the gateway's own clock is the system clock, it is the
/// system clock without the corrections since the start.
/// </param>
/// <param name="isSystemServed">Whether the gateway's own clock is the system clock.</param>
sealed class StampWatch(
    Func<ControlTime> control, Func<string> served, Func<TimeSpan> errorBound, Func<IControlClock> own, Func<ControlTime> other, bool isSystemServed,
    TimeProvider time)
{
    /// <summary>Minimum correction that is reported: at 1 m/s, it shifts the displayed pose by 100 mm.</summary>
    internal static readonly TimeSpan MinCorrection = TimeSpan.FromMilliseconds(100);

    /// <summary>Length of the evaluated interval, s.</summary>
    internal const int Seconds = 5;

    /// <summary>Minimum number of samples in the evaluated interval for a conclusion.</summary>
    internal const int MinSamples = 5;

    /// <summary><see cref="StampRule.PlausibleAhead"/> for a source that offers its clock. The rounding of a stamp may be its only error.</summary>
    static readonly TimeSpan MaxAheadOfOffered = TimeSpan.FromMilliseconds(5);

    /// <summary>Maximum age of the samples of a live source.</summary>
    static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(1);

    /// <summary>Maximum duration of reading both clocks. A slower reading does not give an accurate difference and is discarded.</summary>
    static readonly TimeSpan MaxReading = TimeSpan.FromMilliseconds(5);

    /// <summary>Maximum number of sources that are checked; further ones are ignored.</summary>
    const int MaxSources = 64;

    /// <summary>Maximum number of sources named in a warning.</summary>
    const int MaxNamed = 5;

    readonly Lock _lock = new();
    readonly Dictionary<HubSource, SourceStamps> _sources = [];
    // Keyed by title, so that a source that reconnects is still compared with the ages of its first seconds.
    readonly Dictionary<string, MinAges> _usual = [];
    TimeSpan? _ahead;
    ControlTime _since;
    TimeSpan _correction, _loggedCorrection;
    bool? _logged;
    string _served;

    /// <summary>The fault that was found, with its remedy; null if there is none.</summary>
    public StampWarning Found { get; private set; }

    /// <summary><see cref="Found"/> as text.</summary>
    public string Warning => Found?.Text;

    /// <summary>Whether most of a source's samples in the last few seconds cannot be used with the control clock.</summary>
    public bool IsContradicted => Found is { IsContradiction: true };

    /// <summary>
    /// The sources whose accepted samples have been in the future for at least <see cref="Seconds"/> seconds, each with the time by which its newest
    /// such stamp is ahead, as text.
    /// </summary>
    public IReadOnlyList<(string Source, string By)> Ahead { get; private set; } = [];

    /// <summary>
    /// The sources whose new samples have been too old to be displayed in each of the last <see cref="Seconds"/> seconds, each with the age of the
    /// newest such sample as text.
    /// </summary>
    public IReadOnlyList<(string Source, string By)> Behind { get; private set; } = [];

    long Now => time.GetTimestamp() / time.TimestampFrequency;

    /// <summary>Records the stamp of a sample.</summary>
    /// <param name="isRefused">Whether the sample was refused because its stamp is in the future.</param>
    /// <param name="offeredBound">Error bound on C1 of the clock that the source offers; null if the source offers no clock.</param>
    public void Add(HubSource source, ControlTime stamp, bool isRefused, TimeSpan? offeredBound = null)
    {
        var age = control() - stamp;
        // A source that offers its clock stamps with no other clock.
        var otherAge = offeredBound == null ? other() - stamp : age;
        var fitsOther = !IsPlausible(age) && IsPlausible(otherAge);
        var isBehind = age > MaxAge + (offeredBound ?? errorBound());
        var isAhead = age < -(offeredBound + MaxAheadOfOffered ?? StampRule.PlausibleAhead + errorBound());
        lock (_lock)
        {
            if (!_sources.TryGetValue(source, out var stamps))
            {
                if (_sources.Count >= MaxSources) return;
                _sources.Add(source, stamps = new SourceStamps { Usual = _usual.TryGetValue(source.Title, out var usual) ? usual : null });
            }

            stamps.Add(Now, stamp, age, otherAge, isRefused, fitsOther, isAhead, isBehind);
        }
    }

    /// <summary>Evaluates the stamps of the last few seconds and logs changes. Called once a second.</summary>
    public void Look(Action<string> log)
    {
        ResetOnClockChange();
        MeasureCorrection();
        var sources = Read();
        Ahead = Lengths(sources, counts => counts.IsAhead);
        Behind = Lengths(sources, counts => counts.IsBehind);
        var contradicting = sources.Where(one => one.Counts.IsContradiction)
            .OrderByDescending(one => one.Counts.IsImplausible).ThenByDescending(one => one.Counts.Percent).ToArray();
        Found = contradicting.Length > 0 ? Contradiction(contradicting) : Correction();
        var kind = Found?.IsContradiction;
        if (kind == _logged && (kind != false || !HasMoved())) return;
        log(Warning == null ? StampMessages.AgreeAgain : StampMessages.Log(Warning));
        (_logged, _loggedCorrection) = (kind, _correction);
    }

    // Two clocks with different rates would otherwise cause a line for each 0.1 s.
    bool HasMoved() => (_correction - _loggedCorrection).Duration() >= _loggedCorrection.Duration();

    // Ages on two different control clocks cannot be compared.
    void ResetOnClockChange()
    {
        var name = served();
        if (name == _served) return;
        _served = name;
        lock (_lock)
        {
            _usual.Clear();
            foreach (var stamps in _sources.Values) stamps.Usual = null;
        }
    }

    // Returns the counts of the sources with recent samples, and removes the other sources.
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

    static bool IsPlausible(TimeSpan age) => age >= -StampRule.PlausibleAhead && age <= MaxAge;

    void MeasureCorrection()
    {
        if (own() is not { } clock || isSystemServed)
        {
            (_ahead, _correction) = (null, TimeSpan.Zero);
            return;
        }

        var before = clock.Now;
        var shown = other();
        if ((clock.Now - before).Duration() > MaxReading) return;
        var ahead = shown - before;
        if (_ahead == null) (_ahead, _since) = (ahead, before);
        // The skew set on the gateway's clock is not a correction of the system clock.
        _correction = ahead - _ahead.Value + ((before - _since) * clock.Skew);
    }

    StampWarning Correction() => _correction.Duration() < MinCorrection ? null : new StampWarning(
        StampMessages.SystemClockCorrected(_correction.TotalSeconds), StampMessages.SystemRemedy, false);

    static (string Source, string By)[] Lengths((string Source, StampCounts Counts)[] sources, Func<StampCounts, bool> isWrong) =>
        [.. sources.Where(one => isWrong(one.Counts)).DistinctBy(one => one.Source).Select(one => (one.Source, Length(one.Counts.Age.Duration())))];

    // Describes the first source in full and lists the names of the others.
    StampWarning Contradiction((string Source, StampCounts Counts)[] sources)
    {
        var (source, counts) = sources[0];
        var others = sources.Skip(1).Select(one => one.Source).Distinct().Take(MaxNamed).ToArray();
        var same = StampMessages.SameFor(others);
        if (!counts.IsImplausible)
            return new StampWarning(
                StampMessages.Shifted(source, Length(counts.Shift.Duration()), counts.Shift > TimeSpan.Zero, isSystemServed, Cause) + same,
                CorrectionRemedy, true);
        var fits = counts.FitsOther && own() != null;
        var reason = StampMessages.Implausible(source, counts.Percent, Length(counts.Age.Duration()), counts.Age < TimeSpan.Zero)
            + (!fits ? "" : isSystemServed ? ": " + Cause : StampMessages.FitsSystemClock) + same;
        return new StampWarning(reason, fits ? CorrectionRemedy : StampMessages.SourceRemedyFor(counts.Age), true);
    }

    string Cause =>
        own() == null ? StampMessages.NotFollowing(served())
        : isSystemServed ? StampMessages.NotCorrected : StampMessages.Corrected;

    string CorrectionRemedy => isSystemServed || own() == null ? StampMessages.SourceRemedy : StampMessages.SystemRemedy;

    static string Length(TimeSpan length) =>
        length < TimeSpan.FromSeconds(1) ? Text($"{length.TotalMilliseconds:0} ms")
        : length < TimeSpan.FromMinutes(10) ? Text($"{length.TotalSeconds:0.0} s")
        : length < TimeSpan.FromHours(2) ? Text($"{length.TotalMinutes:0.0} minutes")
        : length < TimeSpan.FromDays(2) ? Text($"{length.TotalHours:0.0} hours") : Text($"{length.TotalDays:0} days");

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
