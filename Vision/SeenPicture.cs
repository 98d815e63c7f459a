using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>The codes found in one picture.</summary>
/// <param name="Width">Width, px; 0 if it could not be read, like the height.</param>
/// <param name="Height">Height, px.</param>
/// <param name="Codes">All codes, the clearest first; several of a kind if several are in view.</param>
/// <param name="Fault">The reason why it could not be read; null if it could.</param>
sealed record SeenPicture(int Width, int Height, IReadOnlyList<FoundCode> Codes, string Fault)
{
    /// <summary>Whether there are no codes, but mirror images of codes.</summary>
    public bool IsMirrored { get; init; }

    public static SeenPicture Not(string fault) => new(0, 0, [], fault);

    public IReadOnlyList<FoundCode> CodesOf(CodeKind kind) => [.. Codes.Where(code => code.Kind == kind)];
}
