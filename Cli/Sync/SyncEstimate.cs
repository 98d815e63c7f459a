using System.Globalization;

namespace Nowpose.Cli.Sync;

/// <summary>The estimate of the clock synchroniser at one instant.</summary>
/// <param name="Nanoseconds">The instant on C2 exactly as in the log, ns. The time types round to 100 ns.</param>
readonly record struct SyncEstimate(long Nanoseconds, HeadsetTime At, ClockModel Model)
{
    const int NanosecondsPerTick = 100;

    /// <summary>Estimated C2 − C1, ns. Needs more than 64 bits, because the epochs of the clocks can be far apart.</summary>
    public Int128? OffsetNanoseconds => Model.IsKnown
        ? (Int128)Model.OffsetAt(At).HeadsetMinusControl.Ticks * NanosecondsPerTick : null;

    public double? SkewPpm => Model.IsKnown ? Model.Skew * 1e6 : null;

    public Int128? ErrorBoundNanoseconds => Model.IsKnown ? (Int128)Model.ErrorBound.Ticks * NanosecondsPerTick : null;

    public Int128? EstimatedErrorNanoseconds => Model.IsKnown ? (Int128)Model.EstimatedError.Ticks * NanosecondsPerTick : null;

    public string State => Model.State.Word();

    public static string Text<T>(T? value) where T : struct, IFormattable =>
        value?.ToString(null, CultureInfo.InvariantCulture) ?? "";
}
