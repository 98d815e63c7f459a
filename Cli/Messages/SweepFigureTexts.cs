namespace Nowpose.Cli.Messages;

/// <summary>Text of the figures for which one condition is varied.</summary>
static class SweepFigureTexts
{
    public static string Conditions(string varied, double velocity, double acceleration, double jerk) =>
        $"Varied: {varied}. Everything else as stated for all figures. "
        + FormattableString.Invariant($"The criteria are evaluated with limits of {velocity:G6} mm/s, {acceleration:G6} mm/s² and {jerk:G6} mm/s³, ")
        + "which the paper does not state; with other limits they can have other results (option --limits). Random moves: 7-phase, "
        + "strokes and limits drawn separately for each move, up to 1500 mm/s.";

    public static string RandomRatio(string predictor) => $"{predictor} ratio on random moves";

    public static string Leaves(string predictor, string ofQuadratic, string ofBest, string onRandomMoves) =>
        $"The error of {predictor} is {ofQuadratic} of the quadratic's error, {ofBest} of the smallest error of the three polynomials at each "
        + $"value, and {onRandomMoves} of the quadratic's error on fast random moves. ";

    public static string Beyond(string shares, double periodSeconds) =>
        shares + FormattableString.Invariant($"The swing repeats every {periodSeconds:0.0} s, which adaptive may recognise; ")
        + "random moves do not repeat.";
}
