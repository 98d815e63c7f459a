namespace Nowpose.Cli.Demo;

/// <summary>The errors of one scored frame.</summary>
/// <param name="Frame">Index among all frames.</param>
/// <param name="HoldMm">Distance between the uncompensated tool and the true one, mm.</param>
/// <param name="Mm">Distance between the displayed tool and the true one, mm.</param>
/// <param name="LightMs">Assumed minus true display time, ms.</param>
/// <param name="InTimeMm">Value that <paramref name="Mm"/> would have if the frame had been displayed without delay, mm.</param>
/// <param name="Cycle">Index of the motion cycle at the display time, from 0.</param>
readonly record struct DemoError(int Frame, double HoldMm, double Mm, double LightMs, double InTimeMm, int Cycle);
