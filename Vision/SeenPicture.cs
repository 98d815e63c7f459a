using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>The codes found in one picture.</summary>
/// <param name="Width">Width, px; 0 if it could not be read, like the height.</param>
/// <param name="Height">Height, px.</param>
/// <param name="Codes">At most one of each kind.</param>
/// <param name="Fault">The reason why it could not be read; null if it could.</param>
sealed record SeenPicture(int Width, int Height, IReadOnlyList<FoundCode> Codes, string Fault)
{
    /// <summary>Gets the code of a kind; null if there is none.</summary>
    internal FoundCode CodeOf(CodeKind kind) => Codes.FirstOrDefault(code => code.Kind == kind);
}
