namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The time read from a code, or the reason why it could not be read.</summary>
/// <param name="Ms">Time of the code, 0 to 65 536 ms; of several codes in one exposure, the time of the middle one. NaN when not read.</param>
/// <param name="Fault">The reason; null when it was read.</param>
readonly record struct Reading(double Ms, string Fault)
{
    public static Reading Of(double ms) => new(ms, null);

    public static Reading Not(string fault) => new(double.NaN, fault);
}
