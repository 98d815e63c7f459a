using Microsoft.CodeAnalysis.Text;

namespace Nowpose.Benchmarks.Sensitivity;

/// <summary>A numeric constant in the source code.</summary>
/// <param name="Name">Class and name, such as <c>Mixture.TimeConstant</c>.</param>
/// <param name="Place">Place of the value's expression in the file.</param>
/// <param name="Type">Keyword of the type.</param>
sealed record SourceConstant(string Name, string Path, TextSpan Place, string Type, double Value)
{
    /// <summary>Returns an expression for the constant's value multiplied by a factor.</summary>
    /// <param name="expression">The expression in the source code.</param>
    /// <remarks>For values between 0.9 and 1, such as forgetting factors, the distance from 1 is multiplied.</remarks>
    public string Scaled(string expression, double factor) => Value is > 0.9 and < 1
        ? FormattableString.Invariant($"({Type})(1 - (1 - ({expression})) * {factor})")
        : FormattableString.Invariant($"({Type})(({expression}) * {factor})");
}
