namespace Nowpose.Gateway.Options;

/// <summary>From one length to another, ms; written as it is typed.</summary>
public readonly record struct MillisecondRange(double Min, double Max)
{
    public override string ToString() => FormattableString.Invariant($"{Min}-{Max}");
}
