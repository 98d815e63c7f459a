namespace Nowpose.Gateway.Clock;

/// <summary>A contradiction between the control clock and the stamps of sources, or between the control clock and the system clock.</summary>
/// <param name="Reason">The fault, as one clause.</param>
/// <param name="Remedy">Instructions for the operator, as one or more sentences.</param>
/// <param name="IsContradiction">Whether the fault makes samples unusable.</param>
sealed record StampWarning(string Reason, string Remedy, bool IsContradiction)
{
    public string Text => $"{Reason}. {Remedy}";
}
