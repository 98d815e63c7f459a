namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>What a code was read as, or why it was not.</summary>
/// <param name="Ms">Time it shows, 0 to 65 536 ms: of several codes in one exposure that of the middle; NaN when not read.</param>
/// <param name="Fault">Null when it was read.</param>
readonly record struct Reading(double Ms, string Fault)
{
    public static Reading Of(double ms) => new(ms, null);

    public static Reading Not(string fault) => new(double.NaN, fault);
}
