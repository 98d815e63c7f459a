namespace Nowpose.Gateway.Clock;

/// <summary>A contradiction between the control clock and the stamps of sources, or between the control clock and the system clock.</summary>
/// <param name="Reason">One clause.</param>
/// <param name="Remedy">One or more sentences.</param>
/// <param name="IsContradiction">Whether samples cannot be used because of it.</param>
sealed record StampWarning(string Reason, string Remedy, bool IsContradiction)
{
    public string Text => $"{Reason}. {Remedy}";
}
