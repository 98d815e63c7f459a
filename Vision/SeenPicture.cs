using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>What was seen in one picture.</summary>
/// <param name="Width">px; 0 where it could not be read, as the height.</param>
/// <param name="Height">px.</param>
/// <param name="Codes">At most one of each kind.</param>
/// <param name="Fault">Why it could not be read; null when it could.</param>
sealed record SeenPicture(int Width, int Height, IReadOnlyList<FoundCode> Codes, string Fault)
{
    /// <summary>Null when there is none of that kind.</summary>
    internal FoundCode CodeOf(CodeKind kind) => Codes.FirstOrDefault(code => code.Kind == kind);
}
