using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>The codes found in one picture.</summary>
/// <param name="Width">Width, px; 0 if the picture could not be read.</param>
/// <param name="Height">Height, px; 0 if the picture could not be read.</param>
/// <param name="Codes">All codes, best match first. There can be several of a kind.</param>
/// <param name="Fault">Reason why the picture could not be read; null if it was read.</param>
sealed record SeenPicture(int Width, int Height, IReadOnlyList<FoundCode> Codes, string Fault)
{
    /// <summary>Whether the picture contains no codes but mirror images of codes.</summary>
    public bool IsMirrored { get; init; }

    public static SeenPicture Not(string fault) => new(0, 0, [], fault);

    public IReadOnlyList<FoundCode> CodesOf(CodeKind kind) => [.. Codes.Where(code => code.Kind == kind)];
}
