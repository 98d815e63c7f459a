namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The time read from a code, or the reason why the code could not be read.</summary>
/// <param name="Ms">Time of the code, 0 to 65 536 ms. If the exposure shows several codes, time of the middle one. NaN if not read.</param>
/// <param name="Fault">The reason; null if the code was read.</param>
readonly record struct Reading(double Ms, string Fault)
{
    public static Reading Of(double ms) => new(ms, null);

    public static Reading Not(string fault) => new(double.NaN, fault);
}
