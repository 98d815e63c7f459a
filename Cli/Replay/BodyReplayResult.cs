namespace Nowpose.Cli.Replay;

/// <summary>The result of the replay of a rigid body.</summary>
/// <param name="File">Path of the recording. For an object of a session, the name of its frame.</param>
/// <param name="Frames">Number of scored frames.</param>
/// <param name="Position">Distance between the displayed and the true position, mm.</param>
/// <param name="Rotation">Angle between the displayed and the true rotation, degrees.</param>
public sealed record BodyReplayResult(
    string File, string Predictor, int Frames, BodyReplayResult.ErrorSize Position, BodyReplayResult.ErrorSize Rotation)
{
    /// <summary>Errors of the poses that the session displayed; null if they are not recorded, or their truth is unknown.</summary>
    public (ErrorSize Position, ErrorSize Rotation)? Displayed { get; init; }

    /// <summary>Errors of hold (RMS) and of the prediction (RMS, P95, maximum).</summary>
    public readonly record struct ErrorSize(double RmsHold, double Rms, double P95, double Max)
    {
        /// <summary>1 − rms / rms_hold; null if hold has no error.</summary>
        public double? Reduction => RmsHold == 0 ? null : 1 - Rms / RmsHold;
    }
}
