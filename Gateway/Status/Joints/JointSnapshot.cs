namespace Nowpose.Gateway.Status.Joints;

/// <summary>The state of one joint of one source at an instant.</summary>
/// <param name="Age">Control time minus the newest sample's stamp; null before the first sample.</param>
/// <param name="RateHz">Samples per second; 0 after the samples have stopped.</param>
/// <param name="Reason">The reason for the state as one sentence; empty for a live joint.</param>
readonly record struct JointSnapshot(
    string Name, string Source, JointDataState State, DateTimeOffset Since, TimeSpan? Age, double RateHz, string Reason)
{
    /// <summary>The reason why a joint assumed at rest may not be at rest; empty if there is none.</summary>
    public string Uncertainty { get; init; } = "";

    /// <summary>Namespace of the joint's robot; empty if it has none, null before the first sample.</summary>
    public string Robot { get; init; }

    /// <summary>One of <see cref="JointFaultReasons"/>; null for a joint that is live or at rest.</summary>
    public string ReasonWord { get; init; }

    public bool IsGood => State.IsGood();
    public string Word => JointDataStates.Of(State);
}
