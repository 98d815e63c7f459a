namespace Nowpose.Gateway.Messages;

/// <summary>Descriptions of faults in messages about frames and signals. The name of the frame or signal precedes them.</summary>
static class CellMessageFaults
{
    /// <param name="kind">frame or signal.</param>
    public static string Named(string kind, string name) => $"{kind} {InputException.OneLine(name, ProtocolLimits.NameLength)}";

    public static string Frame(string child, string parent) => $"{Named("frame", child)} with parent {InputException.OneLine(parent, ProtocolLimits.NameLength)}";

    /// <param name="what">The frame or signal.</param>
    public static string Of(string what, DropReason reason) => $"{what} {DropMessages.Of(reason)}";

    public const string StampZero = "has a zero stamp";

    public const string NoName = "without a valid name";
    public const string Twice = "occurs twice";

    public static string Has(string field, string value) => $"has the {field} {value}";

    /// <param name="value">Value of a signal.</param>
    public static string NotANumber(string value) => $"has the value {value}; it must be a number, and 0 or 1 for a Boolean";
}
