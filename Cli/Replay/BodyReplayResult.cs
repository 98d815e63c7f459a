namespace Nowpose.Cli.Replay;

/// <summary>The result of the replay of a rigid body.</summary>
/// <param name="File">Path of the recording. For an object of a session, the name of its frame.</param>
/// <param name="Frames">Number of scored frames.</param>
/// <param name="Position">Distance between the displayed and the true position, mm.</param>
/// <param name="Rotation">Angle between the displayed and the true rotation, degrees.</param>
public sealed record BodyReplayResult(
    string File, string Predictor, int Frames, ErrorComparison Position, ErrorComparison Rotation)
{
    /// <summary>Position errors of each pass over a motion, mm; empty for a session.</summary>
    public IReadOnlyList<PassRms> Passes { get; init; } = [];

    /// <summary>Errors of the poses that the session displayed; null if they are not recorded, or their truth is unknown.</summary>
    public (ErrorComparison Position, ErrorComparison Rotation)? Displayed { get; init; }
}
