namespace Nowpose.Cli.Sessions;

/// <summary>A received message of joint positions.</summary>
/// <param name="Positions">rad or m, one per name.</param>
/// <param name="Velocities">rad/s or m/s, one per name, NaN if absent; null if all are unknown.</param>
/// <param name="Accelerations">rad/s² or m/s², in the same form.</param>
/// <param name="Dropped">The reason why the session dropped it; null if it was used.</param>
/// <param name="ControlArrival">Arrival time at the gateway that recorded it; null in a headset's recording.</param>
sealed record SampleLine(
    HeadsetTime Arrival, ControlTime Stamp, string[] Names, double[] Positions, double[] Velocities, double[] Accelerations,
    string Dropped, ControlTime? ControlArrival = null) : SessionLine;
