using Nowpose.Benchmarks.Comparison;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>Errors of a variant divided by those of the whole predictor.</summary>
readonly record struct ErrorRatios(double Mean, double Max)
{
    public ErrorRatios(double[] errors, double[] whole) : this([.. errors.Zip(whole, (error, of) => error / of)]) { }

    ErrorRatios(double[] ratios) : this(Means.Geometric(ratios), ratios.Max()) { }

    /// <summary>Geometric mean and (maximum), as in tables.</summary>
    public override string ToString() => FormattableString.Invariant($"{Mean:0.000} ({Max:0.00})");
}
