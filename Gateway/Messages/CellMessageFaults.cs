namespace Nowpose.Gateway.Messages;

/// <summary>Descriptions of faults in messages about frames and signals. The name of the frame or signal precedes them.</summary>
static class CellMessageFaults
{
    public static string Frame(string child, string parent) => $"frame {child} with parent {parent}";

    public const string OwnParent = "is its own parent";
    public const string StampZero = "has a zero stamp";

    public static string SignalTwice(string signal) => $"signal {signal} occurs twice";
    public static string SignalValue(string signal, string value) => $"value of signal {signal} is {value}";

    public static string Norm(double norm, double tolerance) =>
        FormattableString.Invariant($"has a rotation with the norm {norm:0.#######}; it must be 1 within {tolerance}");
}
