using System.Globalization;

namespace Nowpose.Cli.Sync;

/// <summary>What the clock synchroniser said at one moment.</summary>
/// <param name="Nanoseconds">The moment on C2 exactly as the log has it; the time types round to 100 ns.</param>
readonly record struct SyncBelief(long Nanoseconds, HeadsetTime At, ClockModel Model)
{
    const int NanosecondsPerTick = 100;

    /// <summary>C2 − C1, ns; wider than 64 bits, since two epochs can lie that far apart.</summary>
    public Int128? OffsetNanoseconds => Model.IsKnown
        ? (Int128)Model.OffsetAt(At).HeadsetMinusControl.Ticks * NanosecondsPerTick : null;

    public double? SkewPpm => Model.IsKnown ? Model.Skew * 1e6 : null;

    public Int128? ErrorBoundNanoseconds => Model.IsKnown ? (Int128)Model.ErrorBound.Ticks * NanosecondsPerTick : null;

    public Int128? EstimatedErrorNanoseconds => Model.IsKnown ? (Int128)Model.EstimatedError.Ticks * NanosecondsPerTick : null;

    public string State => Model.State.Word();

    public static string Text<T>(T? value) where T : struct, IFormattable =>
        value?.ToString(null, CultureInfo.InvariantCulture) ?? "";
}
