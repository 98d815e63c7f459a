namespace Nowpose.Cli;

/// <summary>Computes the share of an error that the compensation removes.</summary>
static class ErrorReduction
{
    /// <summary>Returns 1 − rms / rms of hold; null if one of them is unknown or hold has no error.</summary>
    public static double? Of(double? rms, double? rmsHold) => rmsHold == 0 ? null : 1 - rms / rmsHold;
}
