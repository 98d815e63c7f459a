namespace Nowpose.Cli.Demo;

/// <summary>The errors of one scored frame.</summary>
/// <param name="Frame">Index among all frames.</param>
/// <param name="HoldMm">Distance of the tool from the truth without compensation, mm.</param>
/// <param name="Mm">Distance of the tool from the truth as displayed, mm.</param>
/// <param name="LightMs">Assumed minus true control time of the light, ms.</param>
/// <param name="InTimeMm">The same as <paramref name="Mm"/> without the delay of the frame's light, mm.</param>
/// <param name="Cycle">Motion cycle at the display time, from 0.</param>
readonly record struct DemoError(int Frame, double HoldMm, double Mm, double LightMs, double InTimeMm, int Cycle);
